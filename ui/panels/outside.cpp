// Shift+I: the frame from outside: its camera, frustum and near plane, the picked light's mesh as it is drawn, and what the
// G-buffer knows of the scene as points in the main view's colours.
#include <algorithm>
#include <fmt/format.h>

#include "ui/camera_motion.h"
#include "ui/panels/side_panel.h"

namespace gbl::ui {
namespace {

constexpr double kTurnDegrees = 6, kNearer = 0.8;

enum class Target { light, near_plane, scene };
constexpr const char* kTargets[] = {"the picked light and the camera", "the camera's near plane", "the whole scene"};

struct OutsideState : PanelState {
  double yaw_deg = 35, pitch_deg = -25;  // of the look, against the camera's own
  double scale = 1;                      // of the distance that shows all of the target
  Target target = Target::light;
};

// A ball around what is to be seen.
struct Ball {
  glm::dvec3 centre;
  double radius;
};

Ball target_of(const FrameContext& f) {
  const Camera& c = f.settings.camera;
  const Bounds& b = f.input.scene.bounds;
  const Ball near{c.position + c.forward() * c.near, 2 * c.near * near_corner_factor(c, 16.0 / 9)};
  switch (f.state.of<OutsideState>().target) {
    case Target::near_plane: return near;
    case Target::scene: return {(b.min + b.max) / 2.0, glm::length(b.max - b.min) / 2};
    case Target::light: break;
  }
  const std::optional<Light> light = picked_light(f.settings, f.input.lights);
  if (!light || light->range >= kEndless) return {(b.min + b.max) / 2.0, glm::length(b.max - b.min) / 2};
  const double apart = glm::distance(light->position, c.position);
  return {(light->position + c.position) / 2.0, apart / 2 + light->range};
}

Camera outside_camera(const FrameContext& f) {
  const OutsideState& s = f.state.of<OutsideState>();
  const Ball ball = target_of(f);
  const double yaw = yaw_pitch_of(f.settings.camera.orientation).x + s.yaw_deg;
  Camera out;
  out.orientation = orientation_from_yaw_pitch(yaw, s.pitch_deg);
  out.fov = 45;
  const double distance = std::max(1e-6, s.scale * ball.radius / std::sin(glm::radians(out.fov / 2)));
  out.position = ball.centre - out.forward() * distance;
  const Bounds& b = f.input.scene.bounds;
  out.near = distance / 500;
  out.far = 2 * (distance + glm::length(b.max - b.min)) + glm::distance(ball.centre, (b.min + b.max) / 2.0);
  return out;
}

std::string in_words(const FrameContext& f) {
  const Camera& c = f.settings.camera;
  const std::optional<Light> light = picked_light(f.settings, f.input.lights);
  if (!light || light->range >= kEndless) return fmt::format("The near plane is {:.4g} units from the camera.", c.near);
  const double distance = glm::distance(light->position, c.position);
  return fmt::format(
      "Light {} of range {:.4g} is {:.4g} away, d/r {:.2f}: the camera is {}. Its sphere begins {:.4g} from the "
      "camera, the "
      "near plane stands at {:.4g}.",
      f.settings.view.pick, light->range, distance, distance / light->range,
      distance < light->range ? "inside" : "outside", std::abs(distance - light->range), c.near);
}

void turn(FrameContext& f, const KeyEvent& e) {
  OutsideState& s = f.state.of<OutsideState>();
  if (e.key == "Left") s.yaw_deg -= kTurnDegrees;
  if (e.key == "Right") s.yaw_deg += kTurnDegrees;
  if (e.key == "Up") s.pitch_deg = std::max(-89.0, s.pitch_deg - kTurnDegrees);
  if (e.key == "Down") s.pitch_deg = std::min(89.0, s.pitch_deg + kTurnDegrees);
}
void go_nearer(FrameContext& f, const KeyEvent& e) {
  f.state.of<OutsideState>().scale *= e.key == "PgUp" ? kNearer : 1 / kNearer;
}
void next_target(FrameContext& f, const KeyEvent&) {
  OutsideState& s = f.state.of<OutsideState>();
  s.target = static_cast<Target>((static_cast<int>(s.target) + 1) % static_cast<int>(std::size(kTargets)));
  s.scale = 1;
  say(f, {fmt::format("From outside: {}.", kTargets[static_cast<int>(s.target)]), ""});
}
void look_again(FrameContext& f, const KeyEvent&) {
  OutsideState& s = f.state.of<OutsideState>();
  s.yaw_deg = 35, s.pitch_deg = -25, s.scale = 1;
}

constexpr PanelKey kKeys[] = {{"Left Right Up Down", "turn", turn, true},
                              {"PgUp PgDn", "nearer, farther", go_nearer, true},
                              {"T", "light, near plane, scene", next_target},
                              {"R", "as at first", look_again}};

void use_mouse(FrameContext& f, const Box& picture) {
  OutsideState& s = f.state.of<OutsideState>();
  hit_area("outside.picture", picture);
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    s.yaw_deg -= 0.4 * double(io.MouseDelta.x);
    s.pitch_deg = std::clamp(s.pitch_deg - 0.4 * double(io.MouseDelta.y), -89.0, 89.0);
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) s.scale *= std::pow(kNearer, double(io.MouseWheel));
}

void draw_outside(FrameContext& f, Painter& p, const Box& box) {
  Shelf shelf{box.inset(std::round(14 * f.layout.unit)), std::round(5 * f.layout.unit)};
  const float px = f.type.body, small = f.type.small;
  p.text_in(shelf.below(line_height(f.type.large)), f.type.large, theme().accent,
            fmt::format("From outside: {}", kTargets[static_cast<int>(f.state.of<OutsideState>().target)]));
  const Box keys = shelf.above(2 * line_height(small));
  const Box words = shelf.above(3 * line_height(px));
  const Box picture = shelf.room;
  if (picture.height() < 4 * px || picture.width() < 4 * px) return;
  f.requests.outside = OutsideRequest{
      outside_camera(f), {static_cast<int>(picture.width()), static_cast<int>(picture.height())}, f.layout.main};
  use_mouse(f, picture);
  if (const ViewImage& image = f.input.outside; image.texture)
    p.list().AddImage(reinterpret_cast<ImTextureID>(image.texture), picture.min, picture.max, {0, 1}, {1, 0});
  else
    p.text_in(picture, px, theme().text, "drawing", true);
  p.outline(picture, theme().line, 1);
  p.text_in(words, px, theme().text,
            in_words(f) +
                " Yellow: the camera and what it sees. Blue: its near plane. The mesh is as the method draws it; "
                "faces that it culls or cuts are left out, their wire stays.",
            true);
  draw_panel_keys(f, p, keys, kKeys);
}

}  // namespace

extern const Panel kOutsidePanel = {
    .key = "Shift I",
    .id = "outside",
    .help = "the frame from outside: frustum, near plane, the picked light's mesh, points",
    .place = Place::beside,
    .box = side_box,
    .draw = draw_outside,
    .keys = kKeys,
    .make = make_panel_state<OutsideState>};

}  // namespace gbl::ui
