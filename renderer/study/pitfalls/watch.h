#pragma once
// Does what is shown now sit in a known failure? From settings, camera and lights alone: nothing is drawn or measured.
#include <optional>
#include <span>
#include <string>

#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

struct Watched {
  std::string pitfall;   // its id
  std::string sentence;  // "light 37: the camera is inside, and only front faces are drawn"
};

// aspect: of the picture. The lights are those of the settings. Nothing: no failure that is watched for.
std::optional<Watched> watched(const Settings&, std::span<const Light>, double aspect);

}  // namespace gbl
