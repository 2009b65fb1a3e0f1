#include "app/pair_arithmetic.h"

#include <algorithm>

#include "app/bench.h"
#include "app/pair_blocks.h"
#include "renderer/base/random.h"
#include "renderer/base/threads.h"

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace gbl {
namespace {

// Numbers near 0 become 0, as on GPUs: a highlight's tail would take a hundred cycles each.
void flush_small_numbers() {
#if defined(__x86_64__)
  constexpr unsigned kResultsAndArguments = 0x8040;
  _mm_setcsr(_mm_getcsr() | kResultsAndArguments);
#endif
}

float between(Pcg32& random, double low, double high) { return static_cast<float>(random.in(low, high)); }

// A wall of pixels before the camera and lights that reach all of it.
std::vector<PairPixels> some_pixels(Pcg32& random, int blocks) {
  std::vector<PairPixels> out(static_cast<size_t>(blocks));
  for (PairPixels& p : out)
    for (int k = 0; k < kLanes; ++k) {
      for (auto& row : p.position) row[k] = between(random, -5, 5);
      for (auto& row : p.normal) row[k] = between(random, -0.5, 0.5);
      for (auto& row : p.f0) row[k] = between(random, 0, 1);
      p.exponent[k] = between(random, 1, 500), p.roughness[k] = between(random, 0.1, 1);
    }
  return out;
}
std::vector<PairLight> some_lights(Pcg32& random, int count) {
  std::vector<PairLight> out(static_cast<size_t>(count));
  for (PairLight& l : out) {
    for (float& x : l.position) x = between(random, -5, 5);
    for (float& x : l.colour) x = between(random, 0.5, 1.5);
    l.range = l.profile = 100;
  }
  return out;
}

}  // namespace

std::optional<double> arithmetic_ns_per_pair(ShadingModel model, Attenuation attenuation, int lights, int blocks) {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return {};
#else
  return {};
#endif
  const PairLoop loop = pair_loop(static_cast<int>(model), static_cast<int>(attenuation));
  if (!loop) return {};
  Pcg32 random(1);
  const std::vector<PairPixels> pixels = some_pixels(random, blocks);
  const std::vector<PairLight> all = some_lights(random, lights);
  std::vector<PairSums> sums(pixels.size());
  const int threads = all_processors();
  double best_s = 1e9;
  constexpr int kRuns = 5;
  for (int run = 0; run < kRuns; ++run) {
    const double begin = now_s();
    on_threads(threads, [&](int t) {
      flush_small_numbers();
      for (size_t i = static_cast<size_t>(t); i < pixels.size(); i += static_cast<size_t>(threads))
        loop(pixels[i], all.data(), lights, sums[i]);
    });
    best_s = std::min(best_s, now_s() - begin);
  }
  return best_s * 1e9 / (double(lights) * blocks * kLanes);
}

}  // namespace gbl
