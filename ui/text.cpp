#include "ui/text.h"

#include <cfloat>
#include <cmath>

#include "ui/style.h"

namespace gbl::ui {

bool hit_area(const char* id, const Box& box) {
  if (box.width() < 1 || box.height() < 1) return false;
  ImGui::SetCursorScreenPos(box.min);
  return ImGui::InvisibleButton(id, box.size());
}

float line_height(float px) { return std::round(px * 1.28f); }

namespace {

ImVec2 size_of(std::string_view text, float px, float wrap) {
  return font_for(px)->CalcTextSizeA(px, FLT_MAX, wrap, text.data(), text.data() + text.size());
}

// Lines end at spaces. ImGui would break at any stop as well, which cuts 16.0 in two; it still breaks a word that no line
// has room for.
std::string broken_at_spaces(std::string_view text, float px, float width) {
  std::string out(text);
  size_t begin = 0, last_space = std::string::npos;
  for (size_t i = 0; i <= out.size(); ++i) {
    const bool ends = i == out.size() || out[i] == '\n';
    if (!ends && out[i] != ' ') continue;
    if (last_space != std::string::npos && size_of(std::string_view(out).substr(begin, i - begin), px, 0).x > width) {
      out[last_space] = '\n';
      begin = last_space + 1;
    }
    last_space = ends ? std::string::npos : i;
    if (ends) begin = i + 1;
  }
  return out;
}

}  // namespace

ImVec2 text_size(std::string_view text, float px, float wrap) {
  return wrap > 0 ? size_of(broken_at_spaces(text, px, wrap), px, wrap) : size_of(text, px, 0);
}

float Painter::fit(std::string_view text, ImVec2 room, float px, bool wrap) {
  for (px = std::floor(px);; px -= 1) {
    const ImVec2 size = text_size(text, px, wrap ? room.x : 0);
    if (size.x <= room.x + 0.5f && size.y <= room.y + 0.5f) return px;
    if (px > kSmallestPx) continue;
    cut_->emplace_back(text);
    return kSmallestPx;
  }
}

ImVec2 Painter::text(ImVec2 at, float px, ImU32 colour, std::string_view text, float wrap) {
  at = {std::floor(at.x), std::floor(at.y)};
  const std::string lines = wrap > 0 ? broken_at_spaces(text, px, wrap) : std::string(text);
  list_->AddText(font_for(px), px, at, colour, lines.data(), lines.data() + lines.size(), wrap);
  return size_of(lines, px, wrap);
}

ImVec2 Painter::text_in(const Box& box, float px, ImU32 colour, std::string_view what, bool wrap) {
  return text(box.min, fit(what, box.size(), px, wrap), colour, what, wrap ? box.width() : 0);
}

float key_cap_width(std::string_view key, float px) {
  return std::max(text_size(key, px).x + px * 0.6f, line_height(px));
}

float Painter::key_cap(ImVec2 at, float px, std::string_view key) {
  const float width = key_cap_width(key, px);
  const Box cap{at, {at.x + width, at.y + line_height(px)}};
  fill(cap, theme().raised, 3);
  list_->AddRect(cap.min, cap.max, theme().line, 3);
  const ImVec2 size = text_size(key, px);
  text({at.x + (width - size.x) / 2, at.y + (cap.height() - size.y) / 2}, px, theme().accent, key);
  return width;
}

void Painter::outline(const Box& b, ImU32 colour, float thickness) {
  const float half = thickness / 2;
  list_->AddRect({b.min.x + half, b.min.y + half}, {b.max.x - half, b.max.y - half}, colour, 0, 0, thickness);
}

void draw_paragraphs(Painter& p, const Box& box, const std::vector<Paragraph>& paragraphs, float gap) {
  const auto height_at = [&](float k) {
    float height = 0;
    for (const Paragraph& q : paragraphs)
      height += text_size(q.text, std::max(kSmallestPx, std::floor(q.px * k)), box.width()).y + gap * k;
    return height - gap * k;
  };
  float k = 1;
  while (k > 0.3f && height_at(k) > box.height()) k -= 0.04f;
  ImVec2 at = box.min;
  for (const Paragraph& q : paragraphs) {
    const float px = p.fit(q.text, {box.width(), box.max.y - at.y}, std::max(kSmallestPx, std::floor(q.px * k)), true);
    at.y += p.text(at, px, q.colour, q.text, box.width()).y + gap * k;
  }
}

void draw_fields(Painter& p, const Box& box, const std::vector<Field>& fields, float px, ImU32 label_colour) {
  float label = 0, gap = 0;
  const auto height = [&](const Field& q) { return text_size(q.text, px, box.width() - label).y + gap; };
  const auto total = [&] {
    label = 0;
    gap = std::round(px * 0.3f);
    for (const Field& q : fields) label = std::max(label, text_size(q.label, px).x + px);
    float sum = 0;
    for (const Field& q : fields) sum += height(q);
    return sum;
  };
  while (total() > box.height() && px > kSmallestPx) px -= 1;
  float y = box.min.y;
  for (const Field& q : fields) {
    const Box room{{box.min.x + label, y}, {box.max.x, box.max.y}};
    p.text({box.min.x, y}, px, label_colour, q.label);
    p.text_in(room, px, q.colour, q.text, true);
    y += height(q);
  }
}

}  // namespace gbl::ui
