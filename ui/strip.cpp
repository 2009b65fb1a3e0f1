// Below the pictures: how a frame flows through its targets, and one sentence: about the chosen view, or about what
// the last key did.
#include <algorithm>
#include <fmt/format.h>

#include "renderer/presets.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

// The first screen's question: from its camera cull `back` loses a whole light.
constexpr const char* kFirstQuestion = "Press C. One pool of light goes out. Why?";

std::vector<std::string> targets_of(const std::vector<Attachment>& all, Pass pass) {
  std::vector<std::string> lines;
  for (const Attachment& a : all)
    if (a.written_by == pass) lines.push_back(fmt::format("{}   {}   {} B", a.name, row(a.format).label, row(a.format).bytes));
  return lines;
}

constexpr Pass kFlow[] = {Pass::geometry, Pass::lighting, Pass::combine};
constexpr size_t kMostTargets = 3;

void draw_arrow(Painter& p, const Box& gap) {
  const float y = (gap.min.y + gap.max.y) / 2, size = gap.width() * 0.28f;
  p.list().AddLine({gap.min.x + size, y}, {gap.max.x - size, y}, kDim, 2);
  p.list().AddTriangleFilled({gap.max.x - size, y - size}, {gap.max.x - size / 4, y}, {gap.max.x - size, y + size}, kDim);
}

// Fill → Light → Combine, each with the targets that it writes; all lines in one size. Returns the height used.
float draw_flow(Frame& f, const Box& room, float most_height) {
  const std::vector<Attachment> all = attachments(f.settings);
  const float gap = std::round(28 * f.layout.unit), pad = std::round(8 * f.layout.unit);
  const float width = (room.width() - 2 * gap) / 3;
  float px = f.type.small;
  const auto height = [&] { return 2 * pad + line_height(px + 2) + kMostTargets * line_height(px); };
  while (px > kSmallestPx && height() > most_height) px -= 1;
  for (const Pass pass : kFlow)
    for (const std::string& line : targets_of(all, pass)) px = f.painter.fit(line, {width - 2.5f * pad, 99}, px, false);
  for (int i = 0; i < 3; ++i) {
    const float x = std::round(room.min.x + static_cast<float>(i) * (width + gap));
    const Box box{{x, room.min.y}, {x + width, room.min.y + height()}};
    f.painter.fill(box, kSurface, 4);
    f.painter.fill({box.min, {box.min.x + pad / 2, box.max.y}}, pass_colour(kFlow[i]));
    ImVec2 at{box.min.x + 1.5f * pad, box.min.y + pad};
    at.y += f.painter.text(at, px + 2, pass_colour(kFlow[i]), pass_label(kFlow[i])).y;
    for (const std::string& line : targets_of(all, kFlow[i])) {
      f.painter.text(at, px, kText, line);
      at.y += line_height(px);
    }
    if (i > 0) draw_arrow(f.painter, {{x - gap, box.min.y}, {x, box.max.y}});
  }
  return height();
}

void draw_caption(Frame& f, const Box& room) {
  const Sentence& s = f.state.caption->sentence;
  const float bar = std::round(5 * f.layout.unit);
  f.painter.fill({room.min, {room.min.x + bar, room.max.y}}, s.pitfall.empty() ? kAccent : kUnsound);
  std::vector<Paragraph> paragraphs{{s.text, kText, f.type.large}};
  if (!s.pitfall.empty()) paragraphs.push_back({fmt::format("{} UNSOUND: {}.", kUnsoundSign, s.pitfall), kUnsound, f.type.large});
  draw_paragraphs(f.painter, {{room.min.x + 3 * bar, room.min.y}, room.max}, paragraphs, 2);
}

void draw_sentences(Frame& f, const Box& room) {
  const ViewRow& v = row(f.chosen());
  std::vector<Paragraph> paragraphs{
      {fmt::format("{}{}{}: {}", v.key, *v.key ? "  " : "", v.label, v.sentence), kText, f.type.body}};
  const Preset* now = preset_of(f.settings);
  if (now && std::string_view(now->id) == "start") paragraphs.push_back({kFirstQuestion, kAccent, f.type.large});
  draw_paragraphs(f.painter, room, paragraphs, std::round(5 * f.layout.unit));
}

}  // namespace

void draw_strip(Frame& f) {
  if (f.state.lesson) return draw_lesson(f, f.layout.strip);
  const Box room = f.layout.strip.inset(std::round(10 * f.layout.unit));
  const float used = draw_flow(f, room, room.height() * 0.52f) + std::round(8 * f.layout.unit);
  const Box rest{{room.min.x, room.min.y + used}, room.max};
  if (f.state.caption) draw_caption(f, rest);
  else draw_sentences(f, rest);
}

}  // namespace gbl::ui
