#pragma once
// The views: every picture that can be looked at. Panels, number keys, files and `H` cards follow. Rows: views.inc.
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "renderer/frame/attachments.h"
#include "renderer/inspect/view_legends.h"
#include "renderer/inspect/view_stats.h"
#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

enum class View {
#define VIEW(name, ...) name,
#include "renderer/inspect/views.inc"
#undef VIEW
};
inline constexpr int kViewCount = 0
#define VIEW(name, ...) +1
#include "renderer/inspect/views.inc"
#undef VIEW
    ;

// Where a view's values are kept: in an attachment of the frame, or where else.
struct ViewSource {
  std::optional<Attachment> attachment;
  std::string elsewhere;
};

// The numbers that a view is of, and how they become colours where nobody says otherwise.
struct ViewValues {
  int components = 3;
  const char* channels = "rgb";  // a letter each, as files name them; not of a single number
  double black = 0, white = 1;   // in the view's unit
  bool coded = false;            // with the display's sRGB curve
  bool fitted = false;           // black and white follow what is seen
  bool background = false;       // pixels without a surface have numbers, too
};

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
  // How it is made:
  bool counted = false;      // a count of pairs, made only while somebody looks
  bool against_lit = false;  // it compares them with the pairs that are lit, which is a loop over all lights
  bool picked = false;       // its counts are of the picked light alone
  bool numbered = false;     // it reads the objects' numbers, which are drawn apart while somebody looks
  bool redrawn = false;      // objects are drawn once more to be counted and measured while somebody looks
  bool marks = false;        // it marks pixels and leaves others alone: made to be laid over other views
  bool needs_truth = false;  // the reference, which takes a second or more and is made only while somebody looks
  std::span<const ViewClass> classes = {};  // by number, where a number stands for a kind of pixel
  ViewValues values = {};
  ViewSource (*stored_as)(const Settings&);
  std::string (*why_missing)(const Settings&) = nullptr;  // null: always there
  Legend (*legend)(const LegendOf&) = nullptr;            // null: its colours need none, or a panel of their own
  bool with_transparent = false;                          // what is drawn forward after the lighting, too
  glm::vec3 empty_colour = kSkyColour;                    // where no surface is
  const char* fragment = nullptr;                         // a shader of its own in the place of views.frag
};

std::span<const ViewRow> views();
const ViewRow& row(View);
const ViewRow& view_by_id(std::string_view id);  // Error with the known ones

bool needs_truth(View);
bool counted(View);

// Do its colours depend on what is seen? Then its statistics are worked out first (view_stats.h).
bool follows_picture(View, const Settings::View&);

// Is it shown as one number, along a colour map? Of several channels the first that is shown.
bool single_number(View, const ViewLook&);

// Black and white, in the view's unit: by its look, by what is seen, or its own.
glm::dvec2 shown_range(View, const Settings&, const Bounds&, const ViewStats*);

// Empty if the view can be shown under these settings, else the reason why not.
std::string why_missing(View, const Settings&);

// The attachment that a view reads; empty: it reads none of the frame.
std::optional<Attachment> attachment_of(View, const Settings&);
// It by name with format: "gbuffer.normal RG16UI 4 B", or where else the view comes from.
std::string stored_as(View, const Settings&);

Legend legend(View, const Settings&, const Bounds&, const ViewStats* = nullptr);

// Its file below shaders/.
std::string shader_of(View);

}  // namespace gbl
