// From a figure's recipe to settings, and along its keys.
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "renderer/figures/figure_spec.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/camera_text.h"
#include "renderer/options/presets.h"

namespace gbl {
namespace {

constexpr const char* kOrientation = "camera.orientation";

// Empty: no number.
std::optional<double> number(const OptionValue& v) {
  const auto* n = std::get_if<Number>(&v);
  return n ? std::optional(n->value) : std::nullopt;
}

// whole: of an option that takes whole numbers only
OptionValue between(const OptionValue& a, const OptionValue& b, double share, bool whole) {
  if (const auto x = number(a), y = number(b); x && y) {
    const double value = *x + (*y - *x) * share;
    return whole ? OptionValue(static_cast<long long>(std::llround(value))) : OptionValue(value);
  }
  const auto* from = std::get_if<OptionList>(&a);
  const auto* to = std::get_if<OptionList>(&b);
  if (!from || !to || from->size() != to->size()) return a;
  OptionList out;
  for (size_t i = 0; i < from->size(); ++i) out.push_back(between((*from)[i], (*to)[i], share, whole));
  return out;
}

// Shoemake 1985, "Animating Rotation with Quaternion Curves".
OptionValue turned(const OptionValue& a, const OptionValue& b, double share) {
  Settings from, to;
  apply_patch(from, {{kOrientation, a}}, kOrientation), apply_patch(to, {{kOrientation, b}}, kOrientation);
  from.camera.orientation = glm::slerp(from.camera.orientation, to.camera.orientation, share);
  return option(kOrientation).get(from);
}

}  // namespace

Settings settings_of(const FigureRecipe& r, glm::ivec2 size, std::string_view where) {
  Settings s = preset(r.preset.empty() ? "start" : r.preset).make();
  if (!r.scene.empty()) {
    apply_scene(s, r.scene, *open_scene(r.scene));
    if (r.preset.empty()) apply_drawing(s, r.scene);
  }
  if (!r.camera.empty()) apply_camera(s, r.camera, where);
  s.size = size;
  apply_patch(s, r.set, where);
  return s;
}

std::vector<Assignment> patch_at(const FigureFrames& f, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * double(f.keys.size() - 1);
  const size_t first = std::min(static_cast<size_t>(at), f.keys.size() - 2);
  std::vector<Assignment> patch = f.keys[first];
  const double rest = at - double(first);
  for (size_t i = 0; i < patch.size(); ++i) {
    const OptionValue& next = f.keys[first + 1][i].value;
    if (rest >= 1)
      patch[i].value = next;
    else if (patch[i].path == kOrientation)
      patch[i].value = turned(patch[i].value, next, rest);
    else
      patch[i].value = between(patch[i].value, next, rest, option(patch[i].path).kind == Kind::integer);
  }
  return patch;
}

}  // namespace gbl
