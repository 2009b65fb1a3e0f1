#include "ui/panels/pitfalls_view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

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

constexpr float kEntryLines = 3.4f;  // of text: two for the title, one for its number

// A group's name or an entry.
struct PitfallLine {
  std::string heading = {};
  size_t entry = 0;
};

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

static std::vector<PitfallLine> lines_of(const PitfallsState& s) {
  const std::vector<size_t> found = found_entries(s);
  std::vector<PitfallLine> lines;
  for (const PitfallGroup& g : pitfall_groups()) {
    bool any = false;
    for (const size_t i : found) {
      if (s.entries[i].group != g.id) continue;
      if (!std::exchange(any, true)) lines.push_back({.heading = g.label});
      lines.push_back({.entry = i});
    }
  }
  return lines;
}

// Broken and fixed, and beside them what it is.
static void draw_line(const FrameContext& f, const PitfallEntry& e, Painter& p, const Box& line) {
  const float px = f.type.small, gap = std::round(px * 0.4f);
  const glm::vec2 picture = glm::vec2(kPitfallPicture) * ((line.height() - 2 * gap) / kPitfallPicture.y);
  float x = line.min.x + gap;
  const PitfallPicture* drawn = nullptr;
  if (const PitfallPictures* all = f.input.pitfall_pictures)
    if (const auto it = all->find(e.id); it != all->end()) drawn = &it->second;
  for (const uint64_t side : {drawn ? drawn->broken : 0, drawn ? drawn->fixed : 0}) {
    const Box at{{x, line.min.y + gap}, {x + picture.x, line.min.y + gap + picture.y}};
    if (side != 0)
      p.list().AddImage(reinterpret_cast<ImTextureID>(side), at.min, at.max, {0, 1}, {1, 0});
    else
      p.fill(at, theme().surface);
    x += picture.x + gap;
  }
  const std::string lecture = e.lecture > 0 ? fmt::format("{} ", e.lecture) : "";
  const Box words{{x + gap, line.min.y + gap}, {line.max.x - gap, line.max.y - gap}};
  const float below = words.max.y - line_height(px * 0.9f);
  p.text_in({words.min, {words.max.x, below}}, px, theme().text, lecture + e.title, true);
  const PitfallBounds bounds = e.toward_zero.value_or(e.bounds);  // some show on devices that truncate only
  p.text_in(
      {{words.min.x, below}, words.max}, px * 0.9f, theme().dim,
      fmt::format("{}: {} → {}", e.metric, number_text(bounds.broken_at_least), number_text(bounds.fixed_at_most)));
}

std::optional<size_t> draw_pitfall_list(const FrameContext& f, const PitfallsState& s, Painter& p, const Box& room) {
  const float px = f.type.small;
  const std::vector<PitfallLine> lines = lines_of(s);
  if (lines.empty()) {
    draw_paragraphs(p, room, {{"Nothing is found.", theme().dim, px}}, 2);
    return {};
  }
  const auto height = [&](const PitfallLine& l) {
    return std::round(line_height(px) * (l.heading.empty() ? kEntryLines : 1.3f));
  };
  // From here on the chosen one is in the middle, as far as the list's ends allow.
  float above = 0, total = 0;
  for (const PitfallLine& l : lines) {
    if (l.heading.empty() && l.entry == s.chosen) above = total + height(l) / 2;
    total += height(l);
  }
  const float top = std::clamp(above - room.height() / 2, 0.0f, std::max(0.0f, total - room.height()));
  std::optional<size_t> clicked;
  float y = room.min.y - top;
  for (const PitfallLine& l : lines) {
    const Box line{{room.min.x, y}, {room.max.x, y + height(l) - 1}};
    y += height(l);
    if (line.min.y < room.min.y - 1 || line.max.y > room.max.y + 1) continue;  // whole ones only
    if (!l.heading.empty()) {
      p.text_in({{line.min.x, line.min.y + above_text(px)}, line.max}, px, theme().accent, l.heading);
      continue;
    }
    if (hit_area(s.entries[l.entry].id.c_str(), line)) clicked = l.entry;
    draw_line(f, s.entries[l.entry], p, line);
    if (l.entry == s.chosen) p.outline(line, theme().accent, 2);
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
