// The plane through the camera's view axis and the picked light: the light's range, its mesh's reach, the camera's frustum and near
// plane. To scale.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/figures/drawing_parts.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/light/light_volume.h"
#include "renderer/opening/scene_look.h"
#include "renderer/picture/svg.h"

namespace gbl {
namespace {

constexpr glm::dvec2 kPage{640, 400};
constexpr double kMargin = 56;

std::vector<glm::dvec2> circle(glm::dvec2 middle, double radius) {
  std::vector<glm::dvec2> out;
  for (int k = 0; k < 180; ++k)
    out.push_back(middle +
                  radius * glm::dvec2(std::cos(k * std::numbers::pi / 90), std::sin(k * std::numbers::pi / 90)));
  return out;
}

Light picked(const Settings& s) {
  const std::vector<Light> lights = all_lights_of(s, *open_scene(s.scene));
  if (s.view.pick < 0 || s.view.pick >= int(lights.size()))
    throw Error(ExitCode::bad_input, "view.pick", fmt::format("there is no light {}", s.view.pick),
                fmt::format("lights are 0 to {}", int(lights.size()) - 1));
  const Light& light = lights[static_cast<size_t>(s.view.pick)];
  if (!bounded(light)) throw Error(ExitCode::bad_input, "view.pick", "this light has no end: it has no volume");
  return light;
}

// Half of what is seen in the plane of the view axis and a point: at distance 1, of an orthographic camera anywhere.
double half_extent_towards(const Camera& c, double aspect, const glm::dvec3& to) {
  const double half_height = c.half_height(aspect), x = std::abs(glm::dot(to, c.right())),
               y = std::abs(glm::dot(to, c.up()));
  const double aside = std::hypot(x, y);
  if (aside == 0) return half_height;
  return std::min(x > 0 ? half_height * aspect * aside / x : INFINITY, y > 0 ? half_height * aside / y : INFINITY);
}

}  // namespace

std::string draw_light_from_side(const Settings& s, const std::string& title) {
  const Light light = picked(s);
  const Camera& c = s.camera;
  const glm::dvec3 to = glm::dvec3(light.position) - c.position;
  const double along = glm::dot(to, c.forward()), aside = glm::length(to - along * c.forward());
  const double mesh =
      volume_reach(light, volume_scale(s.lights.volume.fit, s.lights.volume.level, volume_shape(light)), 0);
  const double reach = std::max(mesh, light.range);
  const double left = std::min(0.0, along - reach), right = std::max(c.near * 1.5, along + reach), high = aside + reach;
  const double scale = std::min((kPage.x - 2 * kMargin) / (right - left), (kPage.y - 2 * kMargin) / (2 * high));
  const auto at = [&](double x, double y) {
    return glm::dvec2(kPage.x / 2 + (x - (left + right) / 2) * scale, kPage.y / 2 - y * scale);
  };
  const double slope = half_extent_towards(c, double(s.size.x) / s.size.y, to);
  const double at_eye = c.orthographic() ? slope : 0,
               grows = c.orthographic() ? 0 : slope;  // half the frustum's height
  std::string body = svg_text({20, 28}, title, SvgAnchor::start, 16);
  const glm::dvec2 frustum[] = {at(right, at_eye + grows * right), at(0, at_eye), at(0, -at_eye),
                                at(right, -at_eye - grows * right)};
  body += svg_path(frustum, false, {"#888", 1.5, "", "#f4f4f4"});
  body += svg_path(circle(at(along, aside), mesh * scale), true, {"#a40000", 1.5, "6 4"});
  body += svg_path(circle(at(along, aside), light.range * scale), true, {"#204a87", 2});
  body += svg_line(at(c.near, -at_eye - grows * c.near), at(c.near, at_eye + grows * c.near), {"#4e9a06", 3});
  body += svg_path(circle(at(0, 0), 4), true, {"#222", 1, "", "#222"}) +
          svg_path(circle(at(along, aside), 3), true, {"#204a87", 1, "", "#204a87"});
  const double apart = glm::length(to);
  body += svg_text(
      {20, kPage.y - 30},
      fmt::format(
          "light {}: range {:.4g} (solid), its mesh reaches {:.4g} (dashed); {:.4g} from the camera, which is {}",
          s.view.pick, light.range, mesh, apart, apart < light.range ? "inside" : "outside"),
      SvgAnchor::start, 12);
  body +=
      svg_text({20, kPage.y - 12}, fmt::format("near plane at {:.4g} (thick), field of view {:.4g}°", c.near, c.fov),
               SvgAnchor::start, 12, "#555");
  return svg_page({int(kPage.x), int(kPage.y)}, body);
}

}  // namespace gbl
