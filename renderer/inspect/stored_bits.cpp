#include "renderer/inspect/stored_bits.h"

#include <algorithm>
#include <fmt/format.h>
#include <glm/gtc/packing.hpp>

#include "renderer/gbuffer/normal_code.h"
#include "renderer/picture/srgb.h"

namespace gbl {
namespace {

uint32_t mask_of(int bits) { return bits == 32 ? ~0u : (1u << bits) - 1; }

struct FloatParts {
  int bits, exponent, fraction;  // a sign is what is left
};
constexpr FloatParts kFloats[] = {{32, 8, 23}, {16, 5, 10}, {11, 5, 6}, {10, 5, 5}};

int length(const BitRuns& code) {
  int bits = 0;
  for (const BitRun& r : code) bits += r.bits;
  return bits;
}

uint32_t code_of(const BitRuns& code, const StoredTexel& t) {
  uint32_t all = 0;
  for (const BitRun& r : code)
    all |= ((t.bits[static_cast<size_t>(r.channel)] >> r.first) & mask_of(r.bits)) << r.holds;
  return all;
}

double float_of(uint32_t code, int bits) {
  if (bits == 32) return glm::uintBitsToFloat(code);
  const int shorter =
      bits == 16 ? 0 : 15 - bits;  // 11 and 10 bits are a half float's without sign, its fraction cut short
  return glm::unpackHalf1x16(static_cast<uint16_t>(code << shorter));
}

// A float's sign, exponent and fraction stand apart, and the parts of a code that lie apart.
std::string binary_of(const BitRuns& runs, CodeKind kind, uint32_t code) {
  const int bits = length(runs);
  std::string text;
  const auto append = [&](int low, int count, char between) {
    if (!text.empty()) text += between;
    text += fmt::format("{:0{}b}", (code >> low) & mask_of(count), count);
  };
  if (kind == CodeKind::floating)
    for (const FloatParts& f : kFloats) {
      if (f.bits != bits) continue;
      if (bits > f.exponent + f.fraction) append(bits - 1, 1, ' ');
      append(f.fraction, f.exponent, ' ');
      append(0, f.fraction, ' ');
      return text;
    }
  std::for_each(runs.rbegin(), runs.rend(), [&](const BitRun& r) { append(r.holds, r.bits, '|'); });
  return text;
}

double number_of(const StoredField& f, uint32_t code, int bits) {
  if (f.kind == CodeKind::floating) return float_of(code, bits);
  return f.kind == CodeKind::share ? code / double(mask_of(bits)) : code;
}

std::vector<double> normal_of(const Settings& s, const FieldRead& r) {
  const EncodingRow& e = row_of(s.normal.encoding);
  glm::dvec3 code(0);
  for (size_t c = 0; c < r.codes.size(); ++c)
    code[static_cast<glm::length_t>(c)] = e.whole_codes() ? r.codes[c] : float_of(r.codes[c], e.bits_per_channel);
  glm::dvec3 n = normal_of_code(s.normal.encoding, code);
  if (s.normal.space == NormalSpace::view) n = s.camera.orientation * n;
  return {n.x, n.y, n.z};
}

void read_values(const Settings& s, FieldRead& r) {
  const StoredField& f = r.field;
  if (f.kind == CodeKind::normal) {
    r.values = normal_of(s, r);
    return;
  }
  for (size_t c = 0; c < r.codes.size(); ++c) {
    double number = number_of(f, r.codes[c], length(f.components[c]));
    if (f.srgb && s.colour == Colour::srgb) number = linear_from_srgb(number);
    r.values.push_back(number * f.scale + f.offset);
  }
}

std::string place_of(const StoredField& f, Format format) {
  const bool channels = row(format).channels > 1;
  std::string text;
  for (const BitRuns& code : f.components)
    for (auto r = code.rbegin(); r != code.rend(); ++r) {
      if (!text.empty()) text += r == code.rbegin() ? " " : "|";
      if (channels && r->channel != kPadding) text += "rgba"[r->channel];
      text += r->bits == 1 ? fmt::format("{}", r->first) : fmt::format("{}-{}", r->first, r->first + r->bits - 1);
    }
  return text;
}

}  // namespace

std::vector<FieldRead> read_fields(const Settings& s, const StoredTexel& t) {
  std::vector<FieldRead> out;
  for (StoredField& f : stored_fields(s, t.attachment, t.bits[0] >> 31 == 1)) {
    if (t.as_sampled && std::string_view(f.name) == "stencil") continue;
    FieldRead r{.field = std::move(f), .place = {}, .binary = {}, .codes = {}, .values = {}};
    r.place = place_of(r.field, t.attachment.format);
    for (const BitRuns& code : r.field.components)
      if (code[0].channel != kPadding) {
        r.codes.push_back(code_of(code, t));
        r.binary.push_back(binary_of(code, r.field.kind, r.codes.back()));
      }
    if (!r.codes.empty()) read_values(s, r);
    out.push_back(std::move(r));
  }
  return out;
}

}  // namespace gbl
