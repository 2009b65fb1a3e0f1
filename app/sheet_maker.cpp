#include "app/sheet_maker.h"

#include "app/imgui_screen.h"

namespace gbl {

ui::ViewImage SheetMaker::keep(Canvas canvas) {
  kept_.push_back(std::move(canvas));
  return {kept_.back().texture.id(), kept_.back().texture.size};
}

ui::SheetTile& SheetMaker::add(const Lab& lab, View v, bool overlaid, bool squares) {
  const ui::ViewImage image = keep(lab.copy_of(v, squares));
  sheet_.tiles.push_back(ui::sheet_tile(v, image, lab.report().drawn, ui_input(lab), overlaid));
  return sheet_.tiles.back();
}

ui::SheetTile& SheetMaker::add(const Lab& lab, View v, Canvas picture) {
  const ui::ViewImage image = keep(std::move(picture));
  sheet_.tiles.push_back(ui::sheet_tile(v, image, lab.report().drawn, ui_input(lab), false));
  return sheet_.tiles.back();
}

Image SheetMaker::picture() const {
  ImguiScreen screen;
  return screen.picture(ui::sheet_size(sheet_), [this] { ui::draw_sheet(sheet_); });
}

}  // namespace gbl
