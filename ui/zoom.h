#pragma once
// Which part of a picture a panel shows. Places are shares, 0..1 from the top left: across the picture, or across the
// panel that shows a part of it.
#include <glm/glm.hpp>

namespace gbl::ui {

struct Zoom {
  double scale = 1;             // 1: the whole picture
  glm::dvec2 centre{0.5, 0.5};  // across the picture
  bool operator==(const Zoom&) const = default;
  bool whole() const { return scale <= 1; }
  glm::dvec2 first() const { return centre - 0.5 / scale; }  // the panel's top left, across the picture
};

Zoom within(Zoom, double most);  // nothing outside the picture is shown, and the scale is 1..most
glm::dvec2 on_picture(const Zoom&, glm::dvec2 in_panel);
glm::dvec2 in_panel(const Zoom&, glm::dvec2 on_picture);
Zoom zoomed_at(const Zoom&, double factor, glm::dvec2 in_panel, double most);  // what is there stays there
Zoom panned(const Zoom&, glm::dvec2 by);  // the picture moves by so much of the panel

}  // namespace gbl::ui
