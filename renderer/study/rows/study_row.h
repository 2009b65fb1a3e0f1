#pragma once
// One row of a study: a case, and what was measured of it or why nothing was.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/options/options.h"
#include "renderer/study/rows/study_columns.h"

namespace gbl {

struct StudyRow {
  std::string study, name;            // the case's name in the study
  std::string key;                    // of the settings asked for: row_key()
  std::vector<Assignment> at;         // what the study varies, here
  std::optional<std::string> failed;  // why; then there are no cells
  std::vector<Cell> cells;            // in the order of files
  Settings settings;                  // as drawn; of a row that failed as asked for
  std::string made_by;                // renderer/base/made_by.h; empty: of a program that did not say so

  // Empty: not measured.
  std::optional<double> number(std::string_view column) const;
  std::string text(std::string_view column) const;
  bool operator==(const StudyRow&) const = default;
};

// What a measurement gives to a row: all its columns.
struct MeasuredColumns {
  std::vector<Cell> cells;
  Settings drawn;
};

// Of an axis: with its magnitude and its ratio taken.
std::optional<double> column_value(const StudyRow&, const StudyColumn&);

// A time that spreads too far to be compared with another.
bool is_noisy(const StudyRow&, const StudyColumn&);

// When is a row measured long enough? 20 frames or 20 s, at least 3 frames, 1 if one exceeds 20 s.
bool measured_enough(int frames, double seconds, double slowest_s);

}  // namespace gbl
