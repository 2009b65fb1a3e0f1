#pragma once
// The numbers that pitfalls are known by. The more, the worse; and each is judged by the reference in double precision.
#include <optional>
#include <string_view>
#include <vector>

#include "renderer/frame/frame_report.h"
#include "renderer/study/stability/stability.h"

namespace gbl {

// What one side of a pitfall made of the truth, as read back.
struct PitfallEvidence {
  SweepSetup setup;                   // as drawn
  Settings meant;                     // whose truth judges
  Measured measured = {};             // against it
  std::vector<glm::vec3> shown = {};  // as displayed, drawn forward objects included: 0..1, rows top to bottom
  std::optional<PairCounts> pairs = {};
  FrameReport report = {};  // what drawing it cost
};

struct PitfallMetric {
  const char* id;
  const char* unit;  // "" = a share or a count
  const char* help;
  std::optional<double> (*value)(const PitfallEvidence&);  // null: the metric of sweeps with this id
};
const PitfallMetric& pitfall_metric(std::string_view id);  // Error with the known ones
std::optional<double> value_of(const PitfallMetric&, const PitfallEvidence&);

}  // namespace gbl
