// Below the pictures: how a frame flows through its targets, and one sentence: about the chosen view, or about what
// the last key did.
#include <algorithm>
#include <fmt/format.h>

#include "renderer/options/presets.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

constexpr size_t kMostTargets = 3;  // one below the other; more stand in columns

// The first screen's question: from its camera cull `back` loses a whole light.
constexpr const char* kFirstQuestion = "Press C. One pool of light goes out. Why?";

std::vector<std::string> targets_of(const std::vector<Attachment>& all, Pass pass) {
  std::vector<const Attachment*> written;
  for (const Attachment& a : all)
    if (a.written_by == pass) written.push_back(&a);
  std::vector<std::string> lines;
  for (const Attachment* a : written) {
    std::string_view name = a->name;
    if (written.size() > kMostTargets && name.starts_with("gbuffer.")) name.remove_prefix(8);  // many: short names
    lines.push_back(fmt::format("{}   {}   {} B", name, row(a->format).label, row(a->format).bytes));
  }
  return lines;
}

constexpr Pass kFlow[] = {Pass::geometry, Pass::lighting, Pass::combine};

void draw_arrow(Painter& p, const Box& gap) {
  const float y = (gap.min.y + gap.max.y) / 2, size = gap.width() * 0.28f;
  p.list().AddLine({gap.min.x + size, y}, {gap.max.x - size, y}, theme().dim, 2);
  p.list().AddTriangleFilled({gap.max.x - size, y - size}, {gap.max.x - size / 4, y}, {gap.max.x - size, y + size},
                             theme().dim);
}

float widest(const std::vector<std::string>& lines, float px) {
  float width = 0;
  for (const std::string& line : lines) width = std::max(width, text_size(line, px).x);
  return width;
}

size_t columns_of(const std::vector<std::string>& lines) { return (lines.size() + kMostTargets - 1) / kMostTargets; }

// Fill → Light → Combine, each with the targets that it writes; all lines in one size, each box as wide as it needs
// and a third of what is left over. Returns the height used.
float draw_flow(FrameContext& f, const Box& room, float most_height) {
  const std::vector<Attachment> all = attachments(f.stored);
  const std::vector<std::string> lines[] = {targets_of(all, kFlow[0]), targets_of(all, kFlow[1]),
                                            targets_of(all, kFlow[2])};
  const float gap = std::round(28 * f.layout.unit), pad = std::round(7 * f.layout.unit);
  float px = f.type.body;
  const auto height = [&] { return 2 * pad + kMostTargets * line_height(px); };
  const auto column_width = [&](int i) { return widest(lines[i], px) + 2 * pad; };
  const auto need = [&](int i) {
    return column_width(i) * static_cast<float>(columns_of(lines[i])) + text_size(pass_label(kFlow[i]), px + 2).x +
           3 * pad;
  };
  const auto spare = [&] { return room.width() - 2 * gap - need(0) - need(1) - need(2); };
  while (px > kSmallestPx && (height() > most_height || spare() < 0)) px -= 1;
  float x = room.min.x;
  for (int i = 0; i < 3; ++i) {
    const float width = std::round(need(i) + spare() / 3);
    const Box box{{x, room.min.y}, {x + width, room.min.y + height()}};
    f.painter.fill(box, theme().surface, 4);
    f.painter.fill({box.min, {box.min.x + pad / 2, box.max.y}}, pass_colour(kFlow[i]));
    const ImVec2 title{box.min.x + 2 * pad, (box.min.y + box.max.y - px - 2) / 2};
    const float left = title.x + f.painter.text(title, px + 2, pass_colour(kFlow[i]), pass_label(kFlow[i])).x + 2 * pad;
    const size_t rows_used = std::min(lines[i].size(), kMostTargets);
    const float top = (box.min.y + box.max.y - static_cast<float>(rows_used) * line_height(px)) / 2;
    for (size_t k = 0; k < lines[i].size(); ++k) {
      const auto column = static_cast<float>(k / kMostTargets), line = static_cast<float>(k % kMostTargets);
      f.painter.text({left + column * column_width(i), top + line * line_height(px) + above_text(px)}, px, theme().text,
                     lines[i][k]);
    }
    if (i > 0) draw_arrow(f.painter, {{x - gap, box.min.y}, {x, box.max.y}});
    x += width + gap;
  }
  return height();
}

void draw_caption(FrameContext& f, const Box& room) {
  const Sentence& s = f.state.caption->sentence;
  const float bar = std::round(5 * f.layout.unit);
  f.painter.fill({room.min, {room.min.x + bar, room.max.y}}, s.pitfall.empty() ? theme().accent : theme().unsound);
  std::vector<Paragraph> paragraphs{{s.text, theme().text, f.type.large}};
  if (!s.pitfall.empty())
    paragraphs.push_back(
        {fmt::format("{} UNSOUND: {}. X takes the sound choice, and goes back; P shows why.", kUnsoundSign, s.pitfall),
         theme().unsound, f.type.large});
  draw_paragraphs(f.painter, {{room.min.x + 3 * bar, room.min.y}, room.max}, paragraphs, 2);
}

constexpr const char* kDeferredShading =
    "Deferred shading draws the surfaces once, into buffers. Then it lights only the pixels that each light reaches.";
constexpr const char* kFirstKeys = "PgDn: a lesson.   H: what is this buffer?   F1: all keys.";

void draw_sentences(FrameContext& f, const Box& room) {
  const ViewRow& v = row(f.chosen());
  const Preset* now = preset_of(f.settings);
  const bool start = now && std::string_view(now->id) == "start";
  std::vector<Paragraph> paragraphs{{fmt::format("{}{}{}: {}", v.key, *v.key ? "  " : "", v.label, v.sentence),
                                     theme().text, start ? f.type.body + 1 : f.type.large}};
  if (start) {
    paragraphs.insert(paragraphs.begin(), {kDeferredShading, theme().text, f.type.body + 1});
    paragraphs.push_back({kFirstQuestion, theme().accent, f.type.large});
    paragraphs.push_back({kFirstKeys, theme().dim, f.type.body + 1});
  }
  draw_paragraphs(f.painter, room, paragraphs, std::round(5 * f.layout.unit));
}

}  // namespace

void draw_strip(FrameContext& f) {
  if (f.state.lesson) return draw_lesson(f, f.layout.strip);
  const Box room = f.layout.strip.inset(std::round(10 * f.layout.unit));
  const float used = draw_flow(f, room, room.height() * 0.57f) + std::round(8 * f.layout.unit);
  const Box rest{{room.min.x, room.min.y + used}, room.max};
  if (f.state.caption)
    draw_caption(f, rest);
  else
    draw_sentences(f, rest);
}

}  // namespace gbl::ui
