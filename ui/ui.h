#pragma once
// The user interface: edits a Settings value and reads plain results. Never a gl* call, never GLFW: pictures are
// opaque texture handles, and whatever needs the outside world is a request that the app carries out.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/frame/frame_report.h"
#include "renderer/inspect/views.h"
#include "renderer/lessons/lessons.h"
#include "renderer/light/lights.h"
#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"
#include "renderer/study/advice/advisor.h"
#include "renderer/study/rows/study_row.h"
#include "renderer/study/stability/stability.h"
#include "renderer/study/study_spec.h"
#include "renderer/truth/error_stats.h"

namespace gbl::ui {

// One pixel's values, decoded by the same shader text as the lighting's. Pixels: integers, origin top left.
struct PixelProbe {
  glm::ivec2 pixel{0};
  bool surface = false;  // false: background, the rest means nothing
  glm::vec3 albedo{0};   // linear
  float roughness = 0;
  glm::vec3 normal{0};    // world, unit
  glm::vec3 position{0};  // world
  float range = 0;        // distance along the view axis, world units
  glm::vec3 diffuse_light{0}, specular_light{0}, lit{0};
  float lights = 0;         // lights in range that the method shaded here
  int object = 0;           // number of the object that is seen, from 1; transparent ones included
  std::string object_name;  // as the scene names it
};

struct ViewImage {
  uint64_t texture = 0;  // ImTextureID; 0 = not drawn this frame
  glm::ivec2 size{0};    // row 0 of the texture is the picture's bottom row (GL): draw with v flipped
};

// What the chart shows: rows of a study in the scene and with the truth at hand, and set-ups that were tried by hand.
struct ChartInput {
  struct Study {
    std::string id, label;
    std::string x, y, family;  // of its chart, unless another is asked for
  };
  std::vector<Study> studies;      // that can run here
  std::vector<StudyRow> rows;      // as renderer/study/study.h makes them, failed ones among them
  std::vector<Settings> settings;  // of each row, as asked for
  std::optional<size_t> current;   // the row of the settings at hand; empty: not measured yet
  bool measuring = false;          // the settings at hand are being measured
  glm::ivec2 size{0};              // at which rows are measured

  std::string running;                 // a study's id; empty: none runs
  size_t done = 0, total = 0;          // of the one that runs, or else of the one that is shown
  std::optional<double> seconds_left;  // empty: nobody knows yet
  std::string note;                    // why a study stopped or left cases out; empty = nothing to say
};

// What the stability panel shows of the sweep that it asked for.
struct StabilityInput {
  const SweepResult* result = nullptr;           // its points so far; null: not begun
  std::vector<std::vector<std::string>> stated;  // of each curve, judged or not yet
  size_t done = 0, total = 0;                    // points
  bool running = false;
  std::optional<double> seconds_left;  // empty: nobody knows yet
  std::string note;                    // why it stopped, or what it leaves out; empty = nothing to say
};

// What the advisor panel shows: the answer found last, and how far the one asked for now has come.
struct AdvisorInput {
  std::optional<Advice> advice;  // the last complete one in this scene
  ErrorBudget budget;            // that it was asked for
  AdviceCost cost = AdviceCost::bytes;
  bool running = false;
  size_t tried = 0;      // set-ups and values so far, of the one that runs
  std::string progress;  // what it tries
  std::string note;      // why it stopped, or why its answer is an old one; empty = nothing to say
  glm::ivec2 size{0};    // at which set-ups are measured
};

// What the UI reads this frame.
struct Input {
  const Scene& scene;
  const std::vector<Light>& lights;  // of these settings
  FeatureSet features;
  const FrameReport& report;                 // of the last frame that was drawn
  std::array<ViewImage, kViewCount> images;  // by View
  std::optional<PixelProbe> probe;           // of the pixel asked for
  std::optional<ErrorStats> error;           // of the error view; empty: not drawn yet
  double truth_progress = 1;                 // of the reference that is being made; 1: none is
  const ChartInput* chart = nullptr;         // these three null: nothing is ever measured here
  const StabilityInput* stability = nullptr;
  const AdvisorInput* advisor = nullptr;
  std::string message;            // an error or a notice to show until the next key; empty = none
  std::string banner;             // e.g. "predicted 8.3 s a frame: drawn at 400x225"; empty = none
  double seconds = 0;             // a clock for motion, not part of any picture
  std::vector<std::string> held;  // keys that are down now, named as in KeyEvent; "Shift" and "Ctrl" among them
};

// A key as the user knows it: the character printed on it ("c", "[", "+", ","), or a name: "Home" "End" "PgUp" "PgDn"
// "Enter" "Esc" "Tab" "Space" "Left" "Right" "Up" "Down" "F1"…"F12". Letters are lower case, Shift apart.
struct KeyEvent {
  std::string key;
  bool shift = false, ctrl = false, repeat = false;
};

// Carried out by the app after the frame.
struct Requests {
  bool reload_shaders = false;
  bool save_figure = false;  // the window's picture, as seen
  bool quit = false;
  std::optional<glm::ivec2> probe;         // pixel under the cursor
  std::array<bool, kViewCount> visible{};  // views that the next frame must draw
  glm::ivec2 picture_size{0};              // of the largest picture on screen, in screen pixels
  std::optional<double> wake_in;           // seconds until the window changes by itself (a caption ends)
  struct Chart {
    bool open = false;               // the settings at hand are to be measured
    std::string study;               // whose rows are to be shown; empty = not chosen yet
    bool run = false, stop = false;  // that study; any that runs
  } chart;
  struct Stability {
    bool open = false;  // closed: nothing of it runs
    std::string sweep;  // that is shown
    bool run = false, stop = false;
  } stability;
  struct Advisor {
    bool open = false;  // closed: nothing of it runs
    ErrorBudget budget;
    AdviceCost cost = AdviceCost::bytes;
    bool run = false, stop = false;
  } advisor;
};

// Window state that is no part of a picture's settings.
struct State;

class Ui {
 public:
  explicit Ui(Settings initial,
              bool present);  // initial = the state as loaded: Home returns to it. present = large type
  ~Ui();

  // Load fonts into the current ImGui context and set its style; once, before the first frame.
  void set_up_style();

  // One frame inside ImGui::NewFrame() … Render(), filling the display. Keys are those since the last frame.
  Requests draw(Settings&, const Input&, const std::vector<KeyEvent>& keys);

  void open_lesson(std::string_view id, Settings&);  // Error with the known ones
  bool moving(const Settings&) const;                // time runs, a glide is under way or a camera key is held

  // Texts that did not fit their place in the last frame at any legible size. Tests demand none.
  const std::vector<std::string>& cut_texts() const;

 private:
  std::unique_ptr<State> state_;
};

// ---- pictures without a window ---------------------------------------------------------------------------
// The same panels in a captioned contact sheet, for ImGui frames drawn off screen.
struct SheetTile {
  View view;
  ViewImage image;
  std::string caption;  // below the picture; may be empty
};
struct Sheet {
  std::string title;    // first line
  std::string caption;  // settings in words, below the title
  std::vector<SheetTile> tiles;
  int columns = 3;
  float tile_width = 480;  // pixels
};
glm::ivec2 sheet_size(const Sheet&, const Settings&);  // pixels that draw_sheet needs
void draw_sheet(const Sheet&, const Settings&, const Input&);

// The first screen's mosaic without the window's controls being usable: what `start.png` shows.
// (Ui::draw with no keys gives it.)

// ---- keys ------------------------------------------------------------------------------------------------
struct KeyRow {
  std::string key;  // as printed: "C", "[ ]", "Shift ,"
  std::string id;   // "lights.cull" or the command's id
  std::string help;
};
std::vector<KeyRow> key_rows();  // axes' keys from the options table, then commands; for F1 and `list keys`

}  // namespace gbl::ui
