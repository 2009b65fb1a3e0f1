#pragma once
// Legends: what a view's colours mean. Drawn by panels and sheets alike.
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

struct LegendEntry {
  std::string label;
  glm::vec3 colour;  // display-coded
};
struct Legend {
  bool bar = false;  // a continuous bar between entries at equal steps, else swatches
  std::vector<LegendEntry> entries;
  std::vector<LegendEntry> apart;  // swatches beside a bar: values that are not on its scale, e.g. the sky
};

// What the rows of views.inc name.
Legend normal_legend(const Settings&, const Bounds&);
Legend depth_legend(const Settings&, const Bounds&);
Legend material_legend(const Settings&, const Bounds&);
Legend count_legend(const Settings&, const Bounds&);
Legend wasted_legend(const Settings&, const Bounds&);
Legend position_legend(const Settings&, const Bounds&);

// The world-unit interval that the depth view spans: 0 to the farthest corner of the scene, at most far.
glm::dvec2 depth_view_range(const Camera&, const Bounds&);

// The smallest number >= x > 0 whose quarters are round too: a bar has labels at 0, 1/4, 1/2, 3/4 and 1.
double round_for_bar(double x);

// World units in which the position view's colours repeat: a power of ten, some 10 to 100 of them over the scene.
double position_cycle(const Bounds&);

// Where no surface is: dark blue, as users asked, where surfaces are described; black where light is summed.
inline constexpr glm::vec3 kSkyColour{0.09f, 0.13f, 0.30f};
inline constexpr glm::vec3 kNoLight{0.0f};

inline constexpr int kLightCountColours = 6;  // 0, 1, 2, 3, 4, 5+
// From which number of wasted pairs on each of these colours is used: what is wasted is a multiple of what is lit.
inline constexpr int kWastedFrom[kLightCountColours] = {0, 1, 3, 6, 11, 21};
extern const glm::vec3 kLightCountPalette[kLightCountColours];

}  // namespace gbl
