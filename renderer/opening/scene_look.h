#pragma once
// Opening a scene by name, and the settings that come with it: its camera, its lights, its look.
#include <memory>
#include <string_view>

#include "renderer/gltf/scene_gltf.h"
#include "renderer/options/settings.h"

namespace gbl {

bool is_file(std::string_view scene);  // or else "builtin:NAME"

// "builtin:NAME" or a .gltf or .glb file; files get an exposure, lights where they have none and a box for generated
// lights. Error(bad_input) with what is wrong.
std::shared_ptr<const Scene> open_scene(std::string_view name, const LoadProgress* = nullptr);

// The one rule of how scenes and presets combine: a scene brings what is true (its camera, its lights, its look), and
// how it is drawn stays as it is.
void apply_scene(Settings&, std::string_view name, const Scene&);

// How the scene is drawn where nobody has chosen anything, that is, no preset: over the settings.
void apply_drawing(Settings&, std::string_view name);

// From one scene to the next: what was chosen of the drawing stays, and where nothing was it comes with the scene.
Settings moved_to(const Settings& from, std::string_view name, const Scene&);

// What there is to say of a scene that is shown in these lights, a line each.
std::vector<std::string> notes_of(const Scene&, LightSource);

}  // namespace gbl
