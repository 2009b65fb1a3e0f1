#pragma once
// What a bug report needs of a driver, in one file: `info` with the pictures of the self-test. And several of them as a table.
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/base/features.h"
#include "renderer/base/json_fwd.h"

namespace gbl {

// info: what `info --json` prints. Needs a current context. quiet: prints nothing. check_failed if a picture does not hold.
ExitCode write_driver_report(const std::filesystem::path&, Json info, FeatureSet off, bool quiet);

// Markdown; the first report is what the others are compared with. Error(bad_input) where a file is no report.
std::string driver_table(const std::vector<std::filesystem::path>& reports);

}  // namespace gbl
