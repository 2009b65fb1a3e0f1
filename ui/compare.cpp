#include "ui/compare.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "ui/state.h"
#include "ui/view_panel.h"

namespace gbl::ui {
namespace {

constexpr int kNamed = 2;  // differences that a label names
constexpr const char* kModes[] = {"off", "wipe: drag the line, a double click on it puts it back", "side by side",
                                  "difference, in codes of the display"};

// Both look at the same thing.
void share_view(const Settings& from, Settings& to) {
  if (from.scene == to.scene) to.camera = from.camera, to.time_s = from.time_s;
  to.size = from.size, to.view = from.view;
}

const char* letter(bool b) { return b ? "B" : "A"; }

std::string label_of(const FrameContext& f, bool drawn_now) {
  const Comparison& c = f.state.comparison;
  const bool b = c.b_drawn == drawn_now;
  if (!drawn_now && c.what == BesideA::truth) return "B: the truth";
  if (!drawn_now && c.what == BesideA::picture) return "B: " + c.file.substr(c.file.find_last_of('/') + 1);
  if (!c.other) return letter(b);
  const Settings& of = drawn_now ? f.settings : *c.other;
  const Settings& than = drawn_now ? *c.other : f.settings;
  const std::string what = differences(of, than);
  return what.empty() ? fmt::format("{}: the same", letter(b)) : fmt::format("{}: {}", letter(b), what);
}

// B where there is none: the state before the last change.
bool find_b(FrameContext& f) {
  Comparison& c = f.state.comparison;
  if (c.has_b()) return true;
  const Settings* last = f.state.history.last();
  if (last && !differences(*last, f.settings).empty()) {
    c.other = *last;
    return true;
  }
  c.other = f.settings;
  say(f, {"B is the state as it is now. Change something, then Tab goes between A and B.", ""});
  return false;
}

Box handle_box(const FrameContext& f) {
  const Box& panel = f.layout.main_box();
  const float grip = std::max(8.0f, f.type.small * 0.7f);
  const float x = panel.min.x + static_cast<float>(f.state.comparison.wipe) * panel.width();
  return {{x - grip, panel.min.y + 2 * line_height(f.type.body)},
          {x + grip, panel.max.y - 2 * line_height(f.type.body)}};
}

bool shown(const FrameContext& f) {
  return f.state.comparison.mode != CompareMode::off && !covered(f, f.layout.main_box());
}

void draw_image(FrameContext& f, const ViewImage& image, const Box& box) {
  const Zoom zoom = zoom_of(f, f.layout.main);
  const Box picture = picture_box(box, image.size);
  const glm::vec2 first(zoom.first()), last = first + 1 / static_cast<float>(zoom.scale);
  f.painter.list().AddImage(reinterpret_cast<ImTextureID>(image.texture), picture.min, picture.max,
                            {first.x, 1 - first.y}, {last.x, 1 - last.y});
}

// Above the lower edge, at one of its ends.
void draw_label(FrameContext& f, const Box& room, bool at_right, const std::string& text) {
  float px = f.type.body;
  const float pad = std::round(px * 0.4f);
  while (px > kSmallestPx && text_size(text, px).x + 2 * pad > room.width()) px -= 1;
  const ImVec2 size{std::min(text_size(text, px).x + 2 * pad, room.width()), line_height(px) + 2};
  const ImVec2 min{at_right ? room.max.x - size.x : room.min.x,
                   room.max.y - size.y - 3 * line_height(px) - f.layout.foot};
  f.painter.fill({min, {min.x + size.x, min.y + size.y}}, on_picture().backing);
  f.painter.text({min.x + pad, min.y + 1 + above_text(px)}, px, on_picture().accent, text);
}

void draw_missing(FrameContext& f, const Box& box, const std::string& why) {
  f.painter.fill(box, theme().surface);
  draw_paragraphs(f.painter, box.inset(box.width() * 0.1f), {{why, theme().text, f.type.body}}, 2);
}

void draw_wipe(FrameContext& f, const Box& panel, const CompareInput& in) {
  const float x = panel.min.x + static_cast<float>(f.state.comparison.wipe) * panel.width();
  const Box right{{x, panel.min.y}, panel.max};
  f.painter.list().PushClipRect(right.min, right.max, true);
  if (in.b.texture)
    draw_image(f, in.b, panel);
  else
    draw_missing(f, right, in.missing);
  f.painter.list().PopClipRect();
  f.painter.list().AddLine({x, panel.min.y}, {x, panel.max.y}, IM_COL32_BLACK, 3);
  f.painter.list().AddLine({x, panel.min.y}, {x, panel.max.y}, on_picture().accent, 1);
  const float y = (panel.min.y + panel.max.y) / 2, r = std::max(7.0f, f.type.small * 0.6f);
  for (const float sign : {-1.0f, 1.0f})
    f.painter.list().AddTriangleFilled({x + sign * 3, y - r}, {x + sign * 3, y + r}, {x + sign * (3 + r), y},
                                       on_picture().accent);
  draw_label(f, {panel.min, {x - 6, panel.max.y}}, true, label_of(f, true));
  draw_label(f, {{x + 6, panel.min.y}, panel.max}, false, label_of(f, false));
}

void draw_side(FrameContext& f, const Box& panel, const CompareInput& in) {
  const float middle = std::round((panel.min.x + panel.max.x) / 2);
  const Box right{{middle + 1, panel.min.y}, panel.max};
  f.painter.list().PushClipRect(right.min, right.max, true);
  f.painter.fill(right, IM_COL32_BLACK);
  if (in.b.texture)
    draw_image(f, in.b, right);
  else
    draw_missing(f, right, in.missing);
  f.painter.list().PopClipRect();
  draw_label(f, {panel.min, {middle - 1, panel.max.y}}, false, label_of(f, true));
  draw_label(f, right, false, label_of(f, false));
}

std::string numbers_of(const ErrorStats& e) {
  return fmt::format("largest {:.3g}   p99 {:.3g}   mean {:.3g}   signed mean {:+.2g}   codes of 255", e.max, e.p99,
                     e.mean, e.signed_mean);
}

void draw_difference(FrameContext& f, const Box& panel, const CompareInput& in) {
  f.painter.fill(panel, IM_COL32_BLACK);
  if (in.difference.texture)
    draw_image(f, in.difference, panel);
  else
    draw_missing(f, panel, in.missing);
  if (in.difference.texture)
    draw_legend(f.painter, {panel.min, {panel.max.x, panel.max.y - f.layout.foot}}, in.legend, f.type.body);
  const bool whole = zoom_of(f, f.layout.main).whole();
  const std::string numbers =
      in.stats ? fmt::format("{}{}", numbers_of(*in.stats), whole ? "" : "   (of the part that is seen)") : "";
  const float px = f.type.body, line = line_height(px) + 2;
  const float top = panel.min.y + 2 * line;
  const std::string names = fmt::format("{}   minus   {}", label_of(f, true), label_of(f, false));
  float y = top;
  for (const std::string& text : {names, numbers}) {
    if (text.empty()) continue;
    const Box back{{panel.min.x + 2, y},
                   {std::min(panel.max.x, panel.min.x + 2 + text_size(text, px).x + px), y + line}};
    f.painter.fill(back, on_picture().backing);
    f.painter.text_in({{back.min.x + px / 2, y + above_text(px)}, {back.max.x, back.max.y + px}}, px, on_picture().text,
                      text);
    y += line + 1;
  }
}

}  // namespace

bool compared(const Option& o) {
  const std::string_view path = o.path;
  return !path.starts_with("camera") && !path.starts_with("view.") && path != "time_s" && path != "size";
}

std::string differences(const Settings& of, const Settings& than) {
  std::string text;
  int more = 0, named = 0;
  for (const Option& o : options()) {
    if (!compared(o) || o.get(of) == o.get(than)) continue;
    if (named == kNamed) {
      ++more;
      continue;
    }
    text += fmt::format("{}{} {}", named++ ? ", " : "", o.label, value_text(o, of));
  }
  return more ? fmt::format("{} and {} more", text, more) : text;
}

void set_b(FrameContext& f, Settings s, const std::string& what) {
  Comparison& c = f.state.comparison;
  c.what = BesideA::settings, c.b_drawn = false;
  share_view(f.settings, s);
  c.other = std::move(s);
  if (c.mode == CompareMode::off) c.mode = CompareMode::wipe;
  say(f, {fmt::format("B is {}. / goes through wipe, side by side, difference; Tab flips.", what), ""});
}

void set_b_to_file(Comparison& c, std::string file) {
  c.what = BesideA::picture, c.file = std::move(file), c.other.reset(), c.b_drawn = false;
  if (c.mode == CompareMode::off) c.mode = CompareMode::wipe;
}

void flip(FrameContext& f, const KeyEvent&) {
  Comparison& c = f.state.comparison;
  if (c.what != BesideA::settings) {  // nothing to draw in A's place: the whole picture and back
    c.mode = CompareMode::wipe, c.wipe = c.wipe <= 0 ? 1 : 0;
    return say(f, {c.wipe <= 0 ? label_of(f, false) : "A", ""});
  }
  if (!find_b(f)) return;
  Settings now = f.settings;
  share_view(now, *c.other);
  if (!replace_settings(f, *c.other)) return;
  c.other = std::move(now);
  c.b_drawn = !c.b_drawn;
  f.state.history.pass_over(f.settings);
  const std::string what = differences(f.settings, *c.other);
  say(f, {fmt::format("{}: {}.", letter(c.b_drawn), what.empty() ? "the same as the other" : what), ""});
}

void next_mode(FrameContext& f, const KeyEvent& e) {
  Comparison& c = f.state.comparison;
  const int n = static_cast<int>(std::size(kModes)), step = e.shift ? n - 1 : 1;
  if (c.mode == CompareMode::off && !find_b(f)) return;
  c.mode = static_cast<CompareMode>((static_cast<int>(c.mode) + step) % n);
  if (c.wipe <= 0.01 || c.wipe >= 0.99) c.wipe = 0.5;
  say(f, {fmt::format("A and B: {}.", kModes[static_cast<int>(c.mode)]), ""});
}

void flip_to_cure(FrameContext& f, const KeyEvent& e) {
  Comparison& c = f.state.comparison;
  if (sound(f.settings)) {
    if (c.what == BesideA::settings && c.other && !sound(*c.other)) return flip(f, e);
    return say(f, {"All choices are sound: there is nothing to cure.", ""});
  }
  if (!c.other || !(differences(*c.other, cured(f.settings)).empty())) {
    c.what = BesideA::settings, c.b_drawn = false;
    c.other = cured(f.settings);
  }
  flip(f, e);
  if (f.state.caption) f.state.caption->sentence.text += " X goes back to what fails.";
}

Box box_of_a(const FrameContext& f, const Box& panel) {
  if (f.state.comparison.mode != CompareMode::side_by_side) return panel;
  return {panel.min, {std::round((panel.min.x + panel.max.x) / 2) - 1, panel.max.y}};
}

void use_wipe(FrameContext& f) {
  Comparison& c = f.state.comparison;
  if (!shown(f) || c.mode != CompareMode::wipe) return;
  hit_area("compare.wipe", handle_box(f));
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
    c.wipe = 0.5;
    return;
  }
  if (!ImGui::IsItemActive() || ImGui::GetIO().MouseDelta.x == 0) return;
  const Box& panel = f.layout.main_box();
  c.wipe = std::clamp((ImGui::GetIO().MousePos.x - panel.min.x) / double(panel.width()), 0.0, 1.0);
}

void draw_comparison(FrameContext& f, const Box& panel) {
  if (!shown(f) || !f.input.compare) return;
  const CompareInput& in = *f.input.compare;
  f.painter.list().PushClipRect(panel.min, panel.max, true);
  switch (f.state.comparison.mode) {
    case CompareMode::off: break;
    case CompareMode::wipe: draw_wipe(f, panel, in); break;
    case CompareMode::side_by_side: draw_side(f, panel, in); break;
    case CompareMode::difference: draw_difference(f, panel, in); break;
  }
  if (!in.note.empty())
    draw_label(f, {panel.min, {panel.max.x, panel.max.y - line_height(f.type.body)}}, true, in.note);
  f.painter.list().PopClipRect();
}

std::string comparison_in_words(const FrameContext& f) {
  const Comparison& c = f.state.comparison;
  if (!shown(f) || !c.has_b()) return "";
  const char* how = c.mode == CompareMode::wipe           ? "left and right of the line"
                    : c.mode == CompareMode::side_by_side ? "side by side"
                                                          : "difference in codes of the display";
  std::string text = fmt::format("{}   {}   {}", how, label_of(f, true), label_of(f, false));
  if (c.mode == CompareMode::difference && f.input.compare && f.input.compare->stats)
    text += "   " + numbers_of(*f.input.compare->stats);
  return text;
}

void ask_comparison(FrameContext& f) {
  const Comparison& c = f.state.comparison;
  if (!shown(f) || !c.has_b()) return;
  CompareRequest r{.what = c.what,
                   .view = f.layout.main,
                   .file = c.file,
                   .difference = c.mode == CompareMode::difference,
                   .with_sign = c.with_sign};
  if (c.other) r.b = *c.other;
  share_view(f.settings, r.b);
  const Zoom zoom = zoom_of(f, f.layout.main);
  if (!zoom.whole()) r.first = zoom.first(), r.share = glm::dvec2(1 / zoom.scale);
  if (c.what == BesideA::truth) f.requests.visible[static_cast<size_t>(View::reference)] = true;
  f.requests.compare = r;
}

}  // namespace gbl::ui
