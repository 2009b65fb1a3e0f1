#include "app/window_picture.h"

#include <string_view>

#include "app/imgui_screen.h"

namespace gbl {

Image first_screen(Lab& lab, Settings s, glm::ivec2 window, bool times) {
  ui::Ui ui(s, false);
  ImguiScreen screen;
  lab.draw(s);
  lab.count_pairs(true);
  for (const ViewRow& v : views())
    if (std::string_view(v.key).size() == 1) lab.draw_measured_view(v.view, {.overlays = lab.is_main(v.view)});
  lab.collect(true);
  FrameReport report = lab.report();
  if (!times)
    for (PassTime& p : report.passes) p.ms.reset();
  const ui::Input input = ui_input(lab, report);
  return screen.picture(window, [&] { ui.draw(s, input, {}); });
}

}  // namespace gbl
