#include "ui/histogram.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/number.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

HistogramBoxes boxes_of(const FrameContext& f) { return histogram_boxes(f.layout.main_box(), f.type.small); }

const ViewStats* stats_of_main(const FrameContext& f) { return f.input.stats[static_cast<size_t>(f.layout.main)]; }

glm::dvec2 range_now(const FrameContext& f) {
  return shown_range(f.layout.main, f.settings, f.input.scene.bounds, stats_of_main(f));
}

// What the axis spans: the numbers, and black and white as they are without a hand on them.
glm::dvec2 axis_of(const FrameContext& f, const ViewStats& stats) {
  Settings own = f.settings;
  ViewLook look = look_of(f.settings.view.looks, row(f.layout.main).id);
  look.range.reset();
  set_look(own.view.looks, row(f.layout.main).id, look);
  const glm::dvec2 r = shown_range(f.layout.main, own, f.input.scene.bounds, &stats);
  return {std::min(stats.binned.x, std::min(r.x, r.y)), std::max(stats.binned.y, std::max(r.x, r.y))};
}

constexpr const char* kHandles[] = {"tool.black", "tool.white"};

}  // namespace

HistogramBoxes histogram_boxes(const Box& panel, float px) {
  const float line = line_height(px), pad = std::round(px * 0.6f), fields = std::round(line * 1.5f);
  const float right = panel.max.x - 6, top = panel.min.y + 8 + line + 2;
  HistogramBoxes b;
  b.all = {{right - std::min(panel.width() * 0.55f, 38 * px), top}, {right, top + 10 * px + fields}};
  const Box inner = b.all.inset(pad);
  b.plot = {inner.min, {inner.max.x, inner.max.y - 2 * line - px * 0.6f - fields}};
  const float third = inner.width() / 3;
  const auto cell = [&](int i) {
    const float left = inner.min.x + static_cast<float>(i) * third;
    return Box{{left, inner.max.y - fields + 2}, {left + third - std::round(px * 0.5f), inner.max.y}};
  };
  const float name = text_size("white", px).x + px * 0.5f;
  for (int k = 0; k < 2; ++k) {
    b.names[k] = cell(k);
    b.fields[k] = {{b.names[k].min.x + name, b.names[k].min.y}, b.names[k].max};
    b.names[k].max.x = b.fields[k].min.x;
  }
  b.counts = cell(2);
  return b;
}

void use_histogram(FrameContext& f) {
  const ViewStats* stats = stats_of_main(f);
  if (!f.state.histogram || !stats) return;
  const HistogramBoxes boxes = boxes_of(f);
  const Box& plot = boxes.plot;
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
  if (hit_area("tool.counts", boxes.counts)) f.state.linear_counts = !f.state.linear_counts;
  hit_area("tool.plot", boxes.all);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
    change_look(f, f.layout.main, [](ViewLook& look) { look.fit = false, look.range.reset(); });
}

namespace {

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
  return text;
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
      const auto share = static_cast<float>(f.state.linear_counts ? double(n) / double(most)
                                                                  : std::log1p(double(n)) / std::log1p(double(most)));
      f.painter.fill({{left, plot.max.y - std::max(2.0f, share * plot.height())}, {right, plot.max.y}},
                     components == 1 ? on_picture().dim : kInks[c]);
    }
  f.painter.fill({{plot.min.x, plot.max.y}, {plot.max.x, plot.max.y + 1}}, on_picture().text);
}

// ---- black and white, typed ----------------------------------------------------------------------------------
constexpr const char* kNames[] = {"black", "white"};

void take_number(FrameContext& f, size_t k, std::string_view text) {
  const std::optional<double> typed = decimal(text);
  glm::dvec2 range = range_now(f);
  range[static_cast<glm::length_t>(k)] = typed.value_or(0);
  if (!typed)
    f.state.notice = fmt::format("{}: '{}' is not a number; write one as 0.25, -3 or 1e-4", kNames[k], text);
  else if (range.x == range.y)
    f.state.notice = fmt::format("black and white cannot both be {}; choose two different numbers", text);
  else
    change_look(f, f.layout.main, [&](ViewLook& look) { look.fit = false, look.range = range; });
}

// It shows the number as it is until somebody types; what was refused stays to be mended.
void draw_number(FrameContext& f, size_t k, const Box& box) {
  NumberField& field = f.state.range_fields[k];
  const std::string now = fmt::format("{:.6g}", range_now(f)[static_cast<glm::length_t>(k)]);
  const auto show_now = [&] {
    field.text = {};
    now.copy(field.text.data(), field.text.size() - 1);
    field.shows = now;
  };
  if (field.shows != now) show_now();
  const std::string id = fmt::format("histogram.{}", kNames[k]);
  const bool entered = draw_text_field(f, id.c_str(), box, f.type.small, field.text.data(), field.text.size());
  if (entered)
    take_number(f, k, field.text.data());
  else if (ImGui::IsItemDeactivated())
    show_now();
}

// In a window of its own, above the picture: else the picture would take the clicks.
void draw_numbers(FrameContext& f) {
  const HistogramBoxes boxes = boxes_of(f);
  const float px = f.type.small, down = (boxes.counts.height() - px) / 2;
  for (size_t k = 0; k < 2; ++k) {
    const Box &name = boxes.names[k], &field = boxes.fields[k];
    f.painter.text_in({{name.min.x, name.min.y + down}, name.max}, px, on_picture().dim, kNames[k]);
    if (field.width() < 1 || field.height() < 1) continue;
    begin_overlay(kHandles[k], field, on_picture().raised);
    draw_number(f, k, field);
    end_overlay();
  }
  f.painter.text_in({{boxes.counts.min.x, boxes.counts.min.y + down}, boxes.counts.max}, px, on_picture().accent,
                    f.state.linear_counts ? "linear count" : "log count");
}

}  // namespace

void draw_histogram(FrameContext& f) {
  if (!f.state.histogram) return;
  const HistogramBoxes boxes = boxes_of(f);
  const Box &box = boxes.all, &plot = boxes.plot;
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
  f.painter.text_in({{plot.min.x, top + line}, {plot.max.x, top + 2 * line}}, px, on_picture().dim, faults_of(*stats));
  draw_numbers(f);
}

}  // namespace gbl::ui
