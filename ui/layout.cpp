#include "ui/layout.h"

#include <algorithm>
#include <cmath>

namespace gbl::ui {
namespace {

struct Cell {
  View view;
  float x, y, width;  // height follows: 9/16 of the width
};
constexpr Cell kMosaic[] = {{View::final, 0, 0, 800},
                            {View::albedo, 800, 0, 400},
                            {View::normal, 1200, 0, 400},
                            {View::depth, 800, 225, 400},
                            {View::material, 1200, 225, 400},
                            {View::diffuse_light, 0, 450, 400},
                            {View::specular_light, 400, 450, 400},
                            {View::lights_per_pixel, 800, 450, 400}};
constexpr float kColumnX = 1200, kColumnY = 450, kStripY = 675;

}  // namespace

Layout make_layout(const LayoutInput& in) {
  Layout l;
  l.unit = std::min(in.display.x / 1600, in.display.y / 900);
  const float left = std::floor((in.display.x - 1600 * l.unit) / 2);
  const float right = in.display.x - left, bottom = in.display.y;
  // Edges are rounded, not sizes: neighbours share an edge and no gap opens at any scale.
  const auto at = [&](float x, float y) { return ImVec2{left + std::round(x * l.unit), std::round(y * l.unit)}; };
  const auto place = [&](const Cell& c) {
    l.panels[static_cast<size_t>(c.view)] = Box{at(c.x, c.y), at(c.x + c.width, c.y + c.width * 9 / 16)};
  };
  l.canvas = {{left, 0}, {right, bottom}};
  const float status_top = bottom - in.status_height;
  l.status = {{left, status_top}, {right, bottom}};
  l.strip = {at(0, kStripY), {at(kColumnX, 0).x, status_top}};
  l.column = {at(kColumnX, in.large ? 0 : kColumnY), {right, status_top}};
  if (in.present) {
    l.strip.max.x = right;
    l.column = {{right, 0}, {right, status_top}};
  }
  if (in.large) {
    l.main = in.chosen;
    place({in.chosen, 0, 0, in.beside ? 800.0f : in.hidden || in.present ? 1600.0f : kColumnX});
  } else {
    const std::vector<LookOf> page = in.page.empty() ? usual_panels() : in.page;
    l.main = view_by_id(page[0].view).view;
    for (size_t i = 0; i < std::min(page.size(), std::size(kMosaic)); ++i) {
      Cell c = kMosaic[i];
      c.view = view_by_id(page[i].view).view;
      const bool shown = l.panels[static_cast<size_t>(c.view)].has_value();
      if (i > 0 && (!page[i].look.plain() || shown))
        l.locked.push_back({page[i], i, Box{at(c.x, c.y), at(c.x + c.width, c.y + c.width * 9 / 16)}});
      else
        place(c);
    }
  }
  return l;
}

std::vector<LookOf> usual_panels() {
  std::vector<LookOf> out;
  for (const Cell& c : kMosaic) out.push_back({row(c.view).id, {}});
  return out;
}

}  // namespace gbl::ui
