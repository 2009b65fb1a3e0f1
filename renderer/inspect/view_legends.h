#pragma once
// Legends: what a view's colours mean. Drawn by panels and sheets alike.
#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

struct LegendEntry {
  std::string label;
  glm::vec3 colour;  // display-coded
};
// A kind of pixel: 0 is what a view that marks leaves alone.
struct ViewClass {
  const char* label;
  glm::vec3 colour;
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
// Dark to light with each luminance at least 1.6 times the one before (plus 0.05, the projector's glare): the order
// survives colour blindness, a grey print and a bright room. The hues are there to be named aloud.
inline constexpr glm::vec3 kLightCountPalette[kLightCountColours] = {
    {0.04f, 0.04f, 0.06f}, {0.16f, 0.22f, 0.62f}, {0.05f, 0.46f, 0.55f},
    {0.30f, 0.68f, 0.25f}, {0.98f, 0.76f, 0.15f}, {1.00f, 1.00f, 1.00f},
};

// Okabe and Ito 2008, "Color Universal Design": told apart by those who see red and green alike.
inline constexpr glm::vec3 kMarkBlue{0.0f, 0.45f, 0.70f}, kMarkSky{0.34f, 0.71f, 0.91f}, kMarkGreen{0.0f, 0.62f, 0.45f},
    kMarkYellow{0.94f, 0.89f, 0.26f}, kMarkOrange{0.90f, 0.62f, 0.0f}, kMarkPink{0.80f, 0.47f, 0.65f};
inline constexpr int kMostClasses = 6;
inline constexpr ViewClass kFootprintClasses[] = {{"outside", kNoLight},
                                                  {"covered, out of range", kMarkYellow},
                                                  {"lit", kMarkGreen},
                                                  {"missed", kMarkPink},
                                                  {"too often", kMarkBlue}};
inline constexpr ViewClass kMiscountClasses[] = {
    {"as it should be", kNoLight}, {"missed", kMarkPink}, {"too often", kMarkBlue}};
inline constexpr ViewClass kTriangleClasses[] = {
    {"256+ px", kLightCountPalette[0]}, {"64+", kLightCountPalette[1]}, {"16+", kLightCountPalette[2]},
    {"4+", kLightCountPalette[3]},      {"1+", kLightCountPalette[4]},  {"below 1", kLightCountPalette[5]}};
inline constexpr ViewClass kShadowMapClasses[] = {{"1, +X", kMarkBlue}, {"2, -X", kMarkOrange}, {"3, +Y", kMarkGreen},
                                                  {"4, -Y", kMarkPink}, {"5, +Z", kMarkSky},    {"6, -Z", kMarkYellow}};
inline constexpr ViewClass kShadowTexelClasses[] = {
    {"below 1/4 px", kLightCountPalette[0]}, {"1/4+", kLightCountPalette[1]}, {"1+", kLightCountPalette[2]},
    {"2+", kLightCountPalette[3]},           {"4+", kLightCountPalette[4]},   {"16+", kLightCountPalette[5]}};
inline constexpr ViewClass kCheckClasses[] = {{"sound", kNoLight},
                                              {"above white", kMarkSky},
                                              {"normal off length 1", kMarkOrange},
                                              {"below 0", kMarkBlue},
                                              {"no number", {1.0f, 0.0f, 1.0f}}};
// The swatches of a view's classes.
Legend class_legend(std::span<const ViewClass>);

}  // namespace gbl
