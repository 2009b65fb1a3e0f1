#pragma once
// Views that are laid over the one that is looked at, each as strongly as it is wanted.
#include <string>
#include <string_view>
#include <vector>

namespace gbl {

inline constexpr double kOverlayOpacity = 0.7;  // where nothing is said

struct Overlay {
  std::string view;                  // its id
  double opacity = kOverlayOpacity;  // 0..1
  bool operator==(const Overlay&) const = default;
};
using Overlays = std::vector<Overlay>;  // from the lowest to the topmost, each view once

const Overlay* find_overlay(const Overlays&, std::string_view view);  // null: it is not laid over anything
void set_overlay(Overlays&, std::string_view view, double opacity);   // 0 takes it away; a new one lies on top

// "wire", "back-faces:0.4". Error(bad_input) beginning with `where`; the view's id is not looked up here.
std::string text_of(const Overlay&);
Overlay parse_overlay(std::string_view text, std::string_view where);

}  // namespace gbl
