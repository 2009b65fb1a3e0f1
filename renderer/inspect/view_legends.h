#pragma once
// Legends: what a view's colours mean. Drawn by panels and sheets alike.
#include <array>
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

struct ViewStats;

struct ViewLook;

// What a legend is of.
struct LegendOf {
  const Settings& settings;
  const Bounds& bounds;
  glm::dvec2 range;        // black and white
  const ViewStats* stats;  // of what is seen; null: not known yet
};

// What the rows of views.inc name.
Legend normal_legend(const LegendOf&);
Legend depth_legend(const LegendOf&);
Legend fitted_legend(const LegendOf&);  // black to white, numbered
Legend material_legend(const LegendOf&);
Legend count_legend(const LegendOf&);
Legend position_legend(const LegendOf&);
// Of a view that has a look.
Legend look_legend(const LegendOf&, const ViewLook&, bool single_number);

// What the depth view spans before it is known what is seen: 0 to the farthest corner of the scene, at most far.
glm::dvec2 depth_view_range(const Camera&, const Bounds&);

// The smallest number >= x > 0 whose quarters are round too: a bar has labels at 0, 1/4, 1/2, 3/4 and 1.
double round_for_bar(double x);

// World units in which the position view's colours repeat: a power of ten, some 10 to 100 of them over the scene.
double position_cycle(const Bounds&);

// Where no surface is: dark blue, as users asked, where surfaces are described; black where light is summed.
inline constexpr glm::vec3 kSkyColour{0.09f, 0.13f, 0.30f};
inline constexpr glm::vec3 kNoLight{0.0f};

inline constexpr int kLightCountColours = 6;
// From which count on each colour stands: 0 1 2 3 4 5, and where the picture's largest count is 10 or more further apart,
// so that the last begins at the round number (1, 2 or 5 times a power of ten) below it.
using CountSteps = std::array<int, kLightCountColours>;
CountSteps count_steps(const ViewStats*);
extern const glm::vec3 kLightCountPalette[kLightCountColours];

}  // namespace gbl
