#pragma once
// Stability curves as files: for spreadsheets, for programs and to look at.
#include <filesystem>
#include <vector>

#include "renderer/base/json_fwd.h"
#include "renderer/study/rows/study_row.h"
#include "renderer/study/stability/stability.h"

namespace gbl {

// A line per point: sweep, curve, x, metric, value, then every column of Errors. Empty: not measured; "inf" and "nan"
// as they are.
std::string stability_csv(const std::vector<SweepResult>&);

// {"version", "machine", "sweeps": [{…, "curves": [{…, "statements", "points"}]}]}
// A page: of each curve what is stated of it and whether it holds, and at the end the curves that never failed.
std::string stability_markdown(const std::vector<SweepResult>&, const Machine&, const DeviceRounding&);

Json stability_json(const std::vector<SweepResult>&, const Machine&, const DeviceRounding&);

// stability.csv, stability.json, stability.md, stability.html and <sweep>.svg, <sweep>.png in this folder, each by a temporary name. Error(unfinished):
// a file cannot be written, or a chart cannot be drawn; then the tables are there.
void write_stability_files(const std::filesystem::path& folder, const std::vector<SweepResult>&, const Machine&,
                           const DeviceRounding&);

}  // namespace gbl
