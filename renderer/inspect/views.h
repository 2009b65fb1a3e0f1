#pragma once
// The views: every picture that can be looked at, one row each. Panels, number keys, files and `H` cards follow.
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/frame/attachments.h"
#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

enum class View {
  final,
  albedo,
  normal,
  depth,
  material,
  diffuse_light,
  specular_light,
  lights_per_pixel,
  position,
  lit,
  wasted_pairs,
  reference,
  error
};
inline constexpr int kViewCount = 13;

// Does the view need the reference, which takes a second or more and is made only while somebody looks?
inline bool needs_truth(View v) { return v == View::reference || v == View::error; }

// Does the view show a count of pairs, which is made only while somebody looks?
inline bool counted(View v) { return v == View::lights_per_pixel || v == View::wasted_pairs; }

struct ViewRow {
  View view;
  const char* id;   // singular; also the file's name
  const char* key;  // number key, "" = none
  const char* label;
  const char* sentence;  // one line for the strip below the panels
  Pass written_by;       // colours the frame
  // The `H` card:
  const char* space;  // axes or colour space
  const char* unit;
  const char* range;
  const char* read_by;     // which passes read it
  const char* decode;      // formula from stored to shown
  const char* in_sources;  // what the five tutorials call it
  const char* mistake;     // the usual one
  const char* needs = "";  // pitfall-free name of what must be stored; "" = always there
};

std::span<const ViewRow> views();
const ViewRow& row(View);
const ViewRow& view_by_id(std::string_view id);  // Error with the known ones

// Empty if the view can be shown under these settings, else the reason why not.
std::string why_missing(View, const Settings&);

// The attachments that a view reads, by name with format: "gbuffer.normal RG16UI 4 B".
std::string stored_as(View, const Settings&);

// The world-unit interval that the depth view spans: 0 to the farthest corner of the scene, at most far.
glm::dvec2 depth_view_range(const Camera&, const Bounds&);

// The smallest number >= x > 0 whose quarters are round too: a bar has labels at 0, 1/4, 1/2, 3/4 and 1.
double round_for_bar(double x);

// World units in which the position view's colours repeat: a power of ten, some 10 to 100 of them over the scene.
double position_cycle(const Bounds&);

// A legend: what the colours mean. Drawn by panels and sheets alike.
struct LegendEntry {
  std::string label;
  glm::vec3 colour;  // display-coded
};
struct Legend {
  bool bar = false;  // a continuous bar between entries at equal steps, else swatches
  std::vector<LegendEntry> entries;
  std::vector<LegendEntry> apart;  // swatches beside a bar: values that are not on its scale, e.g. the sky
};
Legend legend(View, const Settings&, const Bounds&);

inline constexpr glm::vec3 kSkyColour{0.09f, 0.13f,
                                      0.30f};  // of depth, normal, …: no surface (dark blue, as users asked)
inline constexpr int kLightCountColours = 6;   // 0, 1, 2, 3, 4, 5+
// From which number of wasted pairs on each of these colours is used: what is wasted is a multiple of what is lit.
inline constexpr int kWastedFrom[kLightCountColours] = {0, 1, 3, 6, 11, 21};
extern const glm::vec3 kLightCountPalette[kLightCountColours];

}  // namespace gbl
