#pragma once
// A figure as data: what is in it, and the words that go with it. assets/figures/*.json are sets of figures:
//   {"version": 1, "title": "…", "figures": [{"id": "lost-light", "title": "…", "caption": "…", "alt": "…", "source": "…",
//    "size": [640, 360], "columns": 2, "preset": "start", "scene": "builtin:room", "camera": "x,y,z:yaw,pitch:fov",
//    "set": {"lights.cull": "back"}, "panels": [{"view": "final", "words": "…", "set": {…}, "numbers": true,
//    "inset": {"scale": 8, "centre": [0.3, 0.4], "corner": "top right"},
//    "against": {"set": {…}, "from": 0.5, "left": "…", "right": "…"}, "outside": "x,y,z:yaw,pitch:fov"}]}]}
// A panel's own preset, scene and camera stand in the place of the figure's; its "set" comes after the figure's. Zoom, looks and
// overlays are options (view.zoom, view.looks, view.overlays). Instead of an array, "panels" may be "stored": every view
// that has a key and is stored. Instead of panels, "drawing": one of figure_drawings(), or "window": [1600, 900], the first screen.
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/json_fwd.h"
#include "renderer/options/options.h"

namespace gbl {

// How settings are made: preset < scene < camera < set, as on the command line. Empty: not given.
struct FigureRecipe {
  std::string preset, scene, camera;
  std::vector<Assignment> set;
};

struct FigureInset {
  double scale = 4;             // of what the whole picture shows
  glm::dvec2 centre{0.5, 0.5};  // 0..1 across the picture, from the top left
  bool right = true, top = true;
};

// The same view under other settings, to the right of a line.
struct FigureAgainst {
  std::vector<Assignment> set;  // after the panel's
  double from = 0.5;            // where the line stands, 0..1
  std::string left, right;      // names of both sides
};

struct FigurePanel {
  std::string view;   // id
  std::string words;  // below the picture; empty: none
  FigureRecipe recipe;
  bool numbers = false;  // on the pixels, where they are enlarged enough
  std::optional<FigureInset> inset;
  std::optional<FigureAgainst> against;
  std::string outside;  // the camera that looks at the frame from outside; empty: the frame itself
};

// Pictures over a span of time or along a path, evenly from key to key. Each key sets the same paths, after every panel's own:
//   "frames": {"count": 24, "per-second": 12, "keys": [{"time_s": 0}, {"time_s": 4}]}
//   "frames": {"keys": [{"camera": "0,1.6,0:0,0:45"}, {"camera": "0,1.6,-4:20,0:45"}]}
struct FigureFrames {
  int count = 2;  // at least 2, at most 1000
  double per_second = 12;
  std::vector<std::vector<Assignment>> keys;  // at least 2
};

struct FigureSpec {
  std::string id;                           // names the files: a-z 0-9 - _
  std::string title, caption, alt, source;  // alt and source may be empty
  glm::ivec2 size{480, 270};                // of each panel's frame, at scale 1
  int columns = 2;
  bool letters = true;               // (a) (b) (c) before the words, where there are several panels
  bool heading = false;              // the title and the settings in words are part of the picture
  std::vector<FigurePanel> panels;   // or else a drawing
  std::optional<glm::ivec2> window;  // or else the first screen in a window of this size
  std::string drawing;               // id in figure_drawings()
  FigureRecipe recipe;               // of the figure itself: of a drawing
  std::optional<FigureFrames> frames;
  std::string json;  // as read: makes this figure again
};

struct FigureSet {
  std::string where;  // the file, for messages
  std::string name;   // as it is asked for
  std::string title;
  std::vector<FigureSpec> figures;
};

// One figure alone. Error(bad_input) says place, member, what is wrong and how to fix it; views, options and values have been looked up.
FigureSpec parse_figure(const Json&, std::string_view where);
FigureSet parse_figures(std::string_view text, std::string_view name, std::string_view where);
// A built-in set by its name, or else a file: a set, one figure, or a picture that was made of one. known: for the refusal of a name
FigureSet load_figures(const std::string& name_or_file, const std::vector<std::string>& known);

struct BuiltinFigures {
  std::string id, title;
};
std::vector<BuiltinFigures> builtin_figures();  // sorted

// Opens the scene if one is named. size: of the frame
Settings settings_of(const FigureRecipe&, glm::ivec2 size, std::string_view where);

// At this share (0..1) of the way through all keys. Numbers go evenly, an orientation turns; what is neither holds until the next
// key.
std::vector<Assignment> patch_at(const FigureFrames&, double share);

}  // namespace gbl
