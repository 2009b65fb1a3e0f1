#include "ui/figure.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/made_by.h"
#include "renderer/base/size_text.h"
#include "renderer/options/presets.h"
#include "ui/in_words.h"
#include "ui/overlay_legends.h"
#include "ui/state.h"
#include "ui/style.h"

namespace gbl::ui {
namespace {

constexpr float kMargin = 12;

struct Ink {
  ImU32 paper, text, dim;
};
Ink ink_on_white() { return {IM_COL32_WHITE, kLightTheme.text, kLightTheme.dim}; }
Ink ink_on_dark() { return {kDarkTheme.background, kDarkTheme.text, kDarkTheme.dim}; }

std::string method_in_words(const FrameReport& r) {
  if (r.method_reason.empty()) return row(r.drawn.lights.method).label;
  return fmt::format("{} ({}: {})", row(r.drawn.lights.method).label, row(LightMethod::auto_).label, r.method_reason);
}

// The chosen panel, or the large one where that is not on screen.
View saved_view(const FrameContext& f) {
  const std::optional<Box>& chosen = f.layout.panels[static_cast<size_t>(f.chosen())];
  return chosen && !covered(f, *chosen) ? f.chosen() : f.layout.main;
}

std::string overlays_in_words(const FrameContext& f, View v) {
  std::string text;
  const bool difference = v == f.layout.main && f.state.comparison.mode == CompareMode::difference;
  if (v != f.chosen() || difference) return text;  // a difference is one of what lies below them
  for (const OverlayLegend& o : overlay_legends(v, f.stored, f.input))
    text += fmt::format("{}{}{}{}", text.empty() ? "Over it: " : "; ", o.name, o.words.empty() ? "" : ": ", o.words);
  return text;
}

}  // namespace

std::string made_in_words(const Settings& s, const FrameReport& r) {
  const Preset* p = preset_of(s);
  const std::string cull =
      in_use(option("lights.cull"), s) ? fmt::format(" · cull {}", row(s.lights.cull).id) : std::string();
  std::string text =
      fmt::format("{} · {} · {} lights, {}{} · normal {} · {} + {} B/px", p ? p->label : s.scene, size_text(r.size),
                  r.light_count, method_in_words(r), cull, row(s.normal.encoding).label, r.gbuffer_bytes_per_pixel,
                  r.accumulation_bytes_per_pixel);
  if (r.pairs && r.pairs->lit && *r.pairs->lit > 0)
    text += fmt::format(" · shaded ÷ lit {:.2f}", double(r.pairs->shaded) / double(*r.pairs->lit));
  return text;
}

void save_panel(FrameContext& f, const KeyEvent&) {
  f.state.saving_panel = true;  // what is no part of the picture is left out of this frame
}

void save_window(FrameContext& f, const KeyEvent&) { f.requests.figure = Figure{}; }

void ask_figure(FrameContext& f) {
  if (!f.state.saving_panel) return;
  f.state.saving_panel = false;
  const View v = saved_view(f);
  const Box& panel = *f.layout.panels[static_cast<size_t>(v)];
  Figure figure;
  figure.first = {static_cast<int>(panel.min.x), static_cast<int>(panel.min.y)};
  figure.size = {static_cast<int>(panel.width()), static_cast<int>(panel.height())};
  figure.white = f.state.figures_on_white();
  figure.caption = {shown_in_words(f, v)};
  if (const std::string both = comparison_in_words(f); v == f.layout.main && !both.empty())
    figure.caption.push_back(both);
  if (const std::string over = overlays_in_words(f, v); !over.empty()) figure.caption.push_back(over);
  std::string unsound;
  for (const Unsound& u : unsound_choices(f.settings))
    unsound += fmt::format("{}{}={} ({})", unsound.empty() ? "" : ", ", u.path, u.value, u.pitfall);
  figure.caption.push_back(made_in_words(f.settings, f.input.report));
  if (!unsound.empty()) figure.caption.push_back(fmt::format("{} unsound: {}", kUnsoundSign, unsound));
  figure.caption.push_back(fmt::format("G-Buffer Lab {}", made_by()));
  f.requests.figure = std::move(figure);
}

int caption_height(const Figure& figure) {
  const Type type = type_for(std::clamp(static_cast<float>(figure.size.x) / 800, 0.8f, 1.6f));
  float height = 2 * kMargin;
  for (size_t i = 0; i < figure.caption.size(); ++i)
    height +=
        text_size(figure.caption[i], i == 0 ? type.body : type.small, static_cast<float>(figure.size.x) - 2 * kMargin)
            .y +
        4;
  return static_cast<int>(height);
}

void draw_caption(const Figure& figure) {
  std::vector<std::string> cut;
  Painter p(*ImGui::GetBackgroundDrawList(), cut);
  const Type type = type_for(std::clamp(static_cast<float>(figure.size.x) / 800, 0.8f, 1.6f));
  const Ink ink = figure.white ? ink_on_white() : ink_on_dark();
  p.fill({{0, 0}, ImGui::GetIO().DisplaySize}, ink.paper);
  const float width = static_cast<float>(figure.size.x) - 2 * kMargin;
  float y = kMargin;
  for (size_t i = 0; i < figure.caption.size(); ++i)
    y +=
        p.text({kMargin, y}, i == 0 ? type.body : type.small, i == 0 ? ink.text : ink.dim, figure.caption[i], width).y +
        4;
}

void copy_values(FrameContext& f, const KeyEvent&) {
  const std::optional<PixelProbe>& probe = f.input.probe;
  if (!probe || (!f.state.held_at && !f.state.hovered_pixel))
    return say(f, {"Point at a pixel or hold one first: its values are copied.", ""});
  std::string text = fmt::format("pixel {}, {} of {}: {}\n", probe->pixel.x, probe->pixel.y, size_text(f.frame_size()),
                                 object_name(*probe, f.input.scene));
  for (const StoredTexel& t : probe->stored)
    text += fmt::format("{}\t{}\t{}\n", t.attachment.name, row(t.attachment.format).label, hex(t));
  for (size_t i = 0; i < probe_fields().size(); ++i) {
    const ProbeFieldRow& field = probe_fields()[i];
    if (!why_missing(field.view, f.stored).empty()) continue;
    text += field.path;
    for (int k = 0; k < field.components; ++k) text += fmt::format("\t{:.9g}", probe->values[i][k]);
    text += fmt::format("\t{}\n", field.unit);
  }
  if (f.input.account && f.input.account->pixel == probe->pixel)
    for (const auto* lines : {&f.input.account->stored, &f.input.account->terms})
      for (const AccountLine& l : *lines)
        text += fmt::format("{}\tdrawn {:.9g}\ttruth {:.9g}\terror {:.3g} {}\n", l.what, fmt::join(l.drawn, " "),
                            fmt::join(l.truth, " "), l.error, l.unit);
  ImGui::SetClipboardText(text.c_str());
  say(f, {fmt::format("The values of pixel {}, {} are on the clipboard.", probe->pixel.x, probe->pixel.y), ""});
}

void copy_command(FrameContext& f, const KeyEvent&) { f.requests.copy_command = true; }

}  // namespace gbl::ui
