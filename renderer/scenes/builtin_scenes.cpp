#include "renderer/scenes/builtin_scenes.h"

#include <fmt/format.h>
#include <string>
#include <vector>

#include "renderer/base/error.h"

namespace gbl {
namespace {

constexpr std::string_view kPrefix = "builtin:";

constexpr BuiltinScene kScenes[] = {
    {"terrain", "Terrain", "a height field under a grid of lights (source 0), with an arch, a lamp-post and two cows",
     build_terrain,
     // Seed 16 by its colours; so bright that the pools show on brown ground and white paint is not burnt out.
     R"({"lights.seed": 16, "exposure": 1.8})"},
    {"two-cows", "Two cows", "one cow within the light, one far behind it and as large on the screen (source 0)",
     build_two_cows,
     R"({"attenuation": "linear", "ambient": 0.2, "background.fill": "colour",
         "background.colour": [0.10, 0.14, 0.22]})"},
    {"grid", "Nine backpacks", "nine of one object on a grid under 32 small lights (source 2)", build_grid,
     R"({"lights.count": 32, "attenuation": "quadratic", "ambient": 0.1, "exposure": 2, "background.fill": "black"})"},
    {"spheres", "Spheres", "many instances of one sphere, 40 materials, all three kinds of light (source 3)",
     build_spheres, R"({"attenuation": "linear", "ambient": 0.1, "background.fill": "black"})"},
    {"room", "Room", "mirror, glass and chrome, a shining sign and a brick wall under point and spot light (source 1)",
     build_room,
     R"({"shading.model": "ggx", "shading.exponent": "from-roughness",
         "attenuation": "windowed", "ambient": 0.15, "background.fill": "black"})",
     R"({"layout": "auto"})"},
    {"grove", "Grove", "a trunk and a house with normal maps, a sun and three lamps under the sky (source 4)",
     build_grove, R"({"attenuation": "ramp", "ambient": 0.3, "background.fill": "sky"})"},
    {"layers", "Layers", "sixteen layers one behind the other: forward shades them all, deferred the nearest",
     build_layers, R"({"lights.count": 64, "attenuation": "linear", "ambient": 0.2, "background.fill": "black"})"},
    {"hall", "Hall", "columns and coloured walls with normal maps under hundreds of small lights (source 2)",
     build_hall, R"({"lights.count": 768, "attenuation": "linear", "ambient": 0.14, "background.fill": "black"})"},
    {"city", "City at night", "12 x 12 blocks with street lamps and windows that are flagged as unlit (source 0)",
     build_city,
     R"({"attenuation": "linear", "ambient": 0.06, "background.fill": "colour",
         "background.colour": [0.006, 0.010, 0.024]})",
     R"({"layout": "auto"})"},
    {"bias", "Bias",
     "stairs, thin boards, slopes and cut-out leaves: where shadow maps fail, under a sun, a lamp and a spot",
     build_bias, R"({"attenuation": "windowed", "ambient": 0.12, "background.fill": "sky", "shadows": "all"})",
     R"({"layout": "auto"})"},
    {"yard", "Yard", "walls towards all sides, a ball and squashed ones: what a flat floor hides shows here",
     build_yard,
     R"({"lights.count": 16, "attenuation": "linear", "ambient": 0.15, "background.fill": "black", "exposure": 1.6})"},
};

std::vector<std::string_view> ids() {
  std::vector<std::string_view> list;
  for (const BuiltinScene& row : kScenes) list.emplace_back(row.id);
  return list;
}

}  // namespace

std::span<const BuiltinScene> builtin_scenes() { return kScenes; }

Scene load_scene(std::string_view name) {
  if (name.substr(0, kPrefix.size()) != kPrefix)
    throw Error(ExitCode::bad_input, name, "is not a built-in scene",
                fmt::format("known: {}{}", kPrefix, fmt::join(ids(), fmt::format(", {}", kPrefix))));
  const std::string_view id = name.substr(kPrefix.size());
  for (const BuiltinScene& row : kScenes)
    if (id == row.id) return row.build();
  throw Error(ExitCode::bad_input, name, "there is no such built-in scene", suggest(id, ids()));
}

}  // namespace gbl
