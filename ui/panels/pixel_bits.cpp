// The page of bits: each attachment's texel, field by field, in binary, as a code and as what it means.
#include <fmt/format.h>

#include "renderer/inspect/stored_bits.h"
#include "ui/panels/pixel_parts.h"

namespace gbl::ui {
namespace {

constexpr int kBitsInALine = 34;  // more, and each component has a line of its own

struct Line {
  std::string name, place, binary, code, value;
  bool texel = false;  // of an attachment: what follows is in it
};

std::string codes_of(const std::vector<uint32_t>& codes) {
  std::string text;
  for (const uint32_t c : codes) text += fmt::format("{}{}", text.empty() ? "" : " ", c);
  return text;
}

size_t bits_of(const FieldRead& r) {
  size_t bits = 0;
  for (const std::string& b : r.binary) bits += b.size();
  return bits;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text)
    if (c == ' ')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

// A float's bits are no code that anybody counts in; what is unused means nothing.
void add_field(const FieldRead& r, std::vector<Line>& lines) {
  const bool floating = r.field.kind == CodeKind::floating, meant = r.field.name != kUnusedBits;
  const std::string means = meant ? numbers(r.values, r.values.size() == 1 ? 9 : 4) : "";
  if (bits_of(r) <= kBitsInALine) {
    const std::string code = floating || !meant ? "" : codes_of(r.codes);
    lines.push_back({r.field.name, r.place, fmt::format("{}", fmt::join(r.binary, "  ")), code, means});
    return;
  }
  const bool one_meaning = r.values.size() != r.binary.size() || r.field.kind == CodeKind::normal;
  const std::vector<std::string> places = words_of(r.place);
  for (size_t c = 0; c < r.binary.size(); ++c)
    lines.push_back({c == 0 ? r.field.name : "", places.at(c), r.binary[c],
                     floating || !meant ? "" : fmt::format("{}", r.codes[c]),
                     !one_meaning && meant ? numbers({r.values[c]}, 9)
                     : c == 0              ? means
                                           : ""});
}

std::vector<Line> lines_of(const Settings& drawn, const PixelProbe& probe) {
  std::vector<Line> lines;
  for (const StoredTexel& t : probe.stored) {
    lines.push_back({t.attachment.name, row(t.attachment.format).label, hex(t), "", "", true});
    for (const FieldRead& r : read_fields(drawn, t)) add_field(r, lines);
  }
  return lines;
}

}  // namespace

void draw_bits(FrameContext& f, Painter& p, Shelf& shelf, float px, const PixelProbe& probe, Scroll& scroll) {
  const std::vector<Line> lines = lines_of(f.stored, probe);
  heading(p, shelf, px, "stored: in hexadecimal, then each field's bits, its code and what it means");
  Table texels(p, shelf, px, {0.3f, 0.15f, 0.55f}), fields(p, shelf, px, {0.02f, 0.2f, 0.13f, 0.33f, 0.1f, 0.22f});
  scroll.all = lines.size();
  scroll.first = std::min(scroll.first, lines.empty() ? 0 : lines.size() - 1);
  scroll.shown = 0;
  for (size_t i = scroll.first; i < lines.size(); ++i, ++scroll.shown) {
    const Line& l = lines[i];
    const ImU32 ink = l.name == kUnusedBits ? theme().dim : theme().text;
    const bool drawn =
        l.texel
            ? texels.row({{l.name, theme().accent}, {l.place, theme().dim}, {l.binary, theme().dim}})
            : fields.row(
                  {{"", ink}, {l.name, ink}, {l.place, theme().dim}, {l.binary, ink}, {l.code, ink}, {l.value, ink}});
    if (!drawn) break;
  }
}

}  // namespace gbl::ui
