#include "renderer/study/study_spec.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/base/limits.h"
#include "renderer/base/resources.h"
#include "renderer/options/data_file.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/rows/study_columns.h"

namespace gbl {
namespace {

constexpr int kStudyVersion = 1;
constexpr std::string_view kFolder = "assets/studies/";

std::string file_name(std::string_view id) { return data_file_name(kFolder, id); }

void must_be_object(const Json& node, std::string_view where) {
  if (!node.is_object()) throw Error(ExitCode::bad_input, where, "must be an object {\"path\": ...}");
}

std::vector<Coordinate> parse_base(const Json& node, std::string_view where) {
  must_be_object(node, where);
  std::vector<Coordinate> base;
  for (const auto& [path, value] : node.items())
    base.push_back({path, look_up(where, [&, &p = path, &v = value] { return checked_value(p, option_value(v)); })});
  return base;
}

PathValues parse_axis(const std::string& path, const Json& values, std::string_view where) {
  if (values.is_array() && values.empty())
    throw Error(ExitCode::bad_input, where, fmt::format("{} has no values: the product is empty", path),
                "give one, or leave the path out");
  PathValues axis{path, {}};
  for (const Json& v : values)
    axis.values.push_back(look_up(where, [&] { return checked_value(path, option_value(v)); }));
  return axis;
}

std::vector<PathValues> parse_product(const Json& node, std::string_view where) {
  must_be_object(node, where);
  if (node.empty()) throw Error(ExitCode::bad_input, where, "is empty", "give a path with values, or leave it out");
  std::vector<PathValues> product;
  for (const auto& [path, values] : node.items()) {
    if (!values.is_array())
      throw Error(ExitCode::bad_input, where, fmt::format("{} is {}, not an array of values", path, values.dump()),
                  "put the values into [ ]");
    product.push_back(parse_axis(path, values, where));
  }
  return product;
}

std::vector<std::vector<PathValues>> parse_permute(const Json& node, const std::string& where) {
  if (!node.is_array()) return {parse_product(node, where)};
  if (node.empty())
    throw Error(ExitCode::bad_input, where, "is an empty array: no case", "give a product {\"path\": []}");
  std::vector<std::vector<PathValues>> products;
  for (const Json& part : node)
    products.push_back(parse_product(part, fmt::format("{} {}", where, products.size() + 1)));
  return products;
}

// One entry: {path: value or [values]}; of an option whose value is itself an array always [[...], ...]. An empty entry
// would match, and leave out, everything.
std::vector<PathValues> parse_rule(const Json& node, std::string_view where) {
  must_be_object(node, where);
  if (node.empty()) throw Error(ExitCode::bad_input, where, "is empty: it would skip every case", "give it a path");
  std::vector<PathValues> rule;
  for (const auto& [path, value] : node.items())
    rule.push_back(parse_axis(path, value.is_array() ? value : Json::array({value}), where));
  return rule;
}

std::vector<std::vector<PathValues>> parse_skip(const Json& node, const std::string& where) {
  if (!node.is_array()) throw Error(ExitCode::bad_input, where, "must be an array of objects");
  std::vector<std::vector<PathValues>> rules;
  for (const Json& part : node) rules.push_back(parse_rule(part, fmt::format("{} {}", where, rules.size() + 1)));
  return rules;
}

void check_size(const StudySpec& spec) {
  size_t total = 0;
  for (const std::vector<PathValues>& product : spec.permute) {
    size_t cases = 1;
    for (const PathValues& axis : product)
      cases = std::min(cases * axis.values.size(), kMostStudyCases + 1);  // no overflow
    total = std::min(total + cases, kMostStudyCases + 1);
  }
  if (total > kMostStudyCases)
    throw Error(ExitCode::bad_input, spec.where, fmt::format("permute has more than {} cases", kMostStudyCases),
                "vary fewer paths at once: an array of smaller products is their union");
}

std::string text_or(const Json& json, const char* member, std::string_view where, const char* otherwise) {
  const std::string text = text_member(json, member, where);
  return text.empty() ? otherwise : text;
}

void parse_chart(const Json& json, StudySpec& spec) {
  spec.x = text_or(json, "x", spec.where, "time_ms_total_median");
  spec.y = text_or(json, "y", spec.where, "rmse_linear");
  spec.family = text_or(json, "family", spec.where, "lights.method");
  look_up(spec.where, [&] {
    cost_column(spec.x);
    chart_error_column(spec.y);
    check_path(spec.family);
  });
}

StudySpec read_spec(const Json& json, std::string_view where) {
  if (!json.is_object()) throw Error(ExitCode::bad_input, where, "must be a JSON object");
  if (json.contains("version")) check_file_version(json, kStudyVersion, "study", where);
  only_members(json, {"version", "name", "label", "base", "permute", "skip", "x", "y", "family"}, where);
  StudySpec spec;
  spec.where = where;
  spec.json = std::make_shared<const Json>(json);
  spec.name = needed_text_member(json, "name", where);
  spec.label = text_or(json, "label", where, spec.name.c_str());
  if (json.contains("base")) spec.base = parse_base(json["base"], spec.where + ": base");
  if (json.contains("permute")) spec.permute = parse_permute(json["permute"], spec.where + ": permute");
  if (json.contains("skip")) spec.skip = parse_skip(json["skip"], spec.where + ": skip");
  check_size(spec);
  parse_chart(json, spec);
  return spec;
}

}  // namespace

StudySpec parse_study(std::string_view text, std::string_view where) {
  return read_spec(parse_json(text, where), where);
}

StudySpec load_study(const std::string& name_or_file) {
  const std::vector<std::string> ids = data_file_ids(kFolder);
  if (std::find(ids.begin(), ids.end(), name_or_file) != ids.end())
    return parse_study(resource(file_name(name_or_file)), file_name(name_or_file));
  // What looks like a file is one, and its own message says so if it is not there.
  std::error_code ignored;
  if (name_or_file.ends_with(".json") || std::filesystem::exists(name_or_file, ignored))
    return read_spec(read_json(name_or_file), name_or_file);
  throw Error(ExitCode::bad_input, name_or_file, "is neither a study nor a file",
              suggest(name_or_file, std::vector<std::string_view>(ids.begin(), ids.end())));
}

namespace {

bool varies(const StudySpec& spec, std::string_view path) {
  const auto is_it = [&](const PathValues& axis) { return axis.path == path; };
  return std::any_of(spec.permute.begin(), spec.permute.end(), [&](const std::vector<PathValues>& product) {
    return std::any_of(product.begin(), product.end(), is_it);
  });
}

Json json_of(const std::vector<Coordinate>& base) {
  Json out = Json::object();
  for (const Coordinate& c : base) out[c.path] = to_json(c.value);
  return out;
}

void put(StudySpec& spec, const Coordinate& c) {
  if (c.path == "scene")  // its camera and its exposure are its own
    std::erase_if(spec.base, [](const Coordinate& b) { return b.path.starts_with("camera.") || b.path == "exposure"; });
  std::erase_if(spec.base, [&](const Coordinate& b) { return b.path == c.path; });
  spec.base.push_back({c.path, checked_value(c.path, c.value)});
}

}  // namespace

StudySpec with_given(StudySpec spec, const std::vector<Coordinate>& state, const std::vector<Coordinate>& explicitly) {
  if (!state.empty()) std::erase_if(spec.base, [](const Coordinate& b) { return b.path == "preset"; });
  const bool whole_ways = varies(spec, "preset");  // how to draw is then what varies
  for (const Coordinate& c : state)
    if (!varies(spec, c.path) && !(whole_ways && option(c.path).group == Group::method)) put(spec, c);
  for (const Coordinate& c : explicitly) {
    if (varies(spec, c.path))
      throw Error(ExitCode::bad_input, c.path, fmt::format("is what the study '{}' varies", spec.name),
                  "leave it out, or write a spec of your own without it");
    put(spec, c);
  }
  Json json = *spec.json;  // what a study's files say of it
  if (!state.empty() || !explicitly.empty()) json["base"] = json_of(spec.base);
  spec.json = std::make_shared<const Json>(std::move(json));
  return spec;
}

std::vector<BuiltinStudy> builtin_studies() {
  std::vector<BuiltinStudy> list;
  for (const std::string& id : data_file_ids(kFolder)) list.push_back({id, load_study(id).label});
  return list;
}

}  // namespace gbl
