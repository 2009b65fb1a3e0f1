#pragma once
// Opening a scene by name, and the settings that come with it: its camera, its lights, its look.
#include <memory>
#include <string_view>

#include "renderer/gltf/scene_gltf.h"
#include "renderer/options/settings.h"

namespace gbl {

// "builtin:NAME" or a .gltf or .glb file; files get an exposure, ranges for lights without one and a box for generated
// lights. Error(bad_input) with what is wrong.
std::shared_ptr<const Scene> open_scene(std::string_view name, const LoadProgress* = nullptr);

// Camera, lights and look of this scene over the settings; how things are drawn stays, unless the look names it.
void apply_scene(Settings&, std::string_view name, const Scene&);

// What looks may have changed, back to the defaults: so that no scene keeps the look of the one before.
void reset_look(Settings&);

}  // namespace gbl
