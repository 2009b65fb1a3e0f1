#include "renderer/options/settings_json.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/limits.h"

namespace gbl {
namespace {

// {"lights": {"count": 3}} -> the member at "lights.count", made on the way if need be.
Json& at_path(Json& root, std::string_view path) {
  Json* node = &root;
  while (true) {
    const size_t dot = path.find('.');
    node = &(*node)[std::string(path.substr(0, dot))];
    if (dot == std::string_view::npos) return *node;
    path.remove_prefix(dot + 1);
  }
}

// "camera" of "camera.fov".
bool is_group(const std::string& path) {
  for (const Option& o : options())
    if (std::string_view(o.path).starts_with(path + ".")) return true;
  return false;
}

void flatten(const Json& tree, const std::string& group, std::vector<Assignment>& patch) {
  for (const auto& [key, node] : tree.items()) {
    const std::string path = group.empty() ? key : group + "." + key;
    if (node.is_object() && is_group(path))
      flatten(node, path, patch);
    else
      patch.push_back({path, option_value(node)});
  }
}

std::string as_written(const Json& json) {
  // A strict dump throws at bytes that are not UTF-8.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// A double has no more digits than this; a longer number is no whole one to any option.
constexpr double kLargestWhole = 1LL << 53;

Number number_of(const Json& json) {
  Number n = json.get<double>();
  n.whole = json.is_number_integer() && std::abs(n.value) <= kLargestWhole;
  return n;
}

// Far deeper than any settings or lesson: what walks a JSON tree recurses and must not run out of stack.

Json::parser_callback_t no_deeper(std::string_view where) {
  return [where](int depth, Json::parse_event_t, const Json&) {
    if (depth > kMostJsonDepth)
      throw Error(ExitCode::bad_input, where, fmt::format("JSON nested more than {} deep", kMostJsonDepth));
    return true;
  };
}

Json migrated(Json json, std::string_view where) {
  if (!json.is_object()) throw Error(ExitCode::bad_input, where, "settings must be a JSON object");
  if (!json.contains("version")) throw Error(ExitCode::bad_input, where, "no \"version\": not a settings file");
  const Json& version = json["version"];
  if (!version.is_number_integer() || version.get<long>() < 1)
    throw Error(ExitCode::bad_input, where, fmt::format("version {} is not a whole number from 1", version.dump()));
  if (version.get<long>() > kSettingsVersion)
    throw Error(ExitCode::bad_input, where,
                fmt::format("written by a newer program: version {}, this one reads up to {}", version.dump(),
                            kSettingsVersion),
                "update the program");
  json.erase("version");
  return json;
}

}  // namespace

OptionValue option_value(const Json& json) {
  if (json.is_number()) return number_of(json);
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_array()) return Unfit{as_written(json)};
  OptionList list;
  for (const Json& part : json) list.push_back(option_value(part));
  return list;
}

Json to_json(const OptionValue& value) {
  assert(!std::holds_alternative<Unfit>(value));
  if (const auto* n = std::get_if<Number>(&value)) return n->whole ? Json(std::llround(n->value)) : Json(n->value);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  Json array = Json::array();
  for (const OptionValue& part : std::get<OptionList>(value)) array.push_back(to_json(part));
  return array;
}

std::string written(const OptionValue& value) {
  if (const auto* unfit = std::get_if<Unfit>(&value)) return unfit->written;
  const auto* list = std::get_if<OptionList>(&value);
  if (!list) return as_written(to_json(value));
  std::string parts;
  for (const OptionValue& part : *list) parts += (parts.empty() ? "" : ",") + written(part);
  return fmt::format("[{}]", parts);
}

std::string plain(const OptionValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text ? *text : written(value);
}

bool writable(const std::string& text) {
  try {
    static_cast<void>(Json(text).dump());
  } catch (const Json::type_error&) {
    return false;
  }
  return true;
}

Json to_json(const Settings& s) {
  Json json;
  json["version"] = kSettingsVersion;
  for (const Option& o : options()) at_path(json, o.path) = to_json(o.get(s));
  return json;
}

Settings from_json(const Json& json, std::string_view where, Settings base) {
  apply_patch(base, read_patch(migrated(json, where), where), where);
  return base;
}

std::string settings_text(const Settings& s) { return to_json(s).dump(2); }

namespace {

// Members of `all` that are not the same in `base`.
Json without_same(const Json& all, const Json& base) {
  Json out = Json::object();
  for (const auto& [name, value] : all.items()) {
    const auto at_base = base.find(name);
    if (at_base == base.end() || value.type() != at_base->type())
      out[name] = value;
    else if (value != *at_base)
      out[name] = value.is_object() ? without_same(value, *at_base) : value;
  }
  return out;
}

}  // namespace

std::string settings_link(const Settings& s) {
  const Json all = to_json(s);
  Json out = {{"version", all["version"]}};
  out.update(without_same(all, to_json(Settings{})));
  return out.dump();
}

Settings parse_settings(std::string_view text, std::string_view where) {
  return from_json(parse_json(text, where), where);
}

Settings read_settings(const std::filesystem::path& path) { return from_json(read_json(path), path.string()); }

std::vector<Assignment> read_patch(const Json& json, std::string_view where) {
  if (!json.is_object()) throw Error(ExitCode::bad_input, where, "a patch must be a JSON object");
  std::vector<Assignment> patch;
  flatten(json, "", patch);
  return patch;
}

std::vector<Assignment> parse_patch(std::string_view text, std::string_view where) {
  return read_patch(parse_json(text, where), where);
}

OptionValue parse_value(std::string_view text, std::string_view where) {
  const Json json = Json::parse(text, no_deeper(where), false);
  return json.is_discarded() ? OptionValue(std::string(text)) : option_value(json);
}

namespace {

// "1,2,3" as [1,2,3].
OptionValue listed(std::string_view text) {
  OptionList list;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    list.push_back(parse_value(text.substr(begin, end - begin), "--set"));
    begin = end + 1;
  }
  return list;
}

}  // namespace

void apply_assignment(Settings& s, std::string_view assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw Error(ExitCode::bad_input, "--set", fmt::format("'{}' has no '='", assignment), "write path=value");
  const std::string_view path = assignment.substr(0, equals), text = assignment.substr(equals + 1);
  const Option& o = option(path);
  const bool list = std::holds_alternative<OptionList>(o.get(s));
  if (text.empty())
    throw Error(ExitCode::bad_input, fmt::format("--set {}", path), "has no value",
                fmt::format("write {}={}", path,
                            list                   ? "[] for none"
                            : o.kind == Kind::text ? "\"\" for no text"
                                                   : "VALUE"));
  o.set(s, list && text[0] != '[' ? listed(text) : parse_value(text, "--set"), o);
}

Json parse_json(std::string_view text, std::string_view where) {
  try {
    return Json::parse(text, no_deeper(where));
  } catch (const nlohmann::json::parse_error& e) {
    const std::string_view before = text.substr(0, e.byte > 0 ? e.byte - 1 : 0);  // byte counts from 1
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 = 0
    throw Error(ExitCode::bad_input, fmt::format("{}:{}:{}", where, line, column), "not valid JSON",
                "fix the file near this place");
  } catch (const nlohmann::json::out_of_range&) {
    throw Error(ExitCode::bad_input, where, "a number is beyond the range of double", "fix the number");
  }
}

Json read_json(const std::filesystem::path& path) { return parse_json(read_text_file(path), path.string()); }

}  // namespace gbl
