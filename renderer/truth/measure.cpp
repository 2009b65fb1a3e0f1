#include "renderer/truth/measure.h"

namespace gbl {
namespace {

// clang-format off
constexpr ErrorColumn kColumns[] = {
    {"over_1_255_display", "", "share of pixels whose largest channel is off by more than 1/255 as displayed", &Errors::over_1_255_display},
    {"over_half_255_display", "", "the same for 0.5/255", &Errors::over_half_255_display},
    {"over_1_255_linear", "", "the same for 1/255 of linear radiance", &Errors::over_1_255_linear},
    {"max_linear", "radiance", "largest difference of a channel", &Errors::max_linear},
    {"p99_linear", "radiance", "99th percentile of it", &Errors::p99_linear},
    {"rmse_linear", "radiance", "root mean square", &Errors::rmse_linear},
    {"mae_linear", "radiance", "mean absolute difference", &Errors::mae_linear},
    {"signed_mean_linear", "radiance", "mean difference: dark is negative", &Errors::signed_mean_linear},
    {"relmse_linear", "", "mean squared difference over squared radiance + 0.01", &Errors::relmse_linear},
    {"psnr_display", "dB", "peak signal-to-noise ratio as displayed", &Errors::psnr_display},
    {"flip_mean", "", "mean perceptual difference (Andersson et al. 2020)", &Errors::flip_mean},
    {"normal_deg_mean", "degrees", "angle to the true normal, mean", &Errors::normal_deg_mean},
    {"normal_deg_p50", "degrees", "median", &Errors::normal_deg_p50},
    {"normal_deg_p99", "degrees", "99th percentile", &Errors::normal_deg_p99},
    {"normal_deg_max", "degrees", "largest", &Errors::normal_deg_max},
    {"position_mean", "units", "distance to the true point, mean", &Errors::position_mean},
    {"position_p99", "units", "99th percentile", &Errors::position_p99},
    {"position_max", "units", "largest", &Errors::position_max},
    {"nonfinite_pixels", "", "pixels with NaN or infinity", &Errors::nonfinite_pixels},
    {"lost_pixels", "", "pixels with less than half their light", &Errors::lost_pixels},
    {"doubled_pixels", "", "pixels with more than one and a half times their light", &Errors::doubled_pixels},
    {"background_lit_pixels", "", "pixels without a surface that are lit", &Errors::background_lit_pixels},
    {"compared_pixels", "", "pixels with a surface: those that are judged", &Errors::compared_pixels},
};
// clang-format on

}  // namespace

std::span<const ErrorColumn> error_columns() { return kColumns; }

}  // namespace gbl
