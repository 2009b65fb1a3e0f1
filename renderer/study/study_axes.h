#pragma once
// A study made from names of options: all their values, the most telling set-ups first.
#include <string_view>

#include "renderer/study/study_spec.h"

namespace gbl {

// "normal.encoding,depth.format": first every value of each alone, all else as the base has it; then every pair of values of two of
// them; then three; and so on. Whoever stops early has the simplest comparisons. Error(bad_input) names an unknown
// option with the nearest ones, one without a list of values, and one that stands twice.
StudySpec study_of_axes(std::string_view comma_separated);

// "90s", "10m", "1.5h", "1h30m" -> seconds; Error(bad_input) at this place.
double parse_duration(std::string_view text, std::string_view where);

}  // namespace gbl
