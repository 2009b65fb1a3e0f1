#include "renderer/study/pitfalls/pitfall_metrics.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/error.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/truth/pixel_maths.h"
#include "renderer/truth/reference.h"

namespace gbl {
namespace {

const Truth& truth_in(const PitfallEvidence& e) { return *e.measured.truth; }
Display display_of(const Settings& s) { return {s.exposure, s.colour}; }

std::optional<double> share(size_t part, size_t of) {
  return of == 0 ? std::nullopt : std::optional(static_cast<double>(part) / static_cast<double>(of));
}

// ---- as displayed, what is drawn forward included ------------------------------------------------------------------

// Share of all pixels whose displayed colour is off by more codes of 255 than this.
enum class Side { brighter, darker, either };
std::optional<double> share_off(const PitfallEvidence& e, double codes, Side side) {
  const Truth& truth = truth_in(e);
  if (e.shown.size() != truth.pixels()) return {};
  size_t off = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    const glm::dvec3 d = 255.0 * (glm::dvec3(e.shown[i]) - displayed(display_of(e.meant), truth.lit[i]));
    const bool brighter = std::max({d.x, d.y, d.z}) > codes, darker = std::min({d.x, d.y, d.z}) < -codes;
    off += !finite(d) || (side != Side::darker && brighter) || (side != Side::brighter && darker);
  }
  return share(off, truth.pixels());
}
std::optional<double> shown_off(const PitfallEvidence& e) { return share_off(e, 1, Side::either); }
std::optional<double> shown_off_4(const PitfallEvidence& e) { return share_off(e, 4, Side::either); }
std::optional<double> shown_brighter(const PitfallEvidence& e) { return share_off(e, 1, Side::brighter); }
std::optional<double> shown_darker(const PitfallEvidence& e) { return share_off(e, 1, Side::darker); }

// ---- shares of what an error counts --------------------------------------------------------------------------------

std::optional<double> doubled_share(const PitfallEvidence& e) {
  const double lit = lit_pixels(truth_in(e));
  const std::optional<double>& doubled = e.measured.errors.doubled_pixels;
  return lit > 0 && doubled ? std::optional(*doubled / lit) : std::nullopt;
}

// Of the pixels with a surface.
std::optional<double> share_of_surfaces(const PitfallEvidence& e, std::optional<double> pixels) {
  const std::optional<double>& all = e.measured.errors.compared_pixels;
  return pixels && all && *all > 0 ? std::optional(*pixels / *all) : std::nullopt;
}
std::optional<double> shadow_lit_share(const PitfallEvidence& e) {
  return share_of_surfaces(e, e.measured.errors.shadow_lit_pixels);
}
std::optional<double> shadow_dark_share(const PitfallEvidence& e) {
  return share_of_surfaces(e, e.measured.errors.shadow_dark_pixels);
}
std::optional<double> shadow_wrong_share(const PitfallEvidence& e) {
  const std::optional<double> lit = shadow_lit_share(e), dark = shadow_dark_share(e);
  return lit && dark ? std::optional(*lit + *dark) : std::nullopt;
}

std::optional<double> background_off_share(const PitfallEvidence& e) {
  const Truth& truth = truth_in(e);
  const auto empty = static_cast<size_t>(std::count(truth.present.begin(), truth.present.end(), 0));
  return share(static_cast<size_t>(e.measured.errors.background_off_pixels.value_or(0)), empty);
}

std::optional<double> holes_share(const PitfallEvidence& e) {
  const Truth& truth = truth_in(e);
  const std::vector<SeenSurface>& seen = e.measured.drawn.seen;
  if (seen.size() != truth.pixels()) return {};
  size_t surfaces = 0, holes = 0;
  for (size_t i = 0; i < seen.size(); ++i)
    surfaces += truth.present[i], holes += truth.present[i] && seen[i].object == 0;
  return share(holes, surfaces);
}

std::optional<double> shaded_per_lit(const PitfallEvidence& e) {
  if (!e.pairs || e.pairs->lit.value_or(0) == 0) return {};
  return static_cast<double>(e.pairs->shaded) / static_cast<double>(*e.pairs->lit);
}

// ---- markers of lights ---------------------------------------------------------------------------------------------

constexpr double kMarkerEdge = 0.05;  // of the light's range: light_marker.vert

struct Marker {
  glm::dvec2 place;    // of its middle, in pixels from the top left
  double half_width;   // in pixels
  double edge, range;  // world units; from the camera to its middle
};

std::vector<Marker> markers_before_camera(const Settings& s, const Scene& scene) {
  const double aspect = double(s.size.x) / s.size.y;
  const glm::dmat4 clip = clip_from_relative(s.camera, aspect);
  std::vector<Marker> out;
  for (const Light& l : true_lights(s, scene)) {
    const glm::dvec3 relative = l.position - s.camera.position;
    const glm::dvec4 at = clip * glm::dvec4(relative, 1);
    if (l.kind == LightKind::directional || at.w < s.camera.near || at.w > s.camera.far) continue;
    const double edge = kMarkerEdge * std::min(l.profile_range, l.range);
    out.push_back({(glm::dvec2(at) / at.w * glm::dvec2(0.5, -0.5) + 0.5) * glm::dvec2(s.size),
                   edge * s.size.y / (4 * s.camera.half_height(aspect) * at.w), edge, glm::length(relative)});
  }
  return out;
}

// Of the markers whose middle is in the picture, how many are seen where a surface hides them, or not seen where none
// does. A marker is seen where the shown picture is not what was lit. Left out are those close to a surface or behind
// another marker, and those smaller than two pixels, since they may lie between pixels' centres.
std::optional<double> markers_wrong(const PitfallEvidence& e) {
  const Truth& truth = truth_in(e);
  const Settings& s = e.setup.settings;
  if (e.shown.size() != truth.pixels() || e.measured.drawn.lit.size() != truth.pixels()) return {};
  const std::vector<Marker> markers = markers_before_camera(s, *e.setup.scene);
  size_t judged = 0, wrong = 0;
  for (const Marker& m : markers) {
    const glm::ivec2 pixel(glm::floor(m.place));
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= s.size.x || pixel.y >= s.size.y || m.half_width < 1) continue;
    const size_t i = static_cast<size_t>(pixel.y) * static_cast<size_t>(s.size.x) + static_cast<size_t>(pixel.x);
    const double in_front = truth.present[i] ? glm::length(truth.position[i]) - m.range : kEndless;
    const auto covers = [&](const Marker& o) {
      const glm::dvec2 off = glm::abs(o.place - m.place);
      return &o != &m && std::max(off.x, off.y) < 2 * o.half_width;  // a cube seen from a corner is wider than its edge
    };
    if (std::abs(in_front) < m.edge || std::any_of(markers.begin(), markers.end(), covers)) continue;
    const glm::dvec3 of_lit = displayed(display_of(s), glm::dvec3(e.measured.drawn.lit[i]));
    const bool seen = largest_magnitude(255.0 * (glm::dvec3(e.shown[i]) - of_lit)) > 1;
    ++judged, wrong += seen != (in_front > 0);
  }
  return share(wrong, judged);
}

// ---- kinks of a falloff --------------------------------------------------------------------------------------------

// The sharpest bend of the reference's picture, in codes: |a - 2b + c| of three neighbours between which the first
// light's distance passes a share of its range. As if the picture were kKinkWidth pixels wide: where a slope jumps, the
// bend of three neighbours goes with the distance between them.
constexpr double kKinkWidth = 320;

struct Kink {
  const Truth& truth;
  Display display;
  glm::dvec3 light;  // relative to the camera
  double distance;
  double most = 0;

  bool within(size_t i) const { return glm::distance(truth.position[i], light) < distance; }
  void look(size_t a, size_t b, size_t c) {
    if (!truth.present[a] || !truth.present[b] || !truth.present[c] || within(a) == within(c)) return;
    const glm::dvec3 across = truth.position[c] - truth.position[a];
    const bool one_plane = glm::dot(truth.normal[a], truth.normal[c]) > 1 - 1e-6 &&
                           std::abs(glm::dot(truth.normal[a], across)) < 1e-3 * glm::length(across);
    if (!one_plane) return;  // an edge bends by itself
    const auto shown = [&](size_t i) { return displayed(display, truth.lit[i]); };
    most = std::max(most, 255 * largest_magnitude(shown(a) - 2.0 * shown(b) + shown(c)));
  }
};

std::optional<double> kink_at(const PitfallEvidence& e, double share_of_range) {
  const Truth& truth = truth_in(e);
  const Settings& s = e.setup.settings;
  const std::vector<Light> lights = true_lights(s, *e.setup.scene);
  if (lights.empty()) return {};
  const Light& l = lights.front();
  Kink kink{truth, display_of(e.meant), l.position - s.camera.position, share_of_range * l.profile_range};
  const auto width = static_cast<size_t>(truth.size.x), height = static_cast<size_t>(truth.size.y);
  for (size_t y = 1; y + 1 < height; ++y)
    for (size_t x = 1; x + 1 < width; ++x) {
      const size_t i = y * width + x;
      kink.look(i - 1, i, i + 1), kink.look(i - width, i, i + width);
    }
  return kink.most * static_cast<double>(width) / kKinkWidth;
}
std::optional<double> rim_kink(const PitfallEvidence& e) { return kink_at(e, 1); }
std::optional<double> quarter_kink(const PitfallEvidence& e) { return kink_at(e, 0.25); }

constexpr PitfallMetric kOwn[] = {
    {"shown_off", "",
     "share of pixels off by more than a code of 255 as displayed, background and forward draws included", shown_off},
    {"shown_off_4", "", "share of pixels off by more than four codes of 255 as displayed", shown_off_4},
    {"shown_brighter", "", "share of pixels more than a code of 255 too bright as displayed", shown_brighter},
    {"shown_darker", "", "share of pixels more than a code of 255 too dark as displayed", shown_darker},
    {"doubled_share", "", "share of the lit pixels with more than one and a half times their light", doubled_share},
    {"shadow_lit_share", "", "share of the surfaces' pixels that are lit although something hides the light",
     shadow_lit_share},
    {"shadow_dark_share", "", "share of the surfaces' pixels that are dark although nothing hides the light",
     shadow_dark_share},
    {"shadow_wrong_share", "",
     "share of the surfaces' pixels that are lit and should be hidden, or the other way round", shadow_wrong_share},
    {"background_off_share", "",
     "share of the pixels without a surface that are brighter or darker than the background", background_off_share},
    {"holes_share", "", "share of the surfaces' pixels where nothing is drawn", holes_share},
    {"shaded_per_lit", "", "pairs of pixel and light shaded over pairs lit", shaded_per_lit},
    {"markers_wrong", "", "share of light markers that are seen and should be hidden, or the other way round",
     markers_wrong},
    {"rim_kink", "codes of 255",
     "sharpest bend at the first light's range in the reference, as displayed 320 pixels wide", rim_kink},
    {"quarter_kink", "codes of 255",
     "sharpest bend at a quarter of the first light's range in the reference, as displayed 320 pixels wide",
     quarter_kink},
};

}  // namespace

const PitfallMetric& pitfall_metric(std::string_view id) {
  static const std::vector<PitfallMetric> metrics = [] {
    std::vector<PitfallMetric> out(std::begin(kOwn), std::end(kOwn));
    for (const SweepMetric& m : sweep_metrics()) out.push_back({m.id, m.unit, m.help, nullptr});
    return out;
  }();
  std::vector<std::string_view> known;
  for (const PitfallMetric& m : metrics) {
    if (m.id == id) return m;
    known.emplace_back(m.id);
  }
  throw Error(ExitCode::bad_input, "metric", std::string("unknown metric '").append(id).append("'"),
              suggest(id, known));
}

std::optional<double> value_of(const PitfallMetric& metric, const PitfallEvidence& e) {
  if (metric.value) return metric.value(e);
  return value_of(sweep_metric(metric.id), e.setup, e.measured);
}

}  // namespace gbl
