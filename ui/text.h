#pragma once
// Drawing text and boxes. A text is never cut off and never overlaps: it shrinks until it fits its place, and one
// that no legible size fits is noted, so that a test can demand that there is none.
#include <cmath>
#include <imgui.h>
#include <string>
#include <string_view>
#include <vector>

#include "ui/theme.h"

namespace gbl::ui {

struct Box {
  ImVec2 min{0, 0}, max{0, 0};
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
  ImVec2 size() const { return {width(), height()}; }
  bool contains(const Box& b) const {
    return b.min.x >= min.x && b.min.y >= min.y && b.max.x <= max.x && b.max.y <= max.y;
  }
  Box inset(float by) const { return {{min.x + by, min.y + by}, {max.x - by, max.y - by}}; }
};

inline constexpr float kSmallestPx = 9;  // below this no projector shows a letter

ImVec2 text_size(std::string_view, float px, float wrap = 0);

class Painter {
 public:
  Painter(ImDrawList& list, std::vector<std::string>& cut_texts) : list_(&list), cut_(&cut_texts) {}
  ImDrawList& list() const { return *list_; }

  // The largest whole size up to `px` at which the text fits the room, on one line or wrapped.
  float fit(std::string_view, ImVec2 room, float px, bool wrap);

  // Both return the size that the text takes.
  ImVec2 text(ImVec2 at, float px, ImU32 colour, std::string_view, float wrap = 0);
  ImVec2 text_in(const Box&, float px, ImU32 colour, std::string_view, bool wrap = false);  // shrinks to fit

  // A key cap; returns its width.
  float key_cap(ImVec2 at, float px, std::string_view key);

  void fill(const Box& b, ImU32 colour, float rounding = 0) { list_->AddRectFilled(b.min, b.max, colour, rounding); }
  void outline(const Box& b, ImU32 colour, float thickness);  // inside the box

 private:
  ImDrawList* list_;
  std::vector<std::string>* cut_;
};

// Paragraphs below each other in one box, all shrunk by the same factor.
struct Paragraph {
  std::string text;
  ImU32 colour;
  float px;
};
void draw_paragraphs(Painter&, const Box&, const std::vector<Paragraph>&, float gap);

// A label beside each wrapped text, all shrunk by the same factor until they fit the box.
struct Field {
  std::string label, text;
  ImU32 colour;
};
void draw_fields(Painter&, const Box&, const std::vector<Field>&, float px, ImU32 label_colour = theme().dim);

// A part of the window that can be clicked; true when it was. ImGui does not take one without an area: that is skipped.
bool hit_area(const char* id, const Box&);

float line_height(float px);
inline float above_text(float px) { return std::floor((line_height(px) - px) / 2); }  // centres it in its line
float key_cap_width(std::string_view key, float px);

}  // namespace gbl::ui
