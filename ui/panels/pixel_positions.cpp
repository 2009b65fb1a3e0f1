// The page of positions: depth with all of its digits, and what the lighting would read by each way to store a position.
#include <algorithm>
#include <fmt/format.h>

#include "ui/panels/pixel_parts.h"

namespace gbl::ui {
namespace {

void draw_depth(Painter& p, Shelf& shelf, float px, const DepthAccount& d) {
  heading(p, shelf, px, "depth, with all of its digits");
  Table table(p, shelf, px, {0.3f, 0.7f});
  const auto line = [&](const char* what, const std::string& text) {
    table.row({{what, theme().text}, {text, theme().text}});
  };
  line("stored code", code_text(d));
  line("window depth", fmt::format("{:.9g}", d.window));
  line("distance", fmt::format("{:.9g} units along the view", d.distance));
  line("true distance", fmt::format("{:.9g}: {:.3g} off", d.truth, std::abs(d.distance - d.truth)));
  line("the next code", fmt::format("lies {:.3g} units farther", d.step));
}

}  // namespace

void draw_positions(Painter& p, Shelf& shelf, float px, const PixelAccount& a) {
  if (!a.surface) {
    p.text_in(shelf.below(line_height(px)), px, theme().text, "the background has no position");
    return;
  }
  draw_depth(p, shelf, px, a.depth);
  shelf.below(px * 0.4f);
  heading(p, shelf, px, "position, as the lighting would read it by each way to store it");
  if (a.routes.empty()) {
    p.text_in(shelf.below(line_height(px)), px, theme().text, "forward shading reads no stored position");
    return;
  }
  Table table(p, shelf, px, {0.27f, 0.37f, 0.13f, 0.23f});
  table.row({{"position.source, reconstruct", theme().dim},
             {"x y z, world units", theme().dim},
             {"error", theme().dim},
             {"", theme().dim}});
  const auto three = [](const glm::dvec3& v) { return numbers({v.x, v.y, v.z}, 9); };
  table.row(
      {{"the truth", theme().accent}, {three(a.true_position), theme().accent}, {"", theme().dim}, {"", theme().dim}});
  for (const PositionRoute& r : a.routes) {
    const std::string_view pitfall = pitfall_of(r);
    const std::string note = pitfall.empty() ? "" : fmt::format("{} {}", kUnsoundSign, pitfall);
    table.row({{name_of(r), r.used ? theme().accent : theme().text},
               {three(r.position), r.used ? theme().accent : theme().text},
               {fmt::format("{:.3g}", r.error), r.used ? theme().accent : theme().text},
               {r.used && note.empty() ? "drawn" : note, pitfall.empty() ? theme().dim : theme().unsound}});
  }
}

}  // namespace gbl::ui
