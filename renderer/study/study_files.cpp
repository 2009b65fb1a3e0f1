#include "renderer/study/study_files.h"

#include <fmt/format.h>
#include <functional>
#include <set>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/study/charts/gnuplot.h"
#include "renderer/study/row_json.h"

namespace gbl {
namespace {

constexpr int kStudyFileVersion = 1;

// ---- study.csv --------------------------------------------------------------------------------------------
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

struct CsvColumn {
  std::string name;
  std::function<std::string(const StudyRow&)> cell;
};

class CsvColumns {
 public:
  void add_once(const std::string& name, std::function<std::string(const StudyRow&)> cell) {
    if (names_.insert(name).second) list_.push_back({name, std::move(cell)});
  }
  std::vector<CsvColumn> take() { return std::move(list_); }

 private:
  std::set<std::string> names_;
  std::vector<CsvColumn> list_;
};

std::string at_path(const StudyRow& row, const std::string& path) {
  for (const Assignment& a : row.at)
    if (a.path == path) return plain(a.value);
  return "";
}

std::string in_column(const StudyRow& row, const std::string& column, const std::string& otherwise = "") {
  for (const Cell& c : row.cells)
    if (c.column == column) return cell_text(c.value);
  return otherwise;
}

// What a row is called, its coordinates, what was measured, its settings. Rows differ: not every method has every pass.
std::vector<CsvColumn> csv_columns(const std::vector<StudyRow>& rows, const Machine& machine) {
  CsvColumns list;
  list.add_once("study", [](const StudyRow& r) { return r.study; });
  list.add_once("case", [](const StudyRow& r) { return r.name; });
  list.add_once("key", [](const StudyRow& r) { return r.key; });
  for (const StudyRow& row : rows)
    for (const Assignment& a : row.at)
      list.add_once("at." + a.path, [path = a.path](const StudyRow& r) { return at_path(r, path); });
  const auto driver = [&](const StudyRow& r) { return in_column(r, "driver", machine.driver); };
  const auto device = [&](const StudyRow& r) { return in_column(r, "device", machine.device); };
  for (const StudyRow& row : rows) {
    if (row.failed) list.add_once("failed", [](const StudyRow& r) { return r.failed.value_or(""); });
    for (const Cell& c : row.cells)
      if (c.column == "driver")
        list.add_once("driver", driver);
      else if (c.column == "device")
        list.add_once("device", device);
      else
        list.add_once(c.column, [name = c.column](const StudyRow& r) { return in_column(r, name); });
  }
  list.add_once("driver", driver);
  list.add_once("device", device);
  for (const Option& o : options())
    if (o.group != Group::view) list.add_once(o.path, [&o](const StudyRow& r) { return plain(o.get(r.settings)); });
  return list.take();
}

// ---- study.svg, study.png ---------------------------------------------------------------------------------
// The one value that all rows share, or what there is instead.
std::string common_text(const std::vector<StudyRow>& rows, const char* column, const char* several) {
  std::string found;
  for (const StudyRow& row : rows) {
    const std::string text = row.text(column);
    if (text.empty()) continue;
    if (!found.empty() && found != text) return several;
    found = text;
  }
  return found;
}

std::string subtitle_of(const std::vector<StudyRow>& rows, const Chart& chart, const Machine& machine) {
  const std::string device = common_text(rows, "device", "several devices");
  std::string text = device.empty() ? machine.device : device;
  text += ", " + common_text(rows, "size", "several sizes") + " pixels";
  text += ", times by " + common_text(rows, "time_source", "several sources");
  if (chart.without_value > 0) text += fmt::format("; rows without these numbers: {}", chart.without_value);
  if (const std::string mixed = mixed_programs(chart); !mixed.empty()) text += "; " + mixed;
  if (chart.failed > 0) text += fmt::format("; rows that failed: {}", chart.failed);
  return text;
}

void write_charts(const std::filesystem::path& folder, const StudySpec& spec, const std::vector<StudyRow>& rows,
                  const Machine& machine) {
  const Chart chart = chart_points(rows, spec.x, spec.y, spec.family);
  if (chart.points.empty())
    throw Error(ExitCode::unfinished, (folder / "study.svg").string(),
                fmt::format("no row has both {} and {}: there is nothing to draw", spec.x, spec.y),
                "choose other columns");
  const ChartTexts texts{spec.label, subtitle_of(rows, chart, machine)};
  write_text_file(folder / "study.svg", run_gnuplot(chart_script(chart, texts, ChartFile::svg)));
  write_text_file(folder / "study.png", run_gnuplot(chart_script(chart, texts, ChartFile::png)));
}

}  // namespace

std::string study_csv(const std::vector<StudyRow>& rows, const Machine& machine) {
  const std::vector<CsvColumn> columns = csv_columns(rows, machine);
  std::string text;
  for (const CsvColumn& c : columns) text += (&c == columns.data() ? "" : ",") + quoted(c.name);
  text += "\r\n";
  for (const StudyRow& row : rows) {
    for (const CsvColumn& c : columns) text += (&c == columns.data() ? "" : ",") + quoted(c.cell(row));
    text += "\r\n";
  }
  return text;
}

Json study_json(const StudySpec& spec, const std::vector<StudyRow>& rows, const Machine& machine) {
  Json json;
  json["version"] = kStudyFileVersion;
  json["spec"] = *spec.json;
  json["machine"] = {{"driver", machine.driver}, {"device", machine.device}};
  json["rows"] = Json::array();
  for (const StudyRow& row : rows) json["rows"].push_back(to_json(row));
  return json;
}

void write_study_files(const std::filesystem::path& folder, const StudySpec& spec, const std::vector<StudyRow>& rows,
                       const Machine& machine, const CommandFn& command) {
  make_folder(folder);
  write_text_file(folder / "study.csv", study_csv(rows, machine));
  write_text_file(folder / "study.json", study_json(spec, rows, machine).dump(1) + "\n");
  write_text_file(folder / "study.html", page_html(study_page(spec, rows, machine, command, folder)));
  write_charts(folder, spec, rows, machine);
}

}  // namespace gbl
