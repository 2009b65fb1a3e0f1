#pragma once
// Options whose values are ids out of a table, though they are kept as text: scenes, views, mistakes. They are chosen from a
// list, never typed.
#include <string>
#include <vector>

#include "ui/state.h"

namespace gbl::ui {

struct ClosedItem {
  std::string id;
  const char* label;
  const char* help;
};
// Empty: the option is no closed set.
std::vector<ClosedItem> closed_items(const Option&);

// Chosen; in a set on or off, and the others stay as they are, with what stands behind their colon.
void toggle_closed(FrameContext&, const Option&, const std::string& id);
// The next one alone, of those that may stand together; none comes before the first.
void step_closed(FrameContext&, const Option&, int step);
void draw_closed(FrameContext&, const Option&, const Box&, float px);

}  // namespace gbl::ui
