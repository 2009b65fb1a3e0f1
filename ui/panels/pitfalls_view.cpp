#include "ui/panels/pitfalls_view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gbl::ui {
namespace {

constexpr const char* kShown[] = {"BROKEN", "FIXED", "the REFERENCE of the broken one",
                                  "broken and fixed: the DIFFERENCE", "broken, WHERE IT HIDES"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string numbers_of(const FrameContext& f, const PitfallEntry& e) {
  const PitfallMetric& m = pitfall_metric(e.metric);
  const PitfallInput* in = f.input.pitfall;
  if (!in || in->id != e.id) return m.help;
  const auto text = [&](std::optional<double> n) { return n ? number_text(n) : in->running ? "…" : "none"; };
  std::string out = fmt::format("{} broken, {} fixed", text(in->broken), text(in->fixed));
  if (e.blind) out += fmt::format(", {} where it hides", text(in->blind));
  return fmt::format("{}: {}{}", out, m.help, *m.unit ? fmt::format(" ({})", m.unit) : "");
}

}  // namespace

std::vector<size_t> found_entries(const PitfallsState& s) {
  std::vector<size_t> out;
  const std::string wanted = lower(s.find);
  for (size_t i = 0; i < s.entries.size(); ++i) {
    const PitfallEntry& e = s.entries[i];
    if (lower(e.id + " " + e.title + " " + e.symptom + " " + e.source).find(wanted) != std::string::npos)
      out.push_back(i);
  }
  return out;
}

std::optional<size_t> draw_pitfall_list(const PitfallsState& s, Painter& p, const Box& room, float px) {
  const float row = std::round(line_height(px) * 1.15f);
  const std::vector<size_t> found = found_entries(s);
  // Lines: a group's name, then its entries.
  struct Line {
    std::string heading;
    size_t entry = 0;
  };
  std::vector<Line> lines;
  size_t at_chosen = 0;
  for (const PitfallGroup& g : pitfall_groups()) {
    bool any = false;
    for (const size_t i : found) {
      if (s.entries[i].group != g.id) continue;
      if (!any) lines.push_back({g.label, 0});
      any = true;
      if (i == s.chosen) at_chosen = lines.size();
      lines.push_back({"", i});
    }
  }
  if (lines.empty()) {
    draw_paragraphs(p, room, {{"Nothing is found.", theme().dim, px}}, 2);
    return {};
  }
  std::optional<size_t> clicked;
  const auto fit = static_cast<size_t>(std::max(1.0f, room.height() / row));
  const size_t first = lines.size() <= fit ? 0 : std::min(at_chosen - std::min(at_chosen, fit / 2), lines.size() - fit);
  float y = room.min.y;
  for (size_t i = first; i < std::min(lines.size(), first + fit); ++i, y += row) {
    const Box line{{room.min.x, y}, {room.max.x, y + row - 1}};
    if (!lines[i].heading.empty()) {
      p.text_in({{line.min.x, line.min.y + above_text(px)}, {line.max.x, line.max.y + px}}, px, theme().accent,
                lines[i].heading);
      continue;
    }
    const PitfallEntry& e = s.entries[lines[i].entry];
    if (hit_area(e.id.c_str(), line)) clicked = lines[i].entry;
    if (lines[i].entry == s.chosen) p.outline(line, theme().accent, 2);
    const std::string lecture = e.lecture > 0 ? fmt::format("{} ", e.lecture) : "";
    p.text_in({{line.min.x + px, line.min.y + above_text(px)}, {line.max.x - 4, line.max.y + px}}, px, theme().text,
              lecture + e.title);
  }
  return clicked;
}

void draw_pitfall_entry(const FrameContext& f, const OpenPitfall& o, Painter& p, const Box& room) {
  const PitfallEntry& e = o.entry;
  const float px = std::round(f.type.body * 1.3f);  // shrinks until all of it fits
  const ImU32 shown = o.shown == Shown::fixed ? theme().accent : theme().unsound;
  std::vector<Paragraph> words = {{e.title, theme().accent, px * 1.2f}, {kShown[static_cast<int>(o.shown)], shown, px}};
  if (!o.revealed) {
    words.push_back({e.question, theme().text, px * 1.2f});
    words.push_back({"Enter shows the answer.", theme().dim, f.type.body});
    return draw_paragraphs(p, room, words, px * 0.6f);
  }
  words.push_back({e.symptom, theme().text, px});
  words.push_back({numbers_of(f, e), theme().accent, px});
  if (f.input.pitfall && f.input.pitfall->id == e.id && !f.input.pitfall->note.empty())
    words.push_back({f.input.pitfall->note, theme().unsound, px});
  words.push_back({"Why: " + e.cause, theme().text, px});
  words.push_back({"Do: " + e.do_this, theme().text, px});
  words.push_back({"Don't: " + e.do_not, theme().text, px});
  words.push_back({"Impact: " + e.impact, theme().text, px});
  words.push_back({"How to see it: " + e.see, theme().text, px});
  words.push_back({"What is left: " + e.still, theme().text, px});
  if (e.blind) words.push_back({"Where it hides: " + e.blind->why, theme().text, px});
  words.push_back({fmt::format("{}\n{}", e.id, e.source), theme().dim, f.type.body});
  draw_paragraphs(p, room, words, px * 0.4f);
}

void draw_pitfall_path(const FrameContext& f, const OpenPitfall& o, Painter& p, const Box& box) {
  const PitfallInput* in = f.input.pitfall;
  const float px = f.type.small, line = line_height(px);
  p.text_in({box.min, {box.max.x, box.min.y + line}}, px, theme().dim, "the number along its path: broken, and fixed");
  const Box room{{box.min.x, box.min.y + line + 4}, box.max};
  p.fill(room, theme().surface);
  if (!in || in->id != o.entry.id) return;
  double most = 0;
  for (const auto* curve : {&in->path_broken, &in->path_fixed})
    for (const double n : *curve) most = std::max(most, std::isfinite(n) ? n : 0);
  const auto place = [&](size_t i, double n) {
    const double up = most > 0 && std::isfinite(n) ? n / most : n > 0;
    return ImVec2{room.min.x + room.width() * static_cast<float>(i) / (kPathPoints - 1),
                  room.max.y - 3 - static_cast<float>(up) * (room.height() - 6)};
  };
  for (const auto& [curve, colour] :
       {std::pair(&in->path_fixed, theme().accent), {&in->path_broken, theme().unsound}}) {
    std::vector<ImVec2> places;
    for (size_t i = 0; i < curve->size(); ++i) places.push_back(place(i, (*curve)[i]));
    p.list().AddPolyline(places.data(), static_cast<int>(places.size()), colour, 0, 2);
  }
  if (!o.along) return;
  const float x = room.min.x + room.width() * static_cast<float>(*o.along);
  p.list().AddLine({x, room.min.y}, {x, room.max.y}, theme().text, 2);
}

}  // namespace gbl::ui
