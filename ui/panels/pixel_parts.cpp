#include "ui/panels/pixel_parts.h"

#include <fmt/format.h>

namespace gbl::ui {

std::string numbers(const std::vector<double>& values, int digits) {
  std::string text;
  for (const double v : values) text += fmt::format("{}{:.{}g}", text.empty() ? "" : "  ", v, digits);
  return text;
}

bool Table::row(std::initializer_list<std::pair<std::string_view, ImU32>> cells) {
  if (shelf_.room.height() < line_height(px_)) return false;
  const Box line = shelf_.below(line_height(px_));
  float x = line.min.x;
  size_t k = 0;
  for (const auto& [text, colour] : cells) {
    const float width = line.width() * shares_[k++];
    if (!text.empty()) p_.text_in({{x, line.min.y}, {x + width - px_ * 0.5f, line.max.y}}, px_, colour, text);
    x += width;
  }
  return true;
}

void heading(Painter& p, Shelf& shelf, float px, std::string_view text) {
  if (shelf.room.height() < 2 * line_height(px)) return;
  p.text_in(shelf.below(line_height(px)), px, theme().accent, text);
}

}  // namespace gbl::ui
