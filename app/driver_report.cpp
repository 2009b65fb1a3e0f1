#include "app/driver_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

#include "app/self_test.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/made_by.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

// A line for each picture as it is done.
void print_result(const SelfTestResult& r) {
  if (!r.skipped.empty())
    fmt::print("{:<12} skipped: {}\n", r.id, r.skipped);
  else if (!r.failed.empty())
    fmt::print("{:<12} FAILED: {}\n", r.id, r.failed);
  else
    fmt::print("{:<12} {}  FLIP {:.5f} (at most {:.5f})  {}\n", r.id, r.hash, r.flip_mean, r.flip_at_most,
               r.holds() ? "holds" : "DOES NOT HOLD");
  std::fflush(stdout);
}

}  // namespace

ExitCode write_driver_report(const std::filesystem::path& file, Json info, FeatureSet off, bool quiet) {
  Lab lab(off);
  info["made_by"] = made_by();
  info["self_test"] = Json::array();
  // Anew after each picture: a driver may end the program.
  const auto write = [&] { write_text_file(file, info.dump(2) + "\n"); };
  write();
  size_t drawn = 0, hold = 0;
  run_self_test(lab, [&](const SelfTestResult& r) {
    if (!quiet) print_result(r);
    info["self_test"].push_back(to_json(r));
    write();
    drawn += r.skipped.empty() ? 1u : 0u;
    hold += r.holds() ? 1u : 0u;
  });
  const bool all_hold = hold == drawn && drawn > 0;
  if (quiet) return all_hold ? ExitCode::done : ExitCode::check_failed;
  fmt::print("\n{} of {} pictures hold{}\n{}\n", hold, drawn,
             all_hold ? ": the lab's numbers hold here"
                      : ": numbers of the others are not to be trusted here; please send the file",
             file.string());
  return all_hold ? ExitCode::done : ExitCode::check_failed;
}

namespace {

struct DriverRow {
  int drawn = 0, hold = 0, same = 0;  // pictures
  double flip = 0;                    // the largest
  std::vector<std::string> skipped;
  size_t formats = 0, formats_hold = 0;
};

// first: the hashes of the first report, by picture.
DriverRow row_of(const Json& report, const std::map<std::string, std::string>& first) {
  DriverRow row;
  for (const Json& picture : report.at("self_test")) {
    const std::string id = picture.at("id");
    if (picture.contains("skipped")) {
      row.skipped.push_back(id);
      continue;
    }
    const auto other = first.find(id);
    row.drawn += 1;
    row.hold += picture.at("holds").get<bool>() ? 1 : 0;
    if (picture.contains("failed")) continue;
    row.same += other != first.end() && other->second == picture.at("hash").get<std::string>() ? 1 : 0;
    row.flip = std::max(row.flip, picture.at("flip_mean").get<double>());
  }
  for (const Json& check : report.at("format_checks")) {
    row.formats += 1;
    row.formats_hold += check.at("holds").get<bool>() ? 1 : 0;
  }
  return row;
}

std::map<std::string, std::string> hashes_of(const Json& report) {
  std::map<std::string, std::string> out;
  for (const Json& picture : report.at("self_test"))
    if (picture.contains("hash")) out[picture.at("id")] = picture.at("hash");
  return out;
}

}  // namespace

std::string driver_table(const std::vector<std::filesystem::path>& reports) {
  std::string out =
      "| driver | GL, device | pictures drawn | hold | same bits as the first | largest FLIP | not drawn | formats "
      "that hold |\n"
      "|---|---|---|---|---|---|---|---|\n";
  std::optional<std::map<std::string, std::string>> first;
  for (const std::filesystem::path& file : reports) {
    const Json report = read_json(file);
    try {
      if (!first) first = hashes_of(report);
      const DriverRow r = row_of(report, *first);
      out += fmt::format("| {} | {}, {} | {} | {} | {} | {:.5f} | {} | {} of {} |\n", file.stem().string(),
                         report.at("gl").get<std::string>(), report.at("device").get<std::string>(), r.drawn, r.hold,
                         r.same, r.flip, fmt::join(r.skipped, ", "), r.formats_hold, r.formats);
    } catch (const Json::exception&) {
      throw Error(ExitCode::bad_input, file.string(), "is no report of a driver",
                  "make one: gbufferlab info --report FILE");
    }
  }
  return out;
}

}  // namespace gbl
