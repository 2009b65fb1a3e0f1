// How large type is at the start: compared by all that is drawn with what + makes of it.
#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

using Corners = std::vector<std::pair<float, float>>;

Corners drawn(Desk& desk) {
  desk.seconds += 100;  // what + says is gone
  desk.frame(), desk.frame();
  Corners corners;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int i = 0; i < data.CmdListsCount; ++i)
    for (const ImDrawVert& v : data.CmdLists[i]->VtxBuffer) corners.emplace_back(v.pos.x, v.pos.y);
  return corners;
}

Corners started(float content_scale, ImVec2 display) {
  Desk desk(display);
  desk.ui.start_type(content_scale, {display.x, display.y});
  return drawn(desk);
}

Corners plain(ImVec2 display, int larger = 0) {
  Desk desk(display);
  for (int i = 0; i < larger; ++i) desk.press("+");
  return drawn(desk);
}

TEST(TypeSize, FollowsTheMonitorWhereTheWindowDoesNot) {
  const ImVec2 usual{1600, 900}, twice{3200, 1800};
  EXPECT_EQ(started(1, usual), plain(usual));
  EXPECT_EQ(started(0.5f, usual), plain(usual)) << "never smaller";
  EXPECT_EQ(started(1.1f, usual), plain(usual, 1));
  EXPECT_NE(started(1.1f, usual), plain(usual));
  EXPECT_EQ(started(2, twice), plain(twice)) << "the window is as much larger";
  EXPECT_EQ(started(5, usual), plain(usual, 20)) << "no larger than + goes";
}

}  // namespace
}  // namespace gbl::ui
