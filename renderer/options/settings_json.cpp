#include "renderer/options/settings_json.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "renderer/base/error.h"

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

void apply_tree(Settings& s, const Json& tree, const std::string& group, std::string_view where) {
  for (const auto& [key, node] : tree.items()) {
    const std::string path = group.empty() ? key : group + "." + key;
    if (node.is_object() && is_group(path)) {
      apply_tree(s, node, path, where);
      continue;
    }
    try {
      const Option& o = option(path);
      o.set(s, node, o);
    } catch (const Error& e) {
      throw Error(e.code(), where, e.what());
    }
  }
}

// Far deeper than any settings or lesson: what walks a JSON tree recurses and must not run out of stack.
constexpr int kMaxDepth = 64;

Json::parser_callback_t no_deeper(std::string_view where) {
  return [where](int depth, Json::parse_event_t, const Json&) {
    if (depth > kMaxDepth)
      throw Error(ExitCode::bad_input, where, fmt::format("JSON nested more than {} deep", kMaxDepth));
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

Json to_json(const Settings& s) {
  Json json;
  json["version"] = kSettingsVersion;
  for (const Option& o : options()) at_path(json, o.path) = o.get(s);
  return json;
}

Settings from_json(const Json& json, std::string_view where, Settings base) {
  apply_tree(base, migrated(json, where), "", where);
  return base;
}

void apply_patch(Settings& s, const Json& patch, std::string_view where) {
  if (!patch.is_object()) throw Error(ExitCode::bad_input, where, "a patch must be a JSON object");
  Settings changed = s;  // all or nothing
  apply_tree(changed, patch, "", where);
  s = changed;
}

void apply_assignment(Settings& s, std::string_view assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw Error(ExitCode::bad_input, "--set", fmt::format("'{}' has no '='", assignment), "write path=value");
  const std::string text(assignment.substr(equals + 1));
  Json value = Json::parse(text, no_deeper("--set"), false);
  if (value.is_discarded()) value = text;
  const Option& o = option(assignment.substr(0, equals));
  o.set(s, value, o);
}

Json parse_json(std::string_view text, std::string_view where) {
  try {
    return Json::parse(text, no_deeper(where));
  } catch (const nlohmann::json::parse_error& e) {
    const std::string_view before = text.substr(0, e.byte > 0 ? e.byte - 1 : 0);  // byte counts from 1
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 = 0
    throw Error(ExitCode::bad_input, fmt::format("{}:{}:{}", where, line, column), "not valid JSON",
                "mend the file near this place");
  } catch (const nlohmann::json::out_of_range&) {
    throw Error(ExitCode::bad_input, where, "a number is beyond the range of double", "mend the number");
  }
}

Json read_json(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  if (!file || !(text << file.rdbuf()))
    throw Error(ExitCode::bad_input, path.string(), "cannot be read", "check the path and its permissions");
  return parse_json(text.str(), path.string());
}

}  // namespace gbl
