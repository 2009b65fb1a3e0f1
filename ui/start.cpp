#include "ui/state.h"

namespace gbl::ui {

void draw_start(const std::string& line) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  std::vector<std::string> cut;
  Painter p(*ImGui::GetBackgroundDrawList(), cut);
  const Type type = type_for(std::min(display.x / 1600, display.y / 900));
  const Box all{{0, 0}, display}, room = all.inset(std::floor(display.x / 16));
  p.fill(all, theme().background);
  draw_paragraphs(p, {{room.min.x, display.y * 0.4f}, room.max},
                  {{"G-Buffer Lab", theme().accent, type.large * 2}, {line, theme().text, type.large}}, type.body);
}

}  // namespace gbl::ui
