#include "renderer/base/sha256.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

namespace gbl {
namespace {

constexpr size_t kBlock = 64, kLengthBytes = 8;
using Words = std::array<uint32_t, 8>;

bool prime(int n) {
  for (int d = 2; d * d <= n; ++d)
    if (n % d == 0) return false;
  return true;
}

// The first 32 bits behind the point of the roots of the first primes: what the standard's constants are.
template <size_t kCount, class Root>
std::array<uint32_t, kCount> bits_of_roots(Root root) {
  std::array<uint32_t, kCount> out{};
  size_t found = 0;
  for (int n = 2; found < kCount; ++n) {
    if (!prime(n)) continue;
    const long double r = root(static_cast<long double>(n));
    out[found++] = static_cast<uint32_t>(std::floor((r - std::floor(r)) * 4294967296.0L));
  }
  return out;
}

void add_block(Words& state, const unsigned char* block) {
  static const auto kRounds = bits_of_roots<64>([](long double n) { return std::cbrt(n); });
  std::array<uint32_t, 64> w{};
  for (size_t i = 0; i < 16; ++i)
    for (size_t byte = 0; byte < 4; ++byte) w[i] = w[i] << 8 | block[4 * i + byte];
  for (size_t i = 16; i < w.size(); ++i) {
    const uint32_t a = w[i - 15], b = w[i - 2];
    w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3) + w[i - 7] +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10);
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (size_t i = 0; i < w.size(); ++i) {
    const uint32_t chosen = (e & f) ^ (~e & g), most = (a & b) ^ (a & c) ^ (b & c);
    const uint32_t first = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + chosen + kRounds[i] + w[i];
    const uint32_t second = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + most;
    h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
  }
  const Words added{a, b, c, d, e, f, g, h};
  for (size_t i = 0; i < state.size(); ++i) state[i] += added[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
  std::string padded(bytes);
  padded += '\x80';
  while (padded.size() % kBlock != kBlock - kLengthBytes) padded += '\0';
  for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(uint64_t(bytes.size()) * 8 >> shift);
  Words state = bits_of_roots<8>([](long double n) { return std::sqrt(n); });
  for (size_t at = 0; at < padded.size(); at += kBlock)
    add_block(state, reinterpret_cast<const unsigned char*>(padded.data()) + at);
  std::string hex;
  for (const uint32_t word : state) hex += fmt::format("{:08x}", word);
  return hex;
}

}  // namespace gbl
