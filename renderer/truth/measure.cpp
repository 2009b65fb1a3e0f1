#include "renderer/truth/measure.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/truth/colour_spaces.h"
#include "renderer/truth/flip.h"
#include "renderer/truth/pixel_maths.h"
#include "renderer/truth/tally.h"
#include "renderer/truth/ties.h"

namespace gbl {
namespace {

constexpr double kCode = 1.0 / 255;   // one step of an 8-bit screen
constexpr double kRelmseDark = 0.01;  // keeps the relative error of black finite; other tools take other values

// clang-format off
constexpr ErrorColumn kColumns[] = {
    {"over_1_255_display", "", "share of pixels off by more than 1/255 as displayed", &Errors::over_1_255_display, ErrorKind::share},
    {"over_half_255_display", "", "share of pixels off by more than 0.5/255 as displayed", &Errors::over_half_255_display, ErrorKind::share},
    {"over_1_255_linear", "", "share of pixels off by more than 1/255 of radiance", &Errors::over_1_255_linear, ErrorKind::share},
    {"max_linear", "radiance", "largest difference of a channel; ties are left out", &Errors::max_linear},
    {"p99_linear", "radiance", "difference of the channel that is off most, 99th percentile", &Errors::p99_linear},
    {"rmse_linear", "radiance", "root mean square", &Errors::rmse_linear},
    {"mae_linear", "radiance", "mean absolute difference", &Errors::mae_linear},
    {"signed_mean_linear", "radiance", "mean difference: dark is negative", &Errors::signed_mean_linear, ErrorKind::bias},
    {"relmse_linear", "", "mean squared difference over squared radiance + 0.01", &Errors::relmse_linear},
    {"psnr_display", "dB", "peak signal-to-noise ratio as displayed", &Errors::psnr_display, ErrorKind::quality},
    {"flip_mean", "", "mean perceptual difference (Andersson et al. 2020)", &Errors::flip_mean},
    {"normal_deg_mean", "degrees", "angle to the true normal, mean", &Errors::normal_deg_mean},
    {"normal_deg_p50", "degrees", "angle to the true normal, median", &Errors::normal_deg_p50},
    {"normal_deg_p99", "degrees", "angle to the true normal, 99th percentile", &Errors::normal_deg_p99},
    {"normal_deg_max", "degrees", "angle to the true normal, largest; ties are left out", &Errors::normal_deg_max},
    {"position_mean", "units", "distance to the true point, mean", &Errors::position_mean},
    {"position_p99", "units", "distance to the true point, 99th percentile", &Errors::position_p99},
    {"position_max", "units", "distance to the true point, largest; ties are left out", &Errors::position_max},
    {"nonfinite_pixels", "", "pixels with NaN or infinity", &Errors::nonfinite_pixels},
    {"lost_pixels", "", "pixels with less than half their light", &Errors::lost_pixels},
    {"doubled_pixels", "", "pixels with more than one and a half times their light", &Errors::doubled_pixels},
    {"shadow_lit_pixels", "", "pixels that are lit although something hides the light: too bright by a quarter of what would arrive", &Errors::shadow_lit_pixels},
    {"shadow_dark_pixels", "", "pixels that are dark although nothing hides the light: too dark by a quarter of what would arrive", &Errors::shadow_dark_pixels},
    {"shadow_wrong_pixels", "", "the sum of both", &Errors::shadow_wrong_pixels},
    {"shadow_edge_pixels", "pixels", "wrong pixels for each pixel along the edges of true shadows: where nothing else is wrong, how far edges are off", &Errors::shadow_edge_pixels},
    {"background_lit_pixels", "", "pixels without a surface that are lit", &Errors::background_lit_pixels},
    {"background_off_pixels", "", "pixels without a surface that are brighter or darker than the background", &Errors::background_off_pixels},
    {"tie_pixels", "", "pixels at an edge, within 1/16 pixel, where frame and reference see different surfaces", &Errors::tie_pixels, ErrorKind::basis},
    {"blended_pixels", "", "pixels drawn forward after the lighting, glass and light cubes: in `final`, and not judged", &Errors::blended_pixels, ErrorKind::basis},
    {"compared_pixels", "", "pixels with a surface: those that are judged", &Errors::compared_pixels, ErrorKind::basis},
};
// clang-format on

std::optional<double> share(size_t count, size_t of) {
  return of == 0 ? std::nullopt : std::optional(static_cast<double>(count) / static_cast<double>(of));
}

size_t count_compared(const Truth& truth) {
  size_t count = 0;
  for (const uint8_t present : truth.present) count += present != 0;
  return count;
}

// Of each pixel, whether it is a tie.
class Ties {
 public:
  Ties(const Truth& truth, const std::vector<SeenSurface>& seen) {
    for (size_t i = 0; i < seen.size(); ++i) ties_.push_back(truth.present[i] && is_tie(truth, i, seen[i]));
  }
  bool at(size_t pixel) const { return !ties_.empty() && ties_[pixel]; }
  std::optional<double> count() const {
    if (ties_.empty()) return std::nullopt;
    return static_cast<double>(std::count(ties_.begin(), ties_.end(), true));
  }

 private:
  std::vector<bool> ties_;  // empty: what the frame shows is not known, so none is excused
};

// ---- lit, linear ----------------------------------------------------------------------------------------------------

void measure_radiance(Errors& e, const Truth& truth, const std::vector<glm::vec3>& lit, const Ties& ties) {
  Tally largest;
  Mean square, magnitude, with_sign, relative;
  size_t over = 0, compared = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    if (!truth.present[i]) continue;
    const glm::dvec3 d = glm::dvec3(lit[i]) - truth.lit[i];
    const double most = largest_magnitude(d);
    ++compared, over += most > kCode;
    largest.add(most, ties.at(i));
    for (int k = 0; k < 3 && finite(d); ++k) {
      square.add(d[k] * d[k]), magnitude.add(std::abs(d[k])), with_sign.add(d[k]);
      relative.add(d[k] * d[k] / (truth.lit[i][k] * truth.lit[i][k] + kRelmseDark));
    }
  }
  e.over_1_255_linear = share(over, compared);
  e.max_linear = largest.max(), e.p99_linear = largest.percentile(0.99);
  e.mae_linear = magnitude.value(), e.signed_mean_linear = with_sign.value(), e.relmse_linear = relative.value();
  if (square.value()) e.rmse_linear = std::sqrt(*square.value());
}

void count_nonfinite_and_background(Errors& e, const Truth& truth, const std::vector<glm::vec3>& lit) {
  size_t nonfinite = 0, background_lit = 0, background_off = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    const glm::dvec3 more = glm::dvec3(lit[i]) - truth.lit[i];
    nonfinite += !finite(lit[i]);
    background_lit += !truth.present[i] && (more.x > kCode || more.y > kCode || more.z > kCode);
    background_off += !truth.present[i] && largest_magnitude(more) > kCode;
  }
  e.nonfinite_pixels = static_cast<double>(nonfinite), e.background_lit_pixels = static_cast<double>(background_lit);
  e.background_off_pixels = static_cast<double>(background_off);
}

// What is shown there is not what was lit.
double count_blended(const Drawn& drawn) {
  size_t blended = 0;
  for (size_t i = 0; i < drawn.lit.size(); ++i)
    blended += finite(drawn.lit[i]) && finite(drawn.shown[i]) && drawn.shown[i] != drawn.lit[i];
  return static_cast<double>(blended);
}

// ---- lit, as displayed ----------------------------------------------------------------------------------------------

// What the screen shows; black where there is no number to show.
template <class Vec>
std::vector<glm::dvec3> shown(const Display& display, const std::vector<Vec>& radiance) {
  std::vector<glm::dvec3> out;
  out.reserve(radiance.size());
  for (const Vec& r : radiance) out.push_back(finite(r) ? displayed(display, r) : glm::dvec3(0));
  return out;
}

void measure_display(Errors& e, const Truth& truth, const std::vector<glm::vec3>& lit, const Display& display) {
  const std::vector<glm::dvec3> expected = shown(display, truth.lit), got = shown(display, lit);
  const std::vector<double> map = flip(truth.size, expected, got);
  Mean square, perceived;
  size_t over = 0, over_half = 0, compared = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    if (!truth.present[i]) continue;
    const glm::dvec3 d = got[i] - expected[i];
    const bool known = finite(glm::dvec3(lit[i]) - truth.lit[i]);
    const double most = known ? largest_magnitude(d) : 1;  // 1: a screen cannot be further off
    ++compared, over += most > kCode, over_half += most > kCode / 2;
    perceived.add(known ? map[i] : 1);
    for (int k = 0; k < 3 && known; ++k) square.add(d[k] * d[k]);
  }
  e.over_1_255_display = share(over, compared), e.over_half_255_display = share(over_half, compared);
  e.flip_mean = perceived.value();
  if (square.value()) e.psnr_display = -10 * std::log10(*square.value());  // infinite when equal
}

// ---- light alone ----------------------------------------------------------------------------------------------------

// By the channel that should be brightest; where no light should arrive, by the one that is. Pixels that are not finite
// stand in nonfinite_pixels.
void count_lost_and_doubled(Errors& e, const Truth& truth, const Drawn& drawn) {
  size_t lost = 0, doubled = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    if (!truth.present[i]) continue;
    const glm::dvec3 expected = truth.light(i), got = glm::dvec3(drawn.lit[i]) - glm::dvec3(drawn.unlit[i]);
    if (!finite(got)) continue;
    const int k = largest_channel(expected == glm::dvec3(0) ? got : expected);
    lost += expected[k] > kCode && got[k] < 0.5 * expected[k];
    doubled += got[k] > kCode && got[k] > 1.5 * expected[k] && got[k] - expected[k] > kCode;
  }
  e.lost_pixels = static_cast<double>(lost), e.doubled_pixels = static_cast<double>(doubled);
}

// Pixels at which a true shadow ends: of what would arrive, a quarter more or less does than at the next pixel.
size_t count_shadow_edges(const Truth& truth) {
  constexpr double kShare = 0.25;
  const auto arrives = [&](size_t i) -> std::optional<double> {
    if (!truth.present[i]) return {};
    const int k = largest_channel(truth.unshadowed[i]);
    const double all = truth.unshadowed[i][k];
    return all > kCode ? std::optional(truth.light(i)[k] / all) : std::nullopt;
  };
  const auto width = static_cast<size_t>(truth.size.x);
  size_t edges = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    const std::optional<double> here = arrives(i);
    const auto ends_towards = [&](size_t j) {
      const std::optional<double> there = arrives(j);
      return there && std::abs(*there - *here) > kShare;
    };
    if (!here) continue;
    edges += ((i + 1) % width != 0 && ends_towards(i + 1)) || (i + width < truth.pixels() && ends_towards(i + width));
  }
  return edges;
}

// By the channel that is brightest without shadows.
void count_wrong_shadows(Errors& e, const Truth& truth, const Drawn& drawn) {
  constexpr double kShare = 0.25;  // of what would arrive
  size_t lit = 0, dark = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    const glm::dvec3 got = glm::dvec3(drawn.lit[i]) - glm::dvec3(drawn.unlit[i]);
    if (!truth.present[i] || !finite(got)) continue;
    const int k = largest_channel(truth.unshadowed[i]);
    const double all = truth.unshadowed[i][k], off = got[k] - truth.light(i)[k];
    if (!(all > kCode)) continue;
    lit += off > kShare * all, dark += off < -kShare * all;
  }
  e.shadow_lit_pixels = static_cast<double>(lit), e.shadow_dark_pixels = static_cast<double>(dark);
  e.shadow_wrong_pixels = static_cast<double>(lit + dark);
  e.shadow_edge_pixels = *e.shadow_wrong_pixels / static_cast<double>(std::max<size_t>(count_shadow_edges(truth), 1));
}

// ---- attributes -----------------------------------------------------------------------------------------------------

// atan2, since acos of a dot product near 1 loses all angles below 1e-6 degrees and most digits of those above. A
// normal that is no direction is as wrong as can be.
double normal_error_deg(const glm::dvec3& normal, const glm::dvec3& expected) {
  if (!finite(normal) || normal == glm::dvec3(0)) return 180;
  return glm::degrees(std::atan2(glm::length(glm::cross(normal, expected)), glm::dot(normal, expected)));
}

void measure_normals(Errors& e, const Truth& truth, const std::vector<glm::vec3>& normal, const Ties& ties) {
  Tally angles_deg;
  for (size_t i = 0; i < truth.pixels(); ++i)
    if (truth.present[i]) angles_deg.add(normal_error_deg(normal[i], truth.normal[i]), ties.at(i));
  e.normal_deg_mean = angles_deg.mean(), e.normal_deg_max = angles_deg.max();
  e.normal_deg_p50 = angles_deg.percentile(0.5), e.normal_deg_p99 = angles_deg.percentile(0.99);
}

void measure_positions(Errors& e, const Truth& truth, const std::vector<glm::vec3>& position, const Ties& ties) {
  Tally distances;
  for (size_t i = 0; i < truth.pixels(); ++i)
    if (truth.present[i]) distances.add(glm::length(glm::dvec3(position[i]) - truth.position[i]), ties.at(i));
  e.position_mean = distances.mean(), e.position_p99 = distances.percentile(0.99), e.position_max = distances.max();
}

}  // namespace

std::span<const ErrorColumn> error_columns() { return kColumns; }

glm::dvec3 displayed(const Display& display, const glm::dvec3& radiance) {
  const glm::dvec3 clamped = glm::clamp(display.exposure * radiance, 0.0, 1.0);
  return display.colour == Colour::srgb ? srgb_from_linear(clamped) : clamped;
}

Errors measure(const Truth& truth, const Drawn& drawn, const Display& display) {
  for ([[maybe_unused]] const auto* list : {&drawn.lit, &drawn.unlit, &drawn.normal, &drawn.position})
    assert(list->empty() || list->size() == truth.pixels());
  assert(drawn.seen.empty() || drawn.seen.size() == truth.pixels());
  const Ties ties(truth, drawn.seen);
  Errors e;
  e.tie_pixels = ties.count();
  const size_t compared = count_compared(truth);
  e.compared_pixels = static_cast<double>(compared);
  if (!drawn.lit.empty()) {
    count_nonfinite_and_background(e, truth, drawn.lit);
    if (compared > 0) measure_radiance(e, truth, drawn.lit, ties), measure_display(e, truth, drawn.lit, display);
    if (compared > 0 && !drawn.unlit.empty()) count_lost_and_doubled(e, truth, drawn);
    if (compared > 0 && !drawn.unlit.empty() && !truth.unshadowed.empty()) count_wrong_shadows(e, truth, drawn);
  }
  if (!drawn.shown.empty()) e.blended_pixels = count_blended(drawn);
  if (!drawn.normal.empty()) measure_normals(e, truth, drawn.normal, ties);
  if (!drawn.position.empty()) measure_positions(e, truth, drawn.position, ties);
  return e;
}

}  // namespace gbl
