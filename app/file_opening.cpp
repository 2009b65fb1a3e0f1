#include "app/file_opening.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/gbuffer/layout_file.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/image.h"
#include "renderer/scenes/rig.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

// Whatever it is called, or at least called so. What is read from a pipe is gone: there the name tells.
bool is_png(const std::string& file) {
  char begin[4] = {};
  std::error_code none;
  if (fs::is_regular_file(file, none)) std::ifstream(file, std::ios::binary).read(begin, sizeof begin);
  return std::string_view(begin, sizeof begin) == "\x89PNG" || ending_of(file) == ".png";
}

void require_file(const std::string& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  const auto refuse = [&](const std::string& what, const char* fix) {
    throw Error(ExitCode::bad_input, file, what, fix);
  };
  if (error) refuse(fmt::format("cannot be read: {}", error.message()), "check the path");
  if (fs::is_directory(status)) refuse("is a folder", "name a file in it");
  if (!fs::is_regular_file(status)) refuse("is no file", "give one that is kept on disk");
}

}  // namespace

bool is_picture(const std::string& file) { return is_png(file) || ending_of(file) == ".exr"; }

bool only_a_picture(const std::string& file) {
  if (!is_png(file)) return is_picture(file);
  try {
    return read_png_text(file, kSettingsKey).empty();
  } catch (const Error&) {
    return false;  // whoever opens it says what is wrong
  }
}

namespace {

FileOpening rig(const std::string& file) {
  const size_t lights = rig_lights(file).size();
  return {.file = file,
          .settings =
              [file](Settings now, const Scene&) {
                now.lights.rig = file;
                now.lights.source = LightSource::rig;
                now.lights.only = -1;
                return now;
              },
          .said = fmt::format("{}: {} light{}", file, lights, lights == 1 ? "" : "s")};
}

FileOpening state(const std::string& file, const DeviceLimits& limits) {
  const Nearest here = nearest_with(limits.features, read_state(file));
  const Settings& s = here.settings;
  Settings without_file = s;
  without_file.layout_file.clear();
  require_valid(without_file, limits);
  if (!s.lights.rig.empty()) rig_lights(s.lights.rig);
  std::string said = fmt::format("{}: its settings are shown", file);
  if (!s.layout_file.empty())
    said += fmt::format(", but for its layout file, which is shader text; to run that: --layout-file {}",
                        path_of_layout_file(s.layout_file));
  for (const std::string& sentence : here.sentences) said += "; " + sentence;
  return {.file = file,
          .scene = s.scene,
          .settings =
              [s, without_file](const Settings& now, const Scene&) {
                Settings out = s.layout_file == now.layout_file ? s : without_file;  // a file runs nothing unasked
                out.size = now.size;
                return out;
              },
          .whole = true,
          .said = std::move(said)};
}

// A rig's lights are a list; those of settings are options.
bool is_rig(const std::string& file) {
  const Json json = read_json(file);
  return json.is_object() && json.contains("lights") && json["lights"].is_array();
}

}  // namespace

Settings read_state(const std::string& file) {
  if (!is_png(file)) return read_settings(file);
  const std::string text = read_png_text(file, kSettingsKey);
  if (text.empty())
    throw Error(ExitCode::bad_input, file, "is a PNG without settings in it",
                "give one that `render` or F12 wrote, as it was written");
  return parse_settings(text, file);
}

bool has_known_ending(const std::string& file) {
  constexpr std::string_view kEndings[] = {".gltf", ".glb", ".json", ".png", ".exr"};
  return std::find(std::begin(kEndings), std::end(kEndings), ending_of(file)) != std::end(kEndings);
}

FileOpening scene_opening(const std::string& name) {
  return {.file = name, .scene = name, .settings = [name](const Settings& now, const Scene& scene) {
            return moved_to(now, name, scene);
          }};
}

FileOpening opening_of(const std::string& file, const DeviceLimits& limits) {
  switch (kind_of_file(file)) {
    case FileKind::model: return scene_opening(file);
    case FileKind::state: return state(file, limits);
    case FileKind::rig: break;
  }
  return rig(file);
}

FileKind kind_of_file(const std::string& file) {
  require_file(file);
  const std::string ending = ending_of(file);
  if (ending == ".gltf" || ending == ".glb") return FileKind::model;
  if (is_png(file)) return FileKind::state;
  if (ending == ".json") return is_rig(file) ? FileKind::rig : FileKind::state;
  throw Error(ExitCode::bad_input, file, "is nothing that this program opens",
              "give a model (.gltf, .glb), settings or a rig (.json), or a picture with settings in it (.png)");
}

}  // namespace gbl
