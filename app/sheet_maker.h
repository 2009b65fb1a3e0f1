#pragma once
// Collects pictures of one or many frames into a sheet, and draws it off screen.
#include <vector>

#include "app/lab.h"
#include "ui/sheet.h"

namespace gbl {

class SheetMaker {
 public:
  // The view as the lab has it now, kept: the next frame does not change it. squares: where it is enlarged, pixels are seen
  ui::SheetTile& add(const Lab&, View, bool overlaid, bool squares = false);
  ui::SheetTile& add(const Lab&, View, Canvas picture);  // another picture in the view's colours
  ui::ViewImage keep(Canvas);                            // one more picture of a tile
  ui::Sheet& sheet() { return sheet_; }

  Image picture() const;  // needs a current context

 private:
  std::vector<Canvas> kept_;
  ui::Sheet sheet_;
};

}  // namespace gbl
