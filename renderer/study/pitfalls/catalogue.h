#pragma once
// The pitfalls as data: assets/pitfalls/<id>.json, one file each.
//   {"version": 1, "group": "volumes", "order": 1, "lecture": 3, "title": "…", "source": "…", "symptom": "…",
//    "cause": "…", "question": "…", "do": "…", "dont": "…", "impact": "…", "see": "…", "still": "…",
//    "preset": "start", "set": {…}, "broken": {…}, "fixed": {…}, "truth": {…}, "view": "final",
//    "metric": "lost_share", "broken_at_least": 0.9, "fixed_at_most": 0,
//    "toward_zero": {"broken_at_least": …, "fixed_at_most": …},
//    "blind": {"set": {…}, "at_most": 0, "why": "…"}, "path": {"from": {…}, "to": {…}}}
// Settings are the preset's, then "set", then "broken" or "fixed". "truth" is added to what "broken" is judged by:
// the model that is meant, where the failure is one of the model. "blind" is "broken" in a configuration that hides it.
// "path": two cameras between which it comes and goes.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/options/options.h"

namespace gbl {

struct PitfallBounds {  // of the metric: the more the worse
  double broken_at_least = 0, fixed_at_most = 0;
};

struct PitfallBlindSpot {
  std::vector<Assignment> set;  // over the broken settings
  double at_most = 0;           // of the metric: it does not show
  std::string why;
};

struct PitfallPath {
  std::vector<Assignment> from, to;  // of the camera, over the settings of either side
};

struct PitfallEntry {
  std::string id;     // file name without ending
  std::string group;  // of pitfall_groups()
  int order = 0;      // in its group
  int lecture = 0;    // place in the set for a lecture; 0: not in it
  std::string title, source, symptom, cause, question;
  std::string do_this, do_not, impact, see;
  std::string still;  // what the fix leaves
  std::string preset, view, metric;
  std::vector<Assignment> set, broken, fixed, truth;
  PitfallBounds bounds;
  std::optional<PitfallBounds> toward_zero;  // on a device that truncates what it stores in small floats
  std::optional<PitfallBlindSpot> blind;
  std::optional<PitfallPath> path;
};

struct PitfallGroup {
  const char* id;
  const char* label;
};
std::vector<PitfallGroup> pitfall_groups();

std::vector<PitfallEntry> load_pitfalls();       // by group and order; Error of the first file that cannot be read
PitfallEntry load_pitfall(std::string_view id);  // Error with the known ones
PitfallEntry parse_pitfall(std::string_view id, std::string_view json_text);

enum class PitfallSide { broken, fixed, blind };
Settings settings_of(const PitfallEntry&, PitfallSide);
Settings truth_of(const PitfallEntry&, PitfallSide);  // whose reference judges that side

// The camera on the entry's path, 0 … 1.
Camera camera_on_path(const PitfallEntry&, double t);

// Failures that are not in the catalogue, with the reason.
struct AbsentPitfall {
  const char* id;
  const char* why;
};
std::vector<AbsentPitfall> absent_pitfalls();

}  // namespace gbl
