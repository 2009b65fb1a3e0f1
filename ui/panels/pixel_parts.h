#pragma once
// The parts of the panel of Ctrl+P (pixel.cpp), and the tables that they are made of.
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "renderer/truth/pixel_account.h"
#include "ui/panels/side_panel.h"

namespace gbl::ui {

// Numbers beside each other.
std::string numbers(const std::vector<double>&, int digits = 6);

// A table: cells stand below each other, each column as wide as its share says.
class Table {
 public:
  Table(Painter& p, Shelf& shelf, float px, std::vector<float> shares)
      : p_(p), shelf_(shelf), px_(px), shares_(std::move(shares)) {}
  bool row(std::initializer_list<std::pair<std::string_view, ImU32>> cells);  // false: no room is left

 private:
  Painter& p_;
  Shelf& shelf_;
  float px_;
  std::vector<float> shares_;
};

void heading(Painter&, Shelf&, float px, std::string_view);

// Lines of a page that is longer than its room: the first on screen, and how many were there in the last frame.
struct Scroll {
  size_t first = 0, shown = 0, all = 0;
};

// Of the main view: the pixels around the held one as squares, and the numbers of that one, where it has any.
float loupe_side(const FrameContext&);
void draw_loupe(FrameContext&, Painter&, const Box&);
std::string loupe_numbers(FrameContext&);

// Two of the pages.
void draw_bits(FrameContext&, Painter&, Shelf&, float px, const PixelProbe&, Scroll&);
void draw_positions(Painter&, Shelf&, float px, const PixelAccount&);

}  // namespace gbl::ui
