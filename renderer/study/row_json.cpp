#include "renderer/study/row_json.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "renderer/base/json.h"
#include "renderer/base/made_by.h"
#include "renderer/options/data_file.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/study_paths.h"

namespace gbl {
namespace {

constexpr const char* kPlaces[] = {"study",  "case",    "key",     "at",
                                   "failed", "made_by", "settings"};  // all else is a column

bool is_column(std::string_view member) {
  for (const std::string_view place : kPlaces)
    if (member == place) return false;
  return true;
}

std::string text_in(const Json& object, const char* member) {
  const auto it = object.find(member);
  return it == object.end() ? "" : plain(option_value(*it));
}

// What is neither a number nor a text is not measured.
ColumnValue value_of(const Json& json) {
  const OptionValue value = option_value(json);
  if (const auto* n = std::get_if<Number>(&value)) return *n;
  const auto* text = std::get_if<std::string>(&value);
  if (!text) return {};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const auto& [name, number] : {std::pair("inf", kInfinity), std::pair("-inf", -kInfinity),
                                     std::pair("nan", std::numeric_limits<double>::quiet_NaN())})
    if (*text == name) return number;
  return *text;
}

}  // namespace

std::string row_key(const Settings& s) {
  Json json = to_json(s);
  json.erase("view");
  return fmt::format("{:016x}", fnv1a(json.dump()));
}

Json to_json(const ColumnValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  const auto* n = std::get_if<Number>(&value);
  if (!n) return nullptr;
  if (std::isnan(n->value)) return "nan";
  if (std::isinf(n->value)) return n->value > 0 ? "inf" : "-inf";
  return to_json(OptionValue(*n));
}

void append_cells(Json& object, const std::vector<Cell>& cells) {
  for (const Cell& c : cells) object[c.column] = to_json(c.value);
}

std::string cell_text(const ColumnValue& value) {
  const Json json = to_json(value);
  return json.is_null() ? "" : json.is_string() ? json.get<std::string>() : json.dump();
}

Json to_json(const StudyRow& row) {
  Json json;
  json["study"] = row.study;
  json["case"] = row.name;
  json["key"] = row.key;
  json["at"] = Json::object();
  for (const Assignment& a : row.at) json["at"][a.path] = to_json(a.value);
  if (row.failed) json["failed"] = *row.failed;
  if (!row.made_by.empty()) json["made_by"] = row.made_by;
  append_cells(json, row.cells);
  json["settings"] = to_json(row.settings);
  return json;
}

std::string journal_line(const StudyRow& row) {
  return to_json(row).dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::optional<StudyRow> parse_journal_line(std::string_view line, std::string_view where) {
  const Json json = Json::parse(line, nullptr, false);
  for (const char* needed : {"key", "settings"})
    if (!json.is_object() || !json.contains(needed)) return {};
  if (!json["key"].is_string()) return {};
  StudyRow row{.study = text_in(json, "study"), .name = text_in(json, "case"), .key = text_in(json, "key")};
  if (json.contains("at"))
    for (const auto& [path, value] : json["at"].items())
      row.at.push_back(
          {path, look_up(where, [&, &p = path, &v = value] { return checked_value(p, option_value(v)); })});
  if (json.contains("failed")) row.failed = text_in(json, "failed");
  row.made_by = text_in(json, "made_by");
  for (const auto& [column, value] : json.items())
    if (is_column(column)) row.cells.push_back({column, value_of(value)});
  row.settings = from_json(json["settings"], where);
  return row;
}

}  // namespace gbl
