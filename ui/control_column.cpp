// Right of the pictures: the four settings that the first lecture needs, the way to all others, and what it costs.
#include <algorithm>
#include <fmt/format.h>

#include "renderer/options/presets.h"
#include "renderer/study/pitfalls/watch.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

struct Number {
  std::string label, value;
};

std::string milliseconds(const PassTime& t) { return t.ms ? fmt::format("{:.1f}", *t.ms) : "…"; }

std::string source_in_words(const std::string& id) {
  if (id == "software-rasteriser") return "software rasteriser";
  if (id == "gpu-query") return "GPU timer query";
  return id == "cpu-clock" ? "CPU clock" : id;
}

std::vector<Number> numbers(const FrameContext& f, bool pass_by_pass) {
  const FrameReport& r = f.input.report;
  std::vector<Number> n;
  const double aspect = double(f.settings.size.x) / f.settings.size.y;
  if (const std::optional<Watched> w = watched(f.settings, f.input.lights, aspect))
    n.push_back({kUnsoundSign, fmt::format("{} ({}; P explains it)", w->sentence, w->pitfall)});
  n.push_back({"bytes per pixel",
               fmt::format("{} G-buffer + {} light", r.gbuffer_bytes_per_pixel, r.accumulation_bytes_per_pixel)});
  if (!r.method_reason.empty())
    n.push_back({"method", fmt::format("{}: {}", row(r.drawn.lights.method).label, r.method_reason)});
  n.push_back({"pairs shaded", r.pairs ? grouped(r.pairs->shaded) : "…"});
  std::string lit = r.pairs && r.pairs->lit ? grouped(*r.pairs->lit) : "…";
  if (r.pairs && r.pairs->lit && *r.pairs->lit > 0)
    lit += fmt::format("   (shaded ÷ lit {:.2f})",
                       static_cast<double>(r.pairs->shaded) / static_cast<double>(*r.pairs->lit));
  n.push_back({"pairs lit", lit});
  std::string joined;
  for (const PassTime& t : r.passes) {
    if (pass_by_pass)
      n.push_back({"ms " + t.pass, milliseconds(t)});
    else
      joined += fmt::format("{}{} {}", joined.empty() ? "" : " · ", t.pass, milliseconds(t));
  }
  if (!pass_by_pass) n.push_back({"ms", joined.empty() ? "…" : joined});
  n.push_back({"ms from", r.time_source.empty() ? "…" : source_in_words(r.time_source)});
  n.push_back({"draw calls", std::to_string(r.draw_calls)});
  for (const std::string& choice : r.choices) n.push_back({"auto", choice});
  return n;
}

// Where things stand at one text size; the column tries sizes until all of it fits.
struct Sizes {
  float px, widget, note, gap, line;
  explicit Sizes(float p)
      : px(p),
        widget(std::round(p * 1.7f)),
        note(line_height(p * 0.87f)),
        gap(std::round(p * 0.35f)),
        line(line_height(p)) {}
  float small() const { return std::max(kSmallestPx, std::floor(px * 0.87f)); }
};

float number_height(const Number& n, float width, float label, const Sizes& z) {
  return std::round(text_size(n.value, z.px, width - label).y + 0.35f * z.px);
}

float label_width(const std::vector<Number>& ns, const Sizes& z) {
  float width = 0;
  for (const Number& n : ns) width = std::max(width, text_size(n.label, z.px).x);
  return width + z.px;
}

float column_height(const std::vector<Number>& ns, float width, const Sizes& z) {
  float height = 5 * (z.widget + z.gap) + 2 * z.note + 2 * z.gap;
  for (const Number& n : ns) height += number_height(n, width, label_width(ns, z), z);
  return height;
}

// Key, label, and the box that is left for the widget; moves `at` below the row.
Box begin_row(FrameContext& f, const Box& column, ImVec2& at, const Sizes& z, std::string_view keys,
              std::string_view label) {
  const float top = at.y + (z.widget - z.line) / 2;
  float x = at.x;
  while (!keys.empty()) {
    const size_t space = std::min(keys.find(' '), keys.size());
    x += f.painter.key_cap({x, top}, z.px, keys.substr(0, space)) + 2;
    keys.remove_prefix(std::min(space + 1, keys.size()));
  }
  x = std::max(x, at.x + 2 * key_cap_width("[", z.px) + 4) + z.gap;
  f.painter.text({x, top + above_text(z.px)}, z.px, theme().text, label);
  const float left = std::round(column.min.x + 2 * key_cap_width("[", z.px) + text_size("Normal", z.px).x + 4 * z.gap);
  const Box widget{{left, at.y}, {column.max.x, at.y + z.widget}};
  at.y += z.widget + z.gap;
  return widget;
}

void preset_row(FrameContext& f, const Box& column, ImVec2& at, const Sizes& z) {
  const Box box = begin_row(f, column, at, z, "B", "Preset");
  const Preset* now = preset_of(f.settings);
  const char* label = now ? now->label : "changed";
  const FontScope font(z.px);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {std::round(z.px * 0.5f), std::floor((z.widget - z.px) / 2)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {z.gap, z.gap});
  ImGui::SetCursorScreenPos(box.min);
  ImGui::SetNextItemWidth(box.width());
  if (ImGui::BeginCombo("##preset", label)) {
    for (size_t i = 0; i < presets().size(); ++i) {
      if (ImGui::Selectable(presets()[i].label, now == &presets()[i])) choose_preset(f, static_cast<int>(i));
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", presets()[i].help);
    }
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar(2);
}

// The line below is kept free when the choice is sound: nothing jumps at a key press.
void choice_row(FrameContext& f, const Box& column, ImVec2& at, const Sizes& z, const char* path) {
  const Option& o = option(path);
  const Box box = begin_row(f, column, at, z, o.key, o.label);
  draw_choice(f, o, box, z.px);
  const Box note{{box.min.x, box.max.y + 1}, {box.max.x, box.max.y + 1 + z.note}};
  const std::string mark = sound_mark(o, f.settings);
  if (!mark.empty()) {
    f.painter.text_in(note, z.small(), theme().unsound, mark);
    if (hit_area(fmt::format("{}.why", path).c_str(), note)) explain_unsound(f, o);
  } else
    f.painter.text_in(note, z.small(), theme().dim, in_use(o, f.settings) ? "sound" : "not used by this method");
  at.y += z.note;
}

void lights_row(FrameContext& f, const Box& column, ImVec2& at, const Sizes& z) {
  const Option& o = option("lights.count");
  const Box box = begin_row(f, column, at, z, o.key, o.label);
  const bool generated = f.settings.lights.source == LightSource::generated;
  int count = generated ? f.settings.lights.count : f.input.report.light_total;
  const float number = text_size("16 384 ", z.px).x;  // beside the slider: its grab would hide it
  const std::string text = grouped(static_cast<uint64_t>(count));
  f.painter.text({box.max.x - text_size(text, z.px).x, box.min.y + (z.widget - z.px) / 2}, z.px, theme().text, text);
  const FontScope font(z.px);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {std::round(z.px * 0.5f), std::floor((z.widget - z.px) / 2)});
  ImGui::SetCursorScreenPos(box.min);
  ImGui::SetNextItemWidth(box.width() - number);
  constexpr ImGuiSliderFlags kFlags =
      ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput;
  if (ImGui::SliderInt("##lights", &count, 0, kMaxLights, "", kFlags)) edit_option(f, o, count);
  ImGui::PopStyleVar();
}

// What has no room in the column: all options, and all keys for those who have none.
void list_buttons(FrameContext& f, const Box& column, ImVec2& at, const Sizes& z) {
  const FontScope font(z.px);
  const float width = std::floor((column.width() - z.gap) / 2);
  ImGui::SetCursorScreenPos(at);
  if (ImGui::Button("all options   O", {width, z.widget})) press_panel(f, panel("options"), {});
  ImGui::SetCursorScreenPos({column.max.x - width, at.y});
  if (ImGui::Button("all keys   F1", {width, z.widget})) press_panel(f, panel("help"), {});
  at.y += z.widget + z.gap;
}

void draw_numbers(FrameContext& f, const Box& column, ImVec2 at, const std::vector<Number>& ns, const Sizes& z) {
  const float label = label_width(ns, z);
  for (const Number& n : ns) {
    f.painter.text(at, z.px, theme().dim, n.label);
    f.painter.text_in({{column.min.x + label, at.y}, {column.max.x, column.max.y}}, z.px, theme().text, n.value, true);
    at.y += number_height(n, column.width(), label, z);
  }
}

}  // namespace

void draw_control_column(FrameContext& f) {
  const Box column = f.layout.column.inset(std::round(12 * f.layout.unit));
  std::vector<Number> ns = numbers(f, true);
  Sizes z(f.type.body);
  if (column_height(ns, column.width(), z) > column.height()) ns = numbers(f, false);
  while (column_height(ns, column.width(), z) > column.height() && z.px > kSmallestPx) z = Sizes(z.px - 1);
  if (column_height(ns, column.width(), z) > column.height()) f.state.cut_texts.emplace_back("the control column");
  ImVec2 at = column.min;
  preset_row(f, column, at, z);
  choice_row(f, column, at, z, "normal.encoding");
  choice_row(f, column, at, z, "lights.cull");
  lights_row(f, column, at, z);
  at.y += z.gap;
  list_buttons(f, column, at, z);
  draw_numbers(f, column, at, ns, z);
}

}  // namespace gbl::ui
