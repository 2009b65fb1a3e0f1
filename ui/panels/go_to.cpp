// Ctrl+G: two numbers; Enter holds the pixel there. It goes when its field is left.
#include <array>
#include <fmt/format.h>

#include "renderer/base/size_text.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

constexpr const char* kField = "pixel.go-to";

struct GoToState : PanelState {
  std::array<char, 32> text{};  // "x, y"
};

void open_go_to(FrameContext& f, const KeyEvent&) {
  GoToState& s = f.state.of<GoToState>();
  s.open = true;
  f.state.type_into(kField);
  const glm::ivec2 pixel = f.held_pixel().value_or(f.frame_size() / 2);
  s.text = {};
  fmt::format_to_n(s.text.begin(), s.text.size() - 1, "{}, {}", pixel.x, pixel.y);
}

Box go_to_box(const FrameContext& f) {
  const float px = f.type.body, width = px * 20;
  const Box& main = f.layout.main_box();
  const ImVec2 min{std::floor(main.min.x + (main.width() - width) / 2), std::floor(main.min.y + main.height() * 0.4f)};
  return {min, {min.x + width, min.y + std::round(5 * line_height(px))}};
}

void draw_go_to(FrameContext& f, Painter& p, const Box& box) {
  GoToState& s = f.state.of<GoToState>();
  const float px = f.type.body, line = line_height(px);
  const Box room = box.inset(std::round(px * 0.6f));
  p.text_in({room.min, {room.max.x, room.min.y + line}}, px, theme().text, "Hold the pixel at x, y");
  const float top = room.min.y + std::round(1.3f * line);
  const Box field{{room.min.x, top}, {room.max.x, top + std::round(1.6f * line)}};
  if (draw_text_field(f, kField, field, px, s.text.data(), s.text.size())) {
    if (const std::optional<glm::ivec2> pixel = pixel_of(s.text.data()))
      f.hold(*pixel);
    else
      f.state.notice = fmt::format("'{}' is not a pixel; write two whole numbers, x, y", s.text.data());
  }
  const glm::ivec2 last = f.frame_size() - 1;
  p.text_in({{room.min.x, room.max.y - line_height(f.type.small)}, room.max}, f.type.small, theme().dim,
            fmt::format("0 … {}, 0 … {} from the top left; Enter", last.x, last.y));
}

void close_when_left(FrameContext& f) {
  if (f.state.field != kField) f.state.of<GoToState>().open = false;
}

}  // namespace

extern const Panel kGoToPanel = {.key = "Ctrl+G",
                                 .id = "pixel.go-to",
                                 .help = "hold the pixel at a typed x, y",
                                 .place = Place::over,
                                 .box = go_to_box,
                                 .draw = draw_go_to,
                                 .make = make_panel_state<GoToState>,
                                 .press = open_go_to,
                                 .update = close_when_left};

}  // namespace gbl::ui
