#include "app/truth_drawing.h"

#include <fmt/format.h>
#include <thread>
#include <unistd.h>

namespace gbl {

void draw_against_truth(Lab& lab, View v) {
  const bool terminal = isatty(STDERR_FILENO);
  for (bool shown = false; !lab.draw_truth_view(v, false); shown = true) {
    std::this_thread::sleep_for(std::chrono::milliseconds(shown ? 100 : 10));
    if (terminal && shown) fmt::print(stderr, "\r\033[Kreference: {:.0f} %", 100 * lab.truth_progress());
  }
  if (terminal) fmt::print(stderr, "\r\033[K");
  if (v == View::error) lab.take_error_stats(true);
}

void draw_any_view(Lab& lab, View v, bool overlays) {
  if (needs_truth(v))
    draw_against_truth(lab, v);
  else
    lab.draw_measured_view(v, {.overlays = overlays});
}

}  // namespace gbl
