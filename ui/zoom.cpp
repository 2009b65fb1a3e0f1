#include "ui/zoom.h"

namespace gbl::ui {

Zoom within(Zoom z, double most) {
  z.scale = glm::clamp(z.scale, 1.0, glm::max(most, 1.0));
  const double edge = 0.5 / z.scale;
  z.centre = glm::clamp(z.centre, glm::dvec2(edge), glm::dvec2(1 - edge));
  return z;
}

glm::dvec2 on_picture(const Zoom& z, glm::dvec2 at) { return z.first() + at / z.scale; }
glm::dvec2 in_panel(const Zoom& z, glm::dvec2 at) { return (at - z.first()) * z.scale; }

Zoom zoomed_at(const Zoom& z, double factor, glm::dvec2 at, double most) {
  const glm::dvec2 fixed = on_picture(z, at);
  Zoom out = within({z.scale * factor, z.centre}, most);
  out.centre = fixed - (at - 0.5) / out.scale;
  return within(out, most);
}

Zoom panned(const Zoom& z, glm::dvec2 by) { return within({z.scale, z.centre - by / z.scale}, z.scale); }

}  // namespace gbl::ui
