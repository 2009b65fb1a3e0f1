#include "renderer/builtin_scenes.h"

#include <fmt/format.h>
#include <string>
#include <vector>

#include "renderer/error.h"

namespace gbl {
namespace {

constexpr std::string_view kPrefix = "builtin:";

constexpr BuiltinScene kScenes[] = {
    {"terrain", "Terrain", "a height field under a grid of lights (source 0), with an arch, a lamp-post and two cows",
     build_terrain},
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
