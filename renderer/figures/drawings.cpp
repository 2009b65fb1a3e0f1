#include "renderer/figures/drawings.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/figures/drawing_parts.h"
#include "renderer/frame/packing_svg.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/opening/scene_look.h"

namespace gbl {
namespace {

std::string packing(const Settings& s, const std::string& title) {
  if (s.layout != Layout::auto_) return packing_svg(s, title);
  return packing_svg(resolve_frame(s, *open_scene(s.scene), {}).settings, title);
}

constexpr FigureDrawing kDrawings[] = {
    {"packing", "how a pixel is packed into the attachments of the layout", packing},
    {"falloff", "light over distance, the threshold, and where the range ends: solved and by the shortcut",
     draw_falloff},
    {"disc", "a disc through a light's middle against the outline of its sphere", draw_disc},
    {"light-from-side", "the picked light, its range, the camera and its planes, seen from the side",
     draw_light_from_side},
};

}  // namespace

std::span<const FigureDrawing> figure_drawings() { return kDrawings; }

const FigureDrawing& figure_drawing(std::string_view id) {
  std::vector<std::string_view> known;
  for (const FigureDrawing& d : kDrawings) {
    if (id == d.id) return d;
    known.emplace_back(d.id);
  }
  throw Error(ExitCode::bad_input, "drawing", fmt::format("unknown '{}'", id), suggest(id, known));
}

}  // namespace gbl
