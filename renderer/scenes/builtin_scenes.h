#pragma once
// The scenes that come with the lab, built by code. One row each.
#include <span>
#include <string_view>

#include "renderer/scene/scene.h"

namespace gbl {

struct BuiltinScene {
  const char* id;  // "terrain": builtin:terrain
  const char* label;
  const char* help;
  Scene (*build)();
  const char* look = "{}";     // of its truth, as a patch: its lights' count, its falloff, its background
  const char* drawing = "{}";  // how it is drawn where nothing was chosen, as a patch
};

std::span<const BuiltinScene> builtin_scenes();

// "builtin:terrain" -> the scene; files are opened by scene_look.h. An unknown name is an Error that lists the known ones.
Scene load_scene(std::string_view name);

Scene build_terrain();
Scene build_two_cows();
Scene build_grid();
Scene build_spheres();
Scene build_room();
Scene build_grove();
Scene build_layers();
Scene build_hall();
Scene build_city();
Scene build_yard();
Scene build_bias();

}  // namespace gbl
