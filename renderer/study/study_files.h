#pragma once
// A study's results as files: for spreadsheets, for programs and to look at.
#include <filesystem>

#include "renderer/study/rows/study_row.h"
#include "renderer/study/study_page.h"

namespace gbl {

// RFC 4180: a header of column names, then a line per row. Settings are columns by their path, coordinates "at.PATH";
// empty: not measured. Driver and device stand on each row: tables are pasted together.
std::string study_csv(const std::vector<StudyRow>& rows, const Machine&);

// {"version", "spec", "machine", "rows"}
Json study_json(const StudySpec&, const std::vector<StudyRow>& rows, const Machine&);

// study.csv, study.json, study.html, study.svg and study.png in this folder, each by a temporary name. x, y and family are
// the spec's. Error(unfinished): a file cannot be written, or the chart cannot be drawn; then the three others are there.
void write_study_files(const std::filesystem::path& folder, const StudySpec&, const std::vector<StudyRow>& rows,
                       const Machine&, const CommandFn&);

}  // namespace gbl
