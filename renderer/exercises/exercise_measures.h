#pragma once
// The numbers that answers are judged by: those of pitfalls and sweeps (errors against the reference, and shares), what a
// frame costs (columns of a study), and a few of lights.
#include <optional>
#include <string>
#include <string_view>

#include "renderer/study/pitfalls/pitfall_metrics.h"

namespace gbl {

struct ExerciseMeasure {
  std::string id, unit, help;
  std::optional<double> (*value)(const PitfallEvidence&) = nullptr;  // null: a pitfall's metric or a study's column
};
ExerciseMeasure exercise_measure(std::string_view id);  // Error with the nearest
std::optional<double> value_of(const ExerciseMeasure&, const PitfallEvidence&);

// Of one pixel, origin top left. Empty: there is no surface, or frame and reference see different ones at an edge.
struct PixelMeasure {
  const char* id;
  const char* unit;
  const char* help;
  std::optional<double> (*value)(const PitfallEvidence&, size_t pixel);
};
const PixelMeasure& pixel_measure(std::string_view id);  // Error with the nearest
std::optional<double> value_of(const PixelMeasure&, const PitfallEvidence&, glm::ivec2 pixel);

}  // namespace gbl
