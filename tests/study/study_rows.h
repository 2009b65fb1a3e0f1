#pragma once
// Rows as tests write them down.
#include "renderer/study/rows/study_row.h"

namespace gbl::test {

inline void put(StudyRow& row, std::string_view column, ColumnValue value) {
  for (Cell& c : row.cells)
    if (c.column == column) {
      c.value = std::move(value);
      return;
    }
  row.cells.push_back({std::string(column), std::move(value)});
}

inline StudyRow row_of(std::string name, std::vector<Cell> cells, std::vector<Assignment> at = {}) {
  StudyRow row;
  row.study = "t", row.name = row.key = std::move(name);
  row.cells = std::move(cells), row.at = std::move(at);
  return row;
}

inline StudyRow failed_row_of(std::string name, std::string why) {
  StudyRow row = row_of(std::move(name), {});
  row.failed = std::move(why);
  return row;
}

}  // namespace gbl::test
