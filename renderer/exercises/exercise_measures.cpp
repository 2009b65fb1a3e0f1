#include "renderer/exercises/exercise_measures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/study/rows/study_columns.h"
#include "renderer/truth/ties.h"

namespace gbl {
namespace {

// Of the icospheres that stand for all lights of the frame: 20 faces, each split in four at every level.
std::optional<double> volume_triangles(const PitfallEvidence& e) {
  const Settings& s = e.setup.settings;
  if (!facts(s.lights.method).draws_meshes) return {};
  return 20 * std::pow(4.0, static_cast<int>(s.lights.volume.level)) *
         static_cast<double>(all_lights_of(s, *e.setup.scene).size());
}

std::optional<double> first_range(const PitfallEvidence& e) {
  const std::vector<Light> lights = all_lights_of(e.setup.settings, *e.setup.scene);
  return lights.empty() ? std::nullopt : std::optional(lights.front().range);
}

const ExerciseMeasure kOwn[] = {
    {"volume_triangles", "triangles", "triangles of all light volumes", volume_triangles},
    {"first_range", "units", "range of the first light", first_range},
};

const StudyColumn* cost_of_frame(std::string_view id) {
  for (const StudyColumn& c : study_columns())
    if (c.id == id && c.of_frame) return &c;
  return nullptr;
}

std::vector<ExerciseMeasure> make_measures() {
  std::vector<ExerciseMeasure> all(std::begin(kOwn), std::end(kOwn));
  for (const StudyColumn& c : study_columns())
    if (c.of_frame && c.axis == Axis::cost) all.push_back({c.id, c.unit, c.label});
  return all;
}

const std::vector<ExerciseMeasure>& measures() {
  static const std::vector<ExerciseMeasure> kAll = make_measures();
  return kAll;
}

// atan2, since acos of a dot product near 1 loses its digits.
std::optional<double> normal_deg(const PitfallEvidence& e, size_t i) {
  if (e.measured.drawn.normal.size() <= i) return {};
  const glm::dvec3 drawn(e.measured.drawn.normal[i]), meant = e.measured.truth->normal[i];
  return glm::degrees(std::atan2(glm::length(glm::cross(drawn, meant)), glm::dot(drawn, meant)));
}

std::optional<double> shown_codes(const PitfallEvidence& e, size_t i) {
  if (e.shown.size() <= i) return {};
  const glm::dvec3 meant = displayed({e.meant.exposure, e.meant.colour}, e.measured.truth->lit[i]);
  const glm::dvec3 d = glm::abs(glm::dvec3(e.shown[i]) - meant);
  return 255 * std::max({d.x, d.y, d.z});
}

constexpr PixelMeasure kOfPixels[] = {
    {"normal_deg", "degrees", "how far the normal is off", normal_deg},
    {"shown_codes", "codes of 255", "how far the pixel is off as displayed", shown_codes},
};

}  // namespace

ExerciseMeasure exercise_measure(std::string_view id) {
  for (const ExerciseMeasure& m : measures())
    if (m.id == id) return m;
  const PitfallMetric& p = pitfall_metric(id);
  return {p.id, p.unit, p.help};
}

std::optional<double> value_of(const ExerciseMeasure& m, const PitfallEvidence& e) {
  if (m.value) return m.value(e);
  const StudyColumn* cost = cost_of_frame(m.id);
  if (!cost) return value_of(pitfall_metric(m.id), e);
  const ColumnValue value = cost->of_frame(e.report, {});
  const auto* n = std::get_if<Number>(&value);
  return n ? std::optional(n->value) : std::nullopt;
}

const PixelMeasure& pixel_measure(std::string_view id) {
  std::vector<std::string_view> known;
  for (const PixelMeasure& m : kOfPixels) {
    if (id == m.id) return m;
    known.emplace_back(m.id);
  }
  throw Error(ExitCode::bad_input, "measure", fmt::format("unknown measure '{}' of a pixel", id), suggest(id, known));
}

std::optional<double> value_of(const PixelMeasure& m, const PitfallEvidence& e, glm::ivec2 pixel) {
  const Truth& truth = *e.measured.truth;
  const size_t i = static_cast<size_t>(pixel.y) * static_cast<size_t>(truth.size.x) + static_cast<size_t>(pixel.x);
  const std::vector<SeenSurface>& seen = e.measured.drawn.seen;
  if (!truth.present[i] || (seen.size() > i && is_tie(truth, i, seen[i]))) return {};
  return m.value(e, i);
}

}  // namespace gbl
