// The panels with the pictures: which are on screen, what the mouse does to them, and the texts over the large one.
#include <cmath>
#include <fmt/format.h>

#include "ui/camera_motion.h"
#include "ui/state.h"
#include "ui/view_panel.h"

namespace gbl::ui {
namespace {

constexpr double kWheelFactor = 1.25;  // of the zoom, a notch

// Where the mouse is, across the panel's picture; a whole screen pixel: its centre is meant.
glm::dvec2 mouse_in(const Box& picture) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return {(mouse.x + 0.5 - picture.min.x) / picture.width(), (mouse.y + 0.5 - picture.min.y) / picture.height()};
}

void hover(FrameContext& f, View v, const Box& picture) {
  const glm::dvec2 inside = mouse_in(picture);
  if (inside.x < 0 || inside.y < 0 || inside.x >= 1 || inside.y >= 1) return;
  f.state.hovered = v;
  f.state.hovered_pixel = glm::ivec2(on_picture(zoom_of(f, v), inside) * glm::dvec2(f.frame_size()));
}

void let_go_or_hold(FrameContext& f) {
  if (!f.state.hovered_pixel) return;
  if (f.held_pixel() == f.state.hovered_pixel)
    f.state.held_at.reset();
  else
    f.hold(*f.state.hovered_pixel);
}

void drag(FrameContext& f, View v, const Box& picture, bool look_around) {
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  if (by.x == 0 && by.y == 0) return;
  if (!look_around) {
    const Zoom moved = panned(zoom_of(f, v), {by.x / picture.width(), by.y / picture.height()});
    set_zoom(f, v, moved, ImGui::GetIO().KeyShift);
  } else if (v == f.layout.main) {
    f.state.glide.reset();
    f.settings.camera = turned(f.settings.camera, {by.x, by.y}, picture.height());
  }
}

// The table of the mouse (keys.cpp) in the order of its rows.
void use_mouse(FrameContext& f, View v, const char* id, const Box& panel, const Box& picture) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool clicked = hit_area(id, panel);
  const bool dragged = io.MouseDragMaxDistanceSqr[0] > 9;
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  if (ImGui::IsItemFocused() && (io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard)) f.state.focused = v;
  if (hovered) hover(f, v, picture);
  const bool second = io.MouseClickedLastCount[0] > 1;  // of a double click, which holds nothing
  if (clicked && !dragged && !second) {
    f.settings.view.main = row(v).id;
    f.state.held_before = f.state.held_at;
    let_go_or_hold(f);
  }
  if (hovered && ImGui::IsMouseClicked(1)) f.state.held_at.reset();
  if (hovered && ImGui::IsMouseDoubleClicked(0)) {
    f.state.large = !f.state.large;
    f.state.held_at = f.state.held_before;
  }
  if (held && dragged) drag(f, v, picture, zoom_of(f, v).whole());
  if (hovered && ImGui::IsMouseClicked(2)) f.state.panning = v;
  if (!io.MouseDown[2]) f.state.panning.reset();
  if (f.state.panning == v) drag(f, v, picture, false);
  if (hovered && io.MouseWheel != 0)
    set_zoom(
        f, v,
        zoomed_at(zoom_of(f, v), std::pow(kWheelFactor, double(io.MouseWheel)), mouse_in(picture), most_zoom(f, panel)),
        io.KeyShift);
}

// The same pixel in every picture: small, dark and light, so that it shows on both.
void mark_pixel(FrameContext& f, View v, const Box& picture, glm::ivec2 pixel) {
  const glm::vec2 at(in_panel(zoom_of(f, v), (glm::dvec2(pixel) + 0.5) / glm::dvec2(f.frame_size())));
  if (at.x < 0 || at.y < 0 || at.x > 1 || at.y > 1) return;
  const ImVec2 c{picture.min.x + at.x * picture.width(), picture.min.y + at.y * picture.height()};
  const float far = 8 * f.layout.unit, near = 3 * f.layout.unit;
  for (const auto& [colour, width] : {std::pair(IM_COL32(0, 0, 0, 255), 3.0f), std::pair(on_picture().text, 1.0f)})
    for (const float sign : {-1.0f, 1.0f}) {
      f.painter.list().AddLine({c.x + sign * near, c.y}, {c.x + sign * far, c.y}, colour, width);
      f.painter.list().AddLine({c.x, c.y + sign * near}, {c.x, c.y + sign * far}, colour, width);
    }
}

// A line with a dark backing, its lower left corner at `at`; returns its height.
float backed_line(FrameContext& f, ImVec2 at, float width, ImU32 colour, float px, std::string_view text) {
  const float pad = std::round(px * 0.4f);
  px = f.painter.fit(text, {width - 2 * pad, px * 8}, px, true);
  const ImVec2 size = text_size(text, px, width - 2 * pad);
  f.painter.fill({{at.x, at.y - size.y - 2 * pad}, {at.x + size.x + 2 * pad, at.y}}, on_picture().backing);
  f.painter.text({at.x + pad, at.y - size.y - pad}, px, colour, text, width - 2 * pad);
  return size.y + 2 * pad;
}

// Over the large picture: d/r while and after gliding, the caption where the strip is taken, the app's banner.
void draw_texts_on_main(FrameContext& f, const Box& panel) {
  ImVec2 at{panel.min.x + 4, panel.max.y - 4 - f.layout.foot};
  const std::optional<Light> light = picked_light(f.settings, f.input.lights);
  if (f.state.show_distance && light) {
    const double distance = distance_in_ranges(f.settings.camera, *light);
    at.y -= backed_line(f, at, panel.width() - 8, on_picture().accent, f.type.large,
                        fmt::format("light {}   d/r {:.2f}   {}", f.settings.view.pick, distance,
                                    distance < 1 ? "the camera is inside" : "the camera is outside")) +
            4;
  }
  if (f.state.present) return;  // it says nothing but its caption
  if (f.state.lesson && f.state.caption) {
    const Sentence& s = f.state.caption->sentence;
    if (!s.pitfall.empty())
      at.y -= backed_line(f, at, panel.width() - 8, on_picture().unsound, f.type.body,
                          fmt::format("{} UNSOUND: {}.", kUnsoundSign, s.pitfall));
    at.y -= backed_line(f, at, panel.width() - 8, on_picture().text, f.type.body, s.text) + 4;
  }
  if (!f.input.banner.empty()) backed_line(f, at, panel.width() - 8, on_picture().accent, f.type.body, f.input.banner);
}

void draw_panel(FrameContext& f, View v, const Box& panel) {
  const ViewImage& image = f.input.images[static_cast<size_t>(v)];
  f.requests.visible[static_cast<size_t>(v)] = why_missing(v, f.stored).empty();
  PanelLook look;
  look.px = v == f.layout.main ? f.type.body : f.type.small;
  look.words = !f.state.hidden;
  look.zoom = zoom_of(f, v);
  if (v == f.layout.main) look.foot = f.layout.foot;
  if (v == f.chosen()) look.overlays = overlay_legends(v, f.stored, f.input);
  look.chosen = !f.state.large && !f.state.hidden && !f.state.saving_panel && v == f.chosen() && v != View::final;
  const Box own = v == f.layout.main ? box_of_a(f, panel) : panel;
  draw_view_panel(f.painter, own, v, image, f.stored, legend_now(v, f.stored, f.input), look);
  if (v == f.layout.main) draw_comparison(f, panel);
  if (f.requests.visible[static_cast<size_t>(v)]) draw_pixel_grid(f, v, picture_box(own, image.size));
  if (f.state.focused == v) f.painter.outline(panel, on_picture().text, std::round(4 * f.layout.unit));
  if (f.state.hidden || (f.state.hovered == v && !f.state.held_at)) return;
  const std::optional<glm::ivec2> pixel = f.state.held_at ? f.held_pixel() : f.state.hovered_pixel;
  if (pixel && f.requests.visible[static_cast<size_t>(v)]) mark_pixel(f, v, picture_box(own, image.size), *pixel);
}

// As it was locked, in its own range and colours.
void draw_locked(FrameContext& f, size_t i) {
  const LockedPanel& l = f.layout.locked[i];
  const View v = view_by_id(l.look.view).view;
  const ViewImage image = i < f.input.locked.size() ? f.input.locked[i] : ViewImage{};
  Settings looked = f.stored;
  set_look(looked.view.looks, l.look.view, l.look.look);
  PanelLook look;
  look.px = f.type.small;
  look.zoom = zoom_of(f, v);
  const std::string name = fmt::format("{}, locked", row(v).label);
  look.name = name;
  draw_view_panel(f.painter, l.box, v, image, looked, legend_now(v, looked, f.input), look);
  f.requests.locked.push_back(l.look);
}

// A panel above is opaque: what is wholly below one need not be drawn at all.
template <class Do>
void for_each_panel(FrameContext& f, Do what) {
  for (int i = 0; i < kViewCount; ++i) {
    const std::optional<Box>& panel = f.layout.panels[static_cast<size_t>(i)];
    if (panel && !covered(f, *panel)) what(static_cast<View>(i), *panel);
  }
}

}  // namespace

void draw_pictures(FrameContext& f) {
  f.state.hovered.reset();
  f.state.hovered_pixel.reset();
  f.state.focused.reset();
  use_view_tools(f);
  use_wipe(f);
  use_titles(f);
  for (size_t i = 0; i < f.layout.locked.size(); ++i) {
    const LockedPanel& l = f.layout.locked[i];
    const View v = view_by_id(l.look.view).view;
    if (!covered(f, l.box))
      use_mouse(f, v, fmt::format("locked.{}", l.place).c_str(), l.box, picture_box(l.box, f.frame_size()));
  }
  for_each_panel(f, [&](View v, const Box& panel) {
    const Box own = v == f.layout.main ? box_of_a(f, panel) : panel;
    use_mouse(f, v, row(v).id, own, picture_box(own, f.input.images[static_cast<size_t>(v)].size));
  });
  for_each_panel(f, [&](View v, const Box& panel) { draw_panel(f, v, panel); });
  for (size_t i = 0; i < f.layout.locked.size(); ++i) draw_locked(f, i);
  draw_carried(f);
  const Box& main = f.layout.main_box();
  f.requests.picture_size = {static_cast<int>(main.width()), static_cast<int>(main.height())};
  if (!covered(f, main) && !f.state.hidden) {
    draw_texts_on_main(f, main);
    draw_error_numbers(f, main);
    if (!f.state.saving_panel) draw_view_tools(f);
  }
  ask_figure(f);
  ask_comparison(f);
  f.requests.probe = f.state.held_at ? f.held_pixel() : f.state.hovered_pixel;
}

}  // namespace gbl::ui
