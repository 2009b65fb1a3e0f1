#pragma once
// How far a picture is from the truth: one number per column of a study. Pixels without a surface are left out of all
// columns but those of the background. Formulas: see the table in measure.cpp.
#include <optional>
#include <span>

#include "renderer/options/axes.h"
#include "renderer/truth/truth.h"

namespace gbl {

// From radiance to what the screen shows, in double: clamp(exposure * x, 0, 1), then sRGB (as-tutorial: as it is).
struct Display {
  double exposure = 1;
  Colour colour = Colour::srgb;
};
glm::dvec3 displayed(const Display&, const glm::dvec3& radiance);
// Of the largest channel, 0..1; infinite where the radiance is not finite.
double display_difference(const Display&, const glm::dvec3& radiance, const glm::dvec3& shown_truth);

// Empty: nothing to measure (no surface is seen, or the attachment is not stored). Non-finite pixels are counted in
// nonfinite_pixels; for shares they are over every bound, from means and percentiles they are left out (FLIP's mean
// takes 1, its largest, instead), and a maximum is infinite. A tie counts in everything but the maxima, where one such
// pixel would hide all others; one that is not finite counts there, too.
struct Errors {
  std::optional<double> over_1_255_display, over_half_255_display, over_1_255_linear;  // shares, 0..1
  std::optional<double> max_linear, p99_linear, rmse_linear, mae_linear, signed_mean_linear, relmse_linear;  // radiance
  std::optional<double> psnr_display;                                                     // dB; infinite when equal
  std::optional<double> flip_mean;                                                        // 0..1
  std::optional<double> normal_deg_mean, normal_deg_p50, normal_deg_p99, normal_deg_max;  // degrees
  std::optional<double> position_mean, position_p99, position_max;                        // world units
  std::optional<double> nonfinite_pixels, lost_pixels, doubled_pixels, background_lit_pixels, background_off_pixels;
  // Wrong by a shadow, and their sum: none where no light has one.
  std::optional<double> shadow_lit_pixels, shadow_dark_pixels, shadow_wrong_pixels;
  std::optional<double> shadow_edge_pixels;  // wrong ones for each along a true shadow's edge
  std::optional<double> blended_pixels;      // drawn forward after the lighting: not judged
  std::optional<double> tie_pixels;          // frame and reference see different surfaces at an edge (ties.h)
  std::optional<double> compared_pixels;     // with a surface
};

enum class ErrorKind {
  distance,  // from the truth: less is better
  share,     // of the compared pixels
  bias,      // with a sign; the nearer to 0 the better
  quality,   // more is better
  basis      // says how many were judged, not how
};

struct ErrorColumn {
  const char* id;
  const char* unit;  // "" = a share or a count
  const char* help;
  std::optional<double> Errors::*value;
  ErrorKind kind = ErrorKind::distance;
};
std::span<const ErrorColumn> error_columns();

Errors measure(const Truth&, const Drawn&, const Display&);

// Does a picture hold a bound? A pixel at which the witness (a float32 forward frame) itself is off by more than the
// bound is excused, and counted: there the GPU's float arithmetic, not the set-up, is to blame. Without a
// witness (empty) none is excused.
struct BoundCheck {
  size_t compared = 0, excused = 0, over = 0;  // pixels; `over` are those beyond the bound and not excused
  double worst = 0;                            // largest displayed difference of a pixel that is not excused
  glm::ivec2 worst_pixel{-1};                  // origin top left; -1: none compared
  double share_over() const { return compared == 0 ? 0 : double(over) / double(compared); }
};
// bound: of the largest channel's displayed difference, 0..1 (1/255 = one code).
BoundCheck check_bound(const Truth&, std::span<const glm::vec3> lit, std::span<const glm::vec3> witness_lit,
                       const Display&, double bound);

}  // namespace gbl
