// Looking closely at a view: zoom, the grid and the numbers of single pixels, and on the large picture the buttons for
// its channels, colours and range with the histogram.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "ui/state.h"

namespace gbl::ui {
namespace {

constexpr double kGridFrom = 8, kNumbersFrom = 48, kLargestPixel = 128;  // screen pixels per pixel of the picture

size_t at(View v) { return static_cast<size_t>(v); }

// ---- buttons -------------------------------------------------------------------------------------------
struct Tool {
  const char* label;
  const char* id;
  bool (*lit)(const FrameContext&, View);
  void (*press)(FrameContext&, View, bool right);
  bool three_channels = false;  // only where there are so many
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
    {"R", "tool.r", channel_lit<'r'>, press_channel<'r'>, true},
    {"G", "tool.g", channel_lit<'g'>, press_channel<'g'>, true},
    {"B", "tool.b", channel_lit<'b'>, press_channel<'b'>, true},
    {"map", "tool.map", [](const FrameContext& f, View v) { return look_now(f, v).map != ColourMap::own; }, next_map},
    {"range", "tool.fit", [](const FrameContext& f, View v) { return look_now(f, v).fit || look_now(f, v).range; },
     press_fit},
    {"histogram", "tool.histogram", [](const FrameContext& f, View) { return f.state.histogram; },
     [](FrameContext& f, View, bool) { f.state.histogram = !f.state.histogram; }},
    {"1:1", "tool.1:1", [](const FrameContext& f, View v) { return !zoom_of(f, v).whole(); },
     [](FrameContext& f, View, bool) { show_pixel_for_pixel(f); }},
    {"fit", "tool.whole", [](const FrameContext& f, View v) { return zoom_of(f, v).whole(); },
     [](FrameContext& f, View, bool) { show_whole(f); }},
};

bool tools_shown(const FrameContext& f) {
  const View v = f.layout.main;
  return !f.state.hidden && !needs_truth(v) && why_missing(v, f.stored).empty() && !covered(f, f.layout.main_box());
}

// Right to left along the top edge of the large picture.
template <class Each>
void for_each_tool(const FrameContext& f, Each each) {
  const Box& panel = f.layout.main_box();
  const float px = f.type.small, pad = std::round(px * 0.45f), height = line_height(px) + 2;
  float right = panel.max.x - std::max(4.0f, std::round(panel.width() / 200));
  for (auto t = std::rbegin(kTools); t != std::rend(kTools); ++t) {
    if (t->three_channels && row(f.layout.main).values.components != 3) continue;
    const float width = text_size(t->label, px).x + 2 * pad;
    each(*t, Box{{right - width, panel.min.y + 4}, {right, panel.min.y + 4 + height}});
    right -= width + 2;
  }
}

// ---- the histogram -------------------------------------------------------------------------------------
Box histogram_box(const FrameContext& f) {
  const Box& panel = f.layout.main_box();
  const float px = f.type.small, right = panel.max.x - 6, top = panel.min.y + 8 + line_height(px) + 2;
  return {{right - std::min(panel.width() * 0.55f, 38 * px), top}, {right, top + 10 * px}};
}

// Where bars and handles stand: above two lines of text.
Box plot_box(const FrameContext& f) {
  Box b = histogram_box(f).inset(std::round(f.type.small * 0.6f));
  b.max.y -= 2 * line_height(f.type.small) + f.type.small * 0.6f;
  return b;
}

const ViewStats* stats_of_main(const FrameContext& f) { return f.input.stats[at(f.layout.main)]; }

glm::dvec2 range_now(const FrameContext& f) {
  return shown_range(f.layout.main, f.settings, f.input.scene.bounds, stats_of_main(f));
}

// What the axis spans: the numbers, and black and white as they are without a hand on them.
glm::dvec2 axis_of(const FrameContext& f, const ViewStats& stats) {
  Settings own = f.settings;
  ViewLook look = look_now(f, f.layout.main);
  look.range.reset();
  set_look(own.view.looks, row(f.layout.main).id, look);
  const glm::dvec2 r = shown_range(f.layout.main, own, f.input.scene.bounds, &stats);
  return {std::min(stats.binned.x, std::min(r.x, r.y)), std::max(stats.binned.y, std::max(r.x, r.y))};
}

constexpr const char* kHandles[] = {"tool.black", "tool.white"};

void use_histogram(FrameContext& f) {
  const ViewStats* stats = stats_of_main(f);
  if (!f.state.histogram || !stats) return;
  const Box plot = plot_box(f);
  const glm::dvec2 axis = axis_of(f, *stats);
  const float grip = std::round(f.type.small * 0.6f);
  for (int k = 0; k < 2; ++k) {
    const double t = (range_now(f)[k] - axis.x) / (axis.y - axis.x);
    const float x = plot.min.x + static_cast<float>(std::clamp(t, 0.0, 1.0)) * plot.width();
    hit_area(kHandles[k], {{x - grip, plot.max.y - 2}, {x + grip, plot.max.y + 2 * grip}});
    if (!ImGui::IsItemActive() || ImGui::GetIO().MouseDelta.x == 0) continue;
    const double to = std::clamp((ImGui::GetIO().MousePos.x - plot.min.x) / double(plot.width()), 0.0, 1.0);
    glm::dvec2 range = range_now(f);
    range[k] = glm::mix(axis.x, axis.y, to);
    if (range.x != range.y)
      change_look(f, f.layout.main, [&](ViewLook& look) { look.fit = false, look.range = range; });
  }
  hit_area("tool.plot", histogram_box(f));
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
    change_look(f, f.layout.main, [](ViewLook& look) { look.fit = false, look.range.reset(); });
}

std::string numbers_of(const ViewStats& s, int components) {
  const auto list = [&](const glm::dvec3& v) {
    std::string text;
    for (int k = 0; k < components; ++k) text += fmt::format("{}{:.4g}", k ? " " : "", v[k]);
    return text;
  };
  return fmt::format("least {}   mean {}   largest {}", list(s.min), list(s.mean), list(s.max));
}

std::string faults_of(const ViewStats& s) {
  std::string text = fmt::format("{} of the pixels asked", s.pixels);
  if (s.nonfinite > 0) text += fmt::format("   {} {} are no number", kUnsoundSign, s.nonfinite);
  if (s.negative > 0) text += fmt::format("   {} below 0", s.negative);
  return text + "   log count";
}

void draw_bars(FrameContext& f, const Box& plot, const ViewStats& stats, const glm::dvec2& axis) {
  const int components = row(f.layout.main).values.components;
  constexpr ImU32 kInks[] = {IM_COL32(255, 110, 110, 150), IM_COL32(110, 230, 110, 150), IM_COL32(120, 150, 255, 150)};
  uint32_t most = 1;
  for (const auto& bins : stats.bins) most = std::max(most, *std::max_element(bins.begin(), bins.end()));
  const auto x_of = [&](double value) {
    return plot.min.x + static_cast<float>((value - axis.x) / (axis.y - axis.x)) * plot.width();
  };
  for (int c = 0; c < components; ++c)
    for (int i = 0; i < ViewStats::kBins; ++i) {
      const uint32_t n = stats.bins[static_cast<size_t>(c)][static_cast<size_t>(i)];
      if (n == 0) continue;
      const double step = (stats.binned.y - stats.binned.x) / ViewStats::kBins;
      const float left = x_of(stats.binned.x + step * i),
                  right = std::max(left + 1, x_of(stats.binned.x + step * (i + 1)));
      const auto share = static_cast<float>(std::log1p(double(n)) / std::log1p(double(most)));
      f.painter.fill({{left, plot.max.y - std::max(2.0f, share * plot.height())}, {right, plot.max.y}},
                     components == 1 ? on_picture().dim : kInks[c]);
    }
  f.painter.fill({{plot.min.x, plot.max.y}, {plot.max.x, plot.max.y + 1}}, on_picture().text);
}

void draw_histogram(FrameContext& f) {
  const Box box = histogram_box(f), plot = plot_box(f);
  const float px = f.type.small, line = line_height(px), grip = std::round(px * 0.6f);
  f.painter.fill(box, on_picture().backing, 3);
  const ViewStats* stats = stats_of_main(f);
  if (!stats || stats->pixels == 0) {
    f.painter.text_in(plot, px, on_picture().text, "no pixel of it has a number yet", true);
    return;
  }
  const glm::dvec2 axis = axis_of(f, *stats), range = range_now(f);
  draw_bars(f, plot, *stats, axis);
  for (int k = 0; k < 2; ++k) {
    const double t = std::clamp((range[k] - axis.x) / (axis.y - axis.x), 0.0, 1.0);
    const float x = plot.min.x + static_cast<float>(t) * plot.width();
    const ImVec2 a{x, plot.max.y}, b{x - grip, plot.max.y + 1.6f * grip}, c{x + grip, plot.max.y + 1.6f * grip};
    f.painter.list().AddTriangleFilled(a, b, c, k == 0 ? IM_COL32_BLACK : IM_COL32_WHITE);
    f.painter.list().AddTriangle(a, b, c, on_picture().accent);
  }
  const int components = row(f.layout.main).values.components;
  const float top = plot.max.y + 1.8f * grip;
  f.painter.text_in({{plot.min.x, top}, {plot.max.x, top + line}}, px, on_picture().text,
                    numbers_of(*stats, components));
  f.painter.text_in({{plot.min.x, top + line}, {plot.max.x, top + 2 * line}}, px, on_picture().dim,
                    fmt::format("black {:.4g}, white {:.4g}   {}", range.x, range.y, faults_of(*stats)));
}

// ---- single pixels -------------------------------------------------------------------------------------
// Pixels of the frame that the panel shows, wholly or in part: the first, and how many.
std::pair<glm::ivec2, glm::ivec2> shown_pixels(const FrameContext& f, const Zoom& zoom) {
  const glm::dvec2 size(f.frame_size());
  const glm::ivec2 first(glm::floor(zoom.first() * size));
  const glm::ivec2 last = glm::min(glm::ivec2(glm::ceil((zoom.first() + 1 / zoom.scale) * size)), f.frame_size());
  return {glm::max(first, glm::ivec2(0)), last - glm::max(first, glm::ivec2(0))};
}

void print_numbers(FrameContext& f, View v, const Box& picture, const Zoom& zoom, float pixel_px) {
  const PixelNumbers* n = f.input.numbers;
  if (!n || n->view != v) return;
  const int components = row(v).values.components;
  const float px =
      std::max(kSmallestPx, std::min(f.type.small, std::floor(pixel_px / (components == 1 ? 4.5f : 5.5f))));
  const glm::dvec2 size(f.frame_size());
  for (int y = 0; y < n->pixels.count.y; ++y)
    for (int x = 0; x < n->pixels.count.x; ++x) {
      const glm::vec4& value =
          n->values[static_cast<size_t>(y) * static_cast<size_t>(n->pixels.count.x) + static_cast<size_t>(x)];
      if (value.w <= 0.5f) continue;
      const glm::vec2 middle(in_panel(zoom, (glm::dvec2(n->pixels.first + glm::ivec2(x, y)) + 0.5) / size));
      ImVec2 at{picture.min.x + middle.x * picture.width(),
                picture.min.y + middle.y * picture.height() - px * 0.6f * static_cast<float>(components)};
      for (int c = 0; c < components; ++c, at.y += px * 1.2f) {
        const std::string text = fmt::format("{:.4g}", value[c]);
        const ImVec2 from{at.x - text_size(text, px).x / 2, at.y};
        f.painter.text({from.x + 1, from.y + 1}, px, IM_COL32_BLACK, text);  // readable on light and dark
        f.painter.text(from, px, IM_COL32_WHITE, text);
      }
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
  change(look);
  set_look(f.settings.view.looks, row(v).id, look);
}

void use_view_tools(FrameContext& f) {
  if (!tools_shown(f)) return;
  use_histogram(f);
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
  if (f.state.histogram) draw_histogram(f);
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
  const double pixel_px = zoom.scale * picture.width() / f.frame_size().x;
  f.requests.magnified |= !zoom.whole();
  if (pixel_px < kGridFrom) return;
  const auto [first, count] = shown_pixels(f, zoom);
  const glm::dvec2 size(f.frame_size());
  f.painter.list().PushClipRect(picture.min, picture.max, true);
  for (int x = first.x; x <= first.x + count.x; ++x) {
    const float at_x = picture.min.x + static_cast<float>(in_panel(zoom, {x / size.x, 0}).x) * picture.width();
    f.painter.list().AddLine({at_x, picture.min.y}, {at_x, picture.max.y}, IM_COL32(128, 128, 128, 110));
  }
  for (int y = first.y; y <= first.y + count.y; ++y) {
    const float at_y = picture.min.y + static_cast<float>(in_panel(zoom, {0, y / size.y}).y) * picture.height();
    f.painter.list().AddLine({picture.min.x, at_y}, {picture.max.x, at_y}, IM_COL32(128, 128, 128, 110));
  }
  if (v == f.layout.main && pixel_px >= kNumbersFrom && !needs_truth(v)) {
    f.requests.numbers = {v, PixelGrid{first, {1, 1}, count}};
    print_numbers(f, v, picture, zoom, static_cast<float>(pixel_px));
  }
  f.painter.list().PopClipRect();
}

}  // namespace gbl::ui
