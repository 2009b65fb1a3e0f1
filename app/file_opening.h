#pragma once
// What a file is that somebody gives to the lab, and what opening it changes.
#include <functional>
#include <string>

#include "renderer/frame/validate.h"
#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

// Settings from a JSON file, or from a PNG that carries them. Error(bad_input)
Settings read_state(const std::string& file);

// What it is by its name and, of JSON, by what is in it. Error(bad_input) where this program opens nothing of the kind.
enum class FileKind { model, state, rig };
FileKind kind_of_file(const std::string& file);

// Is it called like something that can be opened?
bool has_known_ending(const std::string& file);

bool is_picture(const std::string& file);  // PNG or OpenEXR
// One that brings no settings back: it can be compared with.
bool only_a_picture(const std::string& file);

struct FileOpening {
  std::string file;
  std::string scene;  // to be read first; empty: the one at hand stays
  // From those at hand, with the scene as it is then. The size stays: it is the window's.
  std::function<Settings(const Settings& now, const Scene&)> settings;
  bool whole = false;  // the view that is looked at is the file's, too
  std::string said;    // once it is open
};

// Of a scene by its name, "builtin:NAME" or a model's file.
FileOpening scene_opening(const std::string& name);
// Of a model, settings, a picture or a rig, as what it is. What this device lacks gives way to what it has, and that is
// said. Error(bad_input) for anything else, and for what no device can draw; the scene is not looked at yet.
FileOpening opening_of(const std::string& file, const DeviceLimits&);

}  // namespace gbl
