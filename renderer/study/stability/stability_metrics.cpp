// The numbers of sweeps that a column of Errors does not hold.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/base/error.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/gbuffer/position_source.h"
#include "renderer/light/lights.h"
#include "renderer/study/stability/stability.h"

namespace gbl {
namespace {

constexpr double kSeen = 1.0 / 255;

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

std::optional<double> lost_share(const SweepSetup&, const Measured& m) {
  const double lit = lit_pixels(*m.truth);
  return lit > 0 && m.errors.lost_pixels ? std::optional(*m.errors.lost_pixels / lit) : std::nullopt;
}

std::optional<double> wrong_light_share(const SweepSetup&, const Measured& m) {
  const double lit = lit_pixels(*m.truth);
  if (!(lit > 0) || !m.errors.lost_pixels || !m.errors.doubled_pixels) return std::nullopt;
  return (*m.errors.lost_pixels + *m.errors.doubled_pixels) / lit;
}

// Both signs count: a format may add too much as well as too little.
std::optional<double> mean_off(const SweepSetup&, const Measured& m) {
  double sum = 0;
  size_t pixels = 0;
  for (size_t i = 0; i < m.truth->pixels(); ++i)
    if (m.truth->present[i]) sum += (m.truth->lit[i].x + m.truth->lit[i].y + m.truth->lit[i].z) / 3, ++pixels;
  if (!(sum > 0) || !m.errors.signed_mean_linear) return std::nullopt;
  return std::abs(*m.errors.signed_mean_linear) / (sum / static_cast<double>(pixels));
}

// The largest difference between neighbouring pixels of which the first light reaches one and not the other, as drawn: a
// renderer that does not end its lights there shows none.
struct RimStep {
  const Truth& truth;
  const std::vector<glm::vec3>& lit;
  Display display;
  glm::dvec3 light;  // relative to the camera
  double range;
  double step = 0;

  bool reached(size_t i) const { return glm::distance(truth.position[i], light) < range; }
  void compare(size_t i, size_t j) {
    if (!truth.present[i] || !truth.present[j] || reached(i) == reached(j)) return;
    const glm::dvec3 d = displayed(display, glm::dvec3(lit[i])) - displayed(display, glm::dvec3(lit[j]));
    step = std::max(step, 255 * largest(glm::abs(d)));
  }
};

std::optional<double> rim_step(const SweepSetup& setup, const Measured& m) {
  const Settings& s = setup.settings;
  const std::vector<Light> lights = lights_of(s, *setup.scene);
  if (lights.empty() || m.drawn.lit.size() != m.truth->pixels()) return std::nullopt;
  RimStep rim{
      *m.truth, m.drawn.lit, {s.exposure, s.colour}, lights.front().position - s.camera.position, lights.front().range};
  const auto width = static_cast<size_t>(m.truth->size.x), height = static_cast<size_t>(m.truth->size.y);
  for (size_t y = 0; y < height; ++y)
    for (size_t x = 0; x < width; ++x) {
      if (x > 0) rim.compare(y * width + x, y * width + x - 1);
      if (y > 0) rim.compare(y * width + x, (y - 1) * width + x);
    }
  return rim.step;
}

// The distance that the lighting reads beside the one that the stored depth means: what the format has lost is in both,
// so that what is left is the shader's own arithmetic.
std::optional<double> decode_off(const SweepSetup& setup, const Measured& m) {
  const Settings& s = setup.settings;
  if (s.position.source != PositionSource::depth || m.drawn.depth.size() != m.drawn.position.size()) return {};
  const glm::dvec3 forward = view_rays(s.camera, 1).forward;
  double off = 0;
  for (size_t i = 0; i < m.truth->pixels(); ++i) {
    if (!m.truth->present[i]) continue;
    const double meant = range_from_depth(s.camera, m.drawn.depth[i], depth_runs(s.depth.format));
    off = std::max(off, std::abs(glm::dot(glm::dvec3(m.drawn.position[i]), forward) / meant - 1));
  }
  return off;
}

// The brightest pixel as drawn and as it should be, from 0 to 255: what the eye follows while the camera moves.
std::optional<double> peak_off(const SweepSetup& setup, const Measured& m) {
  const Display display{setup.settings.exposure, setup.settings.colour};
  double drawn = 0, meant = 0;
  for (size_t i = 0; i < m.truth->pixels(); ++i) {
    if (!m.truth->present[i]) continue;
    drawn = std::max(drawn, largest(displayed(display, glm::dvec3(m.drawn.lit[i]))));
    meant = std::max(meant, largest(displayed(display, m.truth->lit[i])));
  }
  return 255 * (drawn - meant);
}

constexpr SweepMetric kOwn[] = {
    {"lost_share", "", "share of the lit pixels with less than half their light", lost_share},
    {"wrong_light_share", "",
     "share of the lit pixels with less than half or more than one and a half times their light", wrong_light_share},
    {"mean_off", "", "mean difference over the true mean, without its sign", mean_off},
    {"rim_step", "codes of 255", "largest step across the first light's rim, as displayed", rim_step},
    {"peak_off", "codes of 255", "brightest pixel as drawn less the brightest of the truth, as displayed", peak_off},
    {"decode_off", "",
     "largest relative difference between the distance that the lighting reads and the one that the stored depth means",
     decode_off},
};

std::vector<SweepMetric> make_metrics() {
  std::vector<SweepMetric> out(std::begin(kOwn), std::end(kOwn));
  for (const ErrorColumn& c : error_columns()) out.push_back({c.id, c.unit, c.help, nullptr});
  return out;
}

}  // namespace

double lit_pixels(const Truth& truth) {
  size_t lit = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) lit += truth.present[i] && largest(truth.light(i)) > kSeen;
  return static_cast<double>(lit);
}

std::span<const SweepMetric> sweep_metrics() {
  static const std::vector<SweepMetric> metrics = make_metrics();
  return metrics;
}

const SweepMetric& sweep_metric(std::string_view id) {
  std::vector<std::string_view> known;
  for (const SweepMetric& m : sweep_metrics()) {
    if (m.id == id) return m;
    known.emplace_back(m.id);
  }
  throw Error(ExitCode::bad_input, "metric", "unknown metric", suggest(id, known));
}

std::optional<double> value_of(const SweepMetric& metric, const SweepSetup& setup, const Measured& m) {
  if (metric.value) return metric.value(setup, m);
  for (const ErrorColumn& c : error_columns())
    if (std::string_view(c.id) == metric.id) return m.errors.*c.value;
  assert(!"every metric without a function is a column");
  return std::nullopt;
}

}  // namespace gbl
