// Looking closely at a view: zoom, the grid and the numbers of single pixels, and on the large picture the buttons for
// its channels, colours, range and codes.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "ui/histogram.h"
#include "ui/pixel_numbers.h"
#include "ui/state.h"
#include "ui/view_panel.h"

namespace gbl::ui {
namespace {

constexpr double kLargestPixel = 128;  // screen pixels per pixel of the picture

size_t at(View v) { return static_cast<size_t>(v); }

// ---- buttons -------------------------------------------------------------------------------------------
struct Tool {
  const char* label;
  const char* id;
  bool (*lit)(const FrameContext&, View);
  void (*press)(FrameContext&, View, bool right);
  bool three_channels = false;  // only where there are so many
  bool of_truth = false;        // on the error and the reference, too
};

ViewLook look_now(const FrameContext& f, View v) { return look_of(f.settings.view.looks, row(v).id); }

template <char kChannel>
bool channel_lit(const FrameContext& f, View v) {
  return look_now(f, v).channels.find(kChannel) != std::string::npos;
}

// The left button shows or hides a channel, the right one shows it alone or all again.
template <char kChannel>
void press_channel(FrameContext& f, View v, bool right) {
  change_look(f, v, [&](ViewLook& look) {
    std::string now = look.channels, next;
    if (right) {
      next = now == std::string(1, kChannel) ? "rgb" : std::string(1, kChannel);
    } else {
      for (const char c : std::string_view("rgb"))
        if ((now.find(c) != std::string::npos) != (c == kChannel)) next += c;
    }
    look.channels = next.empty() ? "rgb" : next;
  });
}

void next_map(FrameContext& f, View v, bool right) {
  const int n = static_cast<int>(rows<ColourMap>().size());
  change_look(f, v, [&](ViewLook& look) {
    look.map = static_cast<ColourMap>((static_cast<int>(look.map) + (right ? n - 1 : 1)) % n);
  });
}

void press_fit(FrameContext& f, View v, bool right) {
  change_look(f, v, [&](ViewLook& look) {
    look.fit = !right && !look.fit;
    look.range.reset();
  });
}

const Tool kTools[] = {
    {"error", "tool.error", [](const FrameContext&, View v) { return v == View::error; },
     [](FrameContext& f, View, bool) { show_view(f, View::error); }, false, true},
    {"why", "tool.why", [](const FrameContext& f, View) { return is_open(f.state, "pixel"); },
     [](FrameContext& f, View, bool) { press_panel(f, panel("pixel"), {}); }, false, true},
    {"R", "tool.r", channel_lit<'r'>, press_channel<'r'>, true},
    {"G", "tool.g", channel_lit<'g'>, press_channel<'g'>, true},
    {"B", "tool.b", channel_lit<'b'>, press_channel<'b'>, true},
    {"map", "tool.map", [](const FrameContext& f, View v) { return look_now(f, v).map != ColourMap::own; }, next_map},
    {"range", "tool.fit", [](const FrameContext& f, View v) { return look_now(f, v).fit || look_now(f, v).range; },
     press_fit},
    {"raw", "tool.raw", [](const FrameContext& f, View v) { return look_now(f, v).raw; },
     [](FrameContext& f, View v, bool) { toggle_raw(f, v); }},
    {"histogram", "tool.histogram", [](const FrameContext& f, View) { return f.state.histogram; },
     [](FrameContext& f, View, bool) { f.state.histogram = !f.state.histogram; }},
    {"1:1", "tool.1:1", [](const FrameContext& f, View v) { return !zoom_of(f, v).whole(); },
     [](FrameContext& f, View, bool) { show_pixel_for_pixel(f); }},
    {"fit", "tool.whole", [](const FrameContext& f, View v) { return zoom_of(f, v).whole(); },
     [](FrameContext& f, View, bool) { show_whole(f); }},
};

bool tools_shown(const FrameContext& f) {
  const View v = f.layout.main;
  return !f.state.hidden && why_missing(v, f.stored).empty() && !covered(f, f.layout.main_box());
}

// Right to left along the top edge of the large picture, as many as there is room for beside its name. Each has its key, too.
template <class Each>
void for_each_tool(const FrameContext& f, Each each) {
  const Box& panel = f.layout.main_box();
  const float px = f.type.small, pad = std::round(px * 0.45f), height = line_height(px) + 2;
  const float name = badge_box(panel, f.layout.main, f.stored, f.type.body).max.x;
  float right = panel.max.x - std::max(4.0f, std::round(panel.width() / 200));
  for (auto t = std::rbegin(kTools); t != std::rend(kTools); ++t) {
    if (needs_truth(f.layout.main) && !t->of_truth) continue;
    if (t->three_channels && row(f.layout.main).values.components != 3) continue;
    const float width = text_size(t->label, px).x + 2 * pad;
    if (right - width < name) break;
    each(*t, Box{{right - width, panel.min.y + 4}, {right, panel.min.y + 4 + height}});
    right -= width + 2;
  }
}

}  // namespace

Zoom zoom_of(const FrameContext& f, View v) {
  const std::optional<Zoom>& own = f.state.own_zoom[at(v)];
  return within(own ? *own : Zoom{f.settings.view.zoom, f.settings.view.centre}, 1e9);
}

void set_zoom(FrameContext& f, View v, const Zoom& zoom, bool this_panel_only) {
  std::optional<Zoom>& own = f.state.own_zoom[at(v)];
  if (this_panel_only || own) {
    own = zoom;
    return;
  }
  f.settings.view.zoom = zoom.scale;
  f.settings.view.centre = zoom.centre;
}

void show_whole(FrameContext& f) {
  f.state.own_zoom.fill({});
  f.settings.view.zoom = 1;
  f.settings.view.centre = {0.5, 0.5};
}

void show_pixel_for_pixel(FrameContext& f) {
  f.state.own_zoom.fill({});
  const float panel = f.layout.main_box().width();
  Zoom z{f.frame_size().x / double(panel), f.settings.view.centre};
  if (z.scale <= 1.01) z.scale = kGridFrom;  // they are the same: then close enough to tell pixels apart
  if (f.state.held_at) z.centre = *f.state.held_at;
  z = within(z, most_zoom(f, f.layout.main_box()));
  f.settings.view.zoom = z.scale;
  f.settings.view.centre = z.centre;
}

double most_zoom(const FrameContext& f, const Box& panel) {
  return std::max(1.0, kLargestPixel * f.frame_size().x / double(panel.width()));
}

void change_look(FrameContext& f, View v, const std::function<void(ViewLook&)>& change) {
  ViewLook look = look_now(f, v);
  look.raw = false;
  change(look);
  set_look(f.settings.view.looks, row(v).id, look);
}

bool toggle_raw(FrameContext& f, View v) {
  ViewLook look;
  look.raw = !look_now(f, v).raw;
  const bool raw = look.raw;
  set_look(f.settings.view.looks, row(v).id, std::move(look));
  return raw;
}

void use_view_tools(FrameContext& f) {
  if (!tools_shown(f)) return;
  if (!needs_truth(f.layout.main)) use_histogram(f);
  if (f.state.present) return;  // without buttons
  const View v = f.layout.main;
  for_each_tool(f, [&](const Tool& t, const Box& box) {
    const bool pressed = hit_area(t.id, box);
    const bool right = ImGui::IsItemHovered() && ImGui::IsMouseClicked(1);
    if (pressed || right) t.press(f, v, right);
  });
}

void draw_view_tools(FrameContext& f) {
  if (!tools_shown(f)) return;
  if (!needs_truth(f.layout.main)) draw_histogram(f);
  if (f.state.present) return;
  const View v = f.layout.main;
  for_each_tool(f, [&](const Tool& t, const Box& box) {
    f.painter.fill(box, on_picture().backing, 3);
    const ImVec2 size = text_size(t.label, f.type.small);
    f.painter.text({(box.min.x + box.max.x - size.x) / 2, box.min.y + 1 + above_text(f.type.small)}, f.type.small,
                   t.lit(f, v) ? on_picture().accent : on_picture().dim, t.label);
  });
}

void draw_pixel_grid(FrameContext& f, View v, const Box& picture) {
  const Zoom zoom = zoom_of(f, v);
  f.requests.magnified |= !zoom.whole();
  draw_grid(f.painter, picture, zoom, f.frame_size());
  const bool numbers = zoom.scale * picture.width() / f.frame_size().x >= kNumbersFrom;
  if (v != f.layout.main || !numbers || needs_truth(v)) return;
  f.requests.numbers = {v, shown_pixels(zoom, f.frame_size())};
  if (f.input.numbers && f.input.numbers->view == v)
    draw_numbers(f.painter, picture, zoom, f.frame_size(), *f.input.numbers, f.type.small);
}

}  // namespace gbl::ui
