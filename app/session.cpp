#include "app/session.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "renderer/base/json.h"
#include "renderer/gbuffer/layout_file.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/data_file.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

// As it is where no absolute path can be found or written: a folder's name may be any bytes, JSON's texts are UTF-8.
std::string absolute(const std::string& file) {
  std::error_code error;
  const std::string path = std::filesystem::absolute(file, error).lexically_normal().string();
  return error || !writable(path) ? file : path;
}

Json to_json(const ui::Snapshot& s) {
  Settings settings = s.settings;
  if (is_file(settings.scene)) settings.scene = absolute(settings.scene);
  if (!settings.lights.rig.empty()) settings.lights.rig = absolute(settings.lights.rig);
  // The next window runs what stands here, so what this one did not run is left out.
  if (!may_run_layout_file(settings.layout_file)) settings.layout_file.clear();
  if (!settings.layout_file.empty()) settings.layout_file = absolute(settings.layout_file);
  Json json;
  json["large"] = s.large;
  json["settings"] = gbl::to_json(settings);
  return json;
}

[[noreturn]] void refuse(std::string_view where, const std::string& what) {
  throw Error(ExitCode::bad_input, where, what);
}

ui::Snapshot read_snapshot(const Json& json, const std::string& where) {
  only_members(json, {"large", "settings"}, where);
  if (!json.contains("settings")) refuse(where, "\"settings\" are missing");
  if (!json.contains("large") || !json["large"].is_boolean()) refuse(where, "\"large\" is not true or false");
  Settings settings = from_json(json["settings"], where);
  if (!settings.layout_file.empty()) allow_layout_file(settings.layout_file);  // this program wrote it: it ran before
  return {std::move(settings), json["large"].get<bool>()};
}

ui::Bookmarks read_bookmarks(const Json& json, const std::string& where) {
  if (!json.is_object()) refuse(where, "must be a JSON object");
  ui::Bookmarks bookmarks;
  for (const auto& [key, value] : json.items()) {
    if (key.size() != 1 || key[0] < '1' || key[0] > '9') refuse(where, fmt::format("\"{}\" is not one of 1 to 9", key));
    bookmarks[static_cast<size_t>(key[0] - '1')] = read_snapshot(value, fmt::format("{} {}", where, key));
  }
  return bookmarks;
}

std::vector<std::string> read_recent(const Json& json, const std::string& where) {
  if (!json.is_array()) refuse(where, "must be a JSON array");
  std::vector<std::string> recent;
  for (const Json& file : json) {
    if (!file.is_string()) refuse(where, fmt::format("{} is not a text in quotes", file.dump()));
    recent.push_back(file.get<std::string>());
  }
  if (recent.size() > kMostRecent) recent.resize(kMostRecent);
  return recent;
}

}  // namespace

void remember(std::vector<std::string>& recent, const std::string& file) {
  const std::string path = absolute(file);
  if (!writable(path)) return;
  recent.erase(std::remove(recent.begin(), recent.end(), path), recent.end());
  recent.insert(recent.begin(), path);
  if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

std::string session_text(const Session& s) {
  Json json;
  json["version"] = kSessionVersion;
  if (s.last) json["last"] = to_json(*s.last);
  json["bookmarks"] = Json::object();
  for (size_t i = 0; i < s.bookmarks.size(); ++i)
    if (s.bookmarks[i]) json["bookmarks"][std::to_string(i + 1)] = to_json(*s.bookmarks[i]);
  json["recent"] = s.recent;
  return json.dump(1) + "\n";
}

Session parse_session(std::string_view text, std::string_view where) {
  const Json json = parse_json(text, where);
  if (!json.is_object()) refuse(where, "must be a JSON object");
  check_file_version(json, kSessionVersion, "session", where);
  only_members(json, {"version", "last", "bookmarks", "recent"}, where);
  const auto place = [&](const char* member) { return fmt::format("{}: {}", where, member); };
  Session s;
  if (json.contains("last")) s.last = read_snapshot(json["last"], place("last"));
  if (json.contains("bookmarks")) s.bookmarks = read_bookmarks(json["bookmarks"], place("bookmarks"));
  if (json.contains("recent")) s.recent = read_recent(json["recent"], place("recent"));
  return s;
}

}  // namespace gbl
