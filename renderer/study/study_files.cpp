#include "renderer/study/study_files.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/image.h"
#include "renderer/study/charts/gnuplot.h"

namespace gbl {
namespace {

constexpr int kStudyFileVersion = 1;

// ---- study.csv --------------------------------------------------------------------------------------------
std::string cell(const Json& value) {
  std::string text = value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

// The value at a dotted path of nested objects; null if it is not there.
Json nested(const Json& node, std::string_view path) {
  const size_t dot = path.find('.');
  const auto it = node.is_object() ? node.find(std::string(path.substr(0, dot))) : node.end();
  if (!node.is_object() || it == node.end()) return nullptr;
  return dot == std::string_view::npos ? *it : nested(*it, path.substr(dot + 1));
}

struct Column {
  std::string name;
  enum class In { row, at, settings } in;
};

void add_once(std::vector<Column>& list, const std::string& name, Column::In in) {
  for (const Column& c : list)
    if (c.name == name) return;
  list.push_back({name, in});
}

// What a row is called, its coordinates, what was measured, its settings. Rows differ: not every method has every pass.
std::vector<Column> columns_of(const std::vector<Json>& rows) {
  std::vector<Column> list = {{"study", Column::In::row}, {"case", Column::In::row}, {"key", Column::In::row}};
  for (const Json& row : rows)
    if (row.contains("at") && row["at"].is_object())
      for (const auto& [path, value] : row["at"].items()) add_once(list, "at." + path, Column::In::at);
  for (const Json& row : rows)
    for (const auto& [name, value] : row.items())
      if (name != "at" && name != "settings") add_once(list, name, Column::In::row);
  add_once(list, "driver", Column::In::row);
  add_once(list, "device", Column::In::row);
  for (const Option& o : options())
    if (o.group != Group::view) add_once(list, o.path, Column::In::settings);
  return list;
}

Json value_of(const Json& row, const Column& c, const Machine& machine) {
  switch (c.in) {
    case Column::In::at: return row.contains("at") ? row["at"].value(c.name.substr(3), Json()) : Json();
    case Column::In::settings: return row.contains("settings") ? nested(row["settings"], c.name) : Json();
    case Column::In::row: break;
  }
  if (row.contains(c.name)) return row[c.name];
  return c.name == "driver" ? Json(machine.driver) : c.name == "device" ? Json(machine.device) : Json();
}

// ---- study.svg, study.png ---------------------------------------------------------------------------------
// The one value that all rows share, or what there is instead.
std::string common_value(const std::vector<Json>& rows, const char* name, const char* several) {
  std::string found;
  for (const Json& row : rows) {
    if (!row.contains(name) || !row[name].is_string()) continue;
    const auto value = row[name].get<std::string>();
    if (!found.empty() && found != value) return several;
    found = value;
  }
  return found;
}

std::string subtitle_of(const std::vector<Json>& rows, const Chart& chart, const Machine& machine) {
  const std::string device = common_value(rows, "device", "several devices");
  std::string text = device.empty() ? machine.device : device;
  text += ", " + common_value(rows, "size", "several sizes") + " pixels";
  text += ", times by " + common_value(rows, "time_source", "several sources");
  if (chart.without_value > 0) text += fmt::format("; rows without these numbers: {}", chart.without_value);
  if (chart.failed > 0) text += fmt::format("; rows that failed: {}", chart.failed);
  return text;
}

void write_charts(const std::filesystem::path& folder, const StudySpec& spec, const std::vector<Json>& rows,
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

std::string study_csv(const std::vector<Json>& rows, const Machine& machine) {
  const std::vector<Column> columns = columns_of(rows);
  std::string text;
  for (const Column& c : columns) text += (&c == columns.data() ? "" : ",") + cell(c.name);
  text += "\r\n";
  for (const Json& row : rows) {
    for (const Column& c : columns) text += (&c == columns.data() ? "" : ",") + cell(value_of(row, c, machine));
    text += "\r\n";
  }
  return text;
}

Json study_json(const StudySpec& spec, const std::vector<Json>& rows, const Machine& machine) {
  Json json;
  json["version"] = kStudyFileVersion;
  json["spec"] = *spec.json;
  json["machine"] = {{"driver", machine.driver}, {"device", machine.device}};
  json["rows"] = rows;
  return json;
}

void write_study_files(const std::filesystem::path& folder, const StudySpec& spec, const std::vector<Json>& rows,
                       const Machine& machine) {
  make_folder(folder);
  write_text_file(folder / "study.csv", study_csv(rows, machine));
  write_text_file(folder / "study.json", study_json(spec, rows, machine).dump(1) + "\n");
  write_charts(folder, spec, rows, machine);
}

}  // namespace gbl
