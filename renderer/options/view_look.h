#pragma once
// How one view's numbers become colours where it is not as the view does by itself.
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/picture/colour_map.h"

namespace gbl {

struct ViewLook {
  bool fit = false;                 // black and white at the ends of what is seen
  std::optional<glm::dvec2> range;  // black and white, in the view's unit; not with `fit`
  std::string channels = "rgb";     // those that are shown, at least one; one alone is shown as a single number
  ColourMap map = ColourMap::own;   // of a single number
  std::optional<bool> coded;        // with the display's sRGB curve, or without
  bool raw = false;                 // the stored codes, undecoded: nothing else is said then
  bool operator==(const ViewLook&) const = default;
  bool plain() const { return *this == ViewLook{}; }
};

struct LookOf {
  std::string view;  // its id
  ViewLook look;
  bool operator==(const LookOf&) const = default;
};
using Looks = std::vector<LookOf>;  // by id, each view once, none plain

ViewLook look_of(const Looks&, std::string_view view);  // plain where nothing is said
void set_look(Looks&, std::string_view view, ViewLook);

// "depth:400..600:viridis", "normal:r", "albedo:0..0.1:linear", "final:fit". Error(bad_input) beginning with `where`;
// the view's id is not looked up here.
std::string text_of(const LookOf&);
LookOf parse_look(std::string_view text, std::string_view where);

}  // namespace gbl
