#pragma once
// Is a pitfall as catalogued: does it fail when broken, hold when fixed, and hide where it is said to hide? Both are
// judged by the reference, never by each other. Data in, numbers out, through a function that draws: no GL here.
#include <functional>
#include <optional>
#include <string>

#include "renderer/study/pitfalls/catalogue.h"
#include "renderer/study/pitfalls/pitfall_metrics.h"

namespace gbl {

struct PitfallResult {
  std::optional<double> broken, fixed, blind;  // of the metric; empty: could not be measured, or there is none
  std::string skipped;                         // why this device cannot draw it; then nothing is judged
  std::string wrong;                           // what is not as catalogued, in words; empty: all is
  bool holds() const { return wrong.empty(); }
};

PitfallBounds bounds_on(const PitfallEntry&, const DeviceRounding&);

// What is not as catalogued, in words; empty: all is.
std::string judge_numbers(const PitfallEntry&, const PitfallBounds&, std::optional<double> broken,
                          std::optional<double> fixed, std::optional<double> blind);

// Draws `drawn`, and judges it by the truth of `meant`. Errors are thrown on.
using PitfallMeasureFn = std::function<PitfallEvidence(const Settings& drawn, const Settings& meant)>;

// Error(bad_input): its settings contradict each other. size: of the pictures; tests hold the bounds at 160x90 and 320x180.
PitfallResult judge_pitfall(const PitfallEntry&, glm::ivec2 size, const DeviceLimits&, const DeviceRounding&,
                            const PitfallMeasureFn&);

// "0.374"; "not measured".
std::string number_text(std::optional<double>);

}  // namespace gbl
