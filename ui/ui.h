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
#include "renderer/inspect/pixel_probe.h"
#include "renderer/inspect/views.h"
#include "renderer/lessons/lessons.h"
#include "renderer/light/lights.h"
#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"
#include "renderer/truth/error_stats.h"
#include "renderer/truth/pixel_account.h"
#include "ui/advisor_io.h"
#include "ui/bookmarks.h"
#include "ui/chart_io.h"
#include "ui/compare_io.h"
#include "ui/outside_io.h"
#include "ui/path_io.h"
#include "ui/pitfall_io.h"
#include "ui/stability_io.h"

namespace gbl::ui {

struct PixelNumbers;

struct ViewImage {
  uint64_t texture = 0;  // ImTextureID; 0 = not drawn this frame
  glm::ivec2 size{0};    // row 0 of the texture is the picture's bottom row (GL): draw with v flipped
};

// B and its difference from A; without a texture where they are not there yet, or for a reason.
struct CompareInput {
  ViewImage b, difference;
  std::optional<ErrorStats> stats;  // of the difference, in the part that was asked for
  Legend legend;                    // of the difference
  std::string missing, note;        // why there is none; what is to be known of it
};

// What the UI reads this frame.
struct Input {
  const Scene& scene;
  const std::vector<Light>& lights;  // of these settings
  FeatureSet features;
  const FrameReport& report;                         // of the last frame that was drawn
  std::array<ViewImage, kViewCount> images;          // by View
  std::array<const ViewStats*, kViewCount> stats{};  // of what is seen, by View; null: not known
  std::optional<PixelProbe> probe;                   // of the pixel asked for
  const PixelAccount* account = nullptr;             // of the held pixel, once it is worked out
  const PixelNumbers* numbers = nullptr;             // those asked for, once they are there
  std::vector<ViewImage> locked;                     // in the order in which they were asked for
  ViewImage outside;                                 // as the outside camera's panel asked for it
  const CompareInput* compare = nullptr;             // null: nothing is compared
  std::optional<ErrorStats> error;                   // of the error view; empty: not drawn yet
  double truth_progress = 1;                         // of the reference that is being made; 1: none is
  const ChartInput* chart = nullptr;                 // these five null: nothing is ever measured here
  const StabilityInput* stability = nullptr;
  const AdvisorInput* advisor = nullptr;
  const PitfallInput* pitfall = nullptr;
  const PitfallPictures* pitfall_pictures = nullptr;
  const PathInput* path = nullptr;  // null: no file is ever opened here
  std::string message;              // an error or a notice to show until the next key; empty = none
  bool message_is_error = false;
  std::string banner;  // e.g. "predicted 8.3 s a frame: drawn at 400x225"; empty = none
  bool full_screen = false;
  bool still = false;             // nothing glides: whoever looks has asked the system for less motion
  double seconds = 0;             // a clock for motion, not part of any picture
  std::vector<std::string> held;  // keys that are down now, named as in KeyEvent; "Shift" and "Ctrl" among them
};

// A key as the user knows it: the character printed on it ("c", "[", "+", ","), or a name: "Home" "End" "PgUp" "PgDn"
// "Enter" "Esc" "Tab" "Space" "Left" "Right" "Up" "Down" "F1"…"F12". Letters are lower case, Shift apart.
struct KeyEvent {
  std::string key;
  bool shift = false, ctrl = false, repeat = false;
};

// The numbers of some pixels of a view; w > 0.5 where there are any.
struct PixelNumbers {
  View view;
  PixelGrid pixels;
  std::vector<glm::vec4> values;  // rows top to bottom
};

// A part of the window's picture as seen, with a caption below; without a size: all of the window, and no caption.
struct Figure {
  glm::ivec2 first{0}, size{0};      // screen pixels from the top left
  std::vector<std::string> caption;  // lines; the first is larger
  bool white = false;                // paper, else dark
};
int caption_height(const Figure&);  // pixels that draw_caption needs, in an ImGui frame
void draw_caption(const Figure&);   // over the whole display

// Carried out by the app after the frame.
struct Requests {
  bool reload_shaders = false;
  std::optional<Figure> figure;  // to be saved
  bool copy_command = false;     // the command line that draws this picture, onto the clipboard
  bool toggle_full_screen = false;
  bool quit = false;
  std::optional<glm::ivec2> probe;                    // pixel under the cursor
  std::optional<std::pair<View, PixelGrid>> numbers;  // to print on the pixels
  bool account = false;                               // why the probed pixel looks as it does
  std::vector<LookOf> locked;                         // views with looks of their own
  std::optional<OutsideRequest> outside;
  std::optional<CompareRequest> compare;   // with the main view
  bool magnified = false;                  // pixels are shown as squares
  std::array<bool, kViewCount> visible{};  // views that the next frame must draw
  glm::ivec2 picture_size{0};              // of the largest picture on screen, in screen pixels
  std::string in_words;                    // all that is shown, for who does not see it
  std::optional<double> wake_in;           // seconds until the window changes by itself (a caption ends)
  ChartRequest chart;
  StabilityRequest stability;
  AdvisorRequest advisor;
  PitfallRequest pitfall;
  PathRequest path;
};

// Window state that is no part of a picture's settings.
struct State;

class Ui {
 public:
  // initial = the state as loaded: Home returns to it. present = the picture alone, in large type
  explicit Ui(Settings initial, bool present);
  ~Ui();

  // Load fonts into the current ImGui context and set its style; once, before the first frame.
  static void set_up_style();

  // One frame inside ImGui::NewFrame() … Render(), filling the display. Keys are those since the last frame.
  Requests draw(Settings&, const Input&, const std::vector<KeyEvent>& keys);

  // Where a monitor says that things are to be drawn so much larger, type starts no smaller than that; + and - go on
  // from there. display: pixels
  void start_type(float content_scale, glm::vec2 display);

  // What is remembered from one run to the next.
  Snapshot snapshot(const Settings&) const;
  void show(const Snapshot&, Settings&);  // the size stays
  const Bookmarks& bookmarks() const;
  void set_bookmarks(const Bookmarks&);

  void compare_with(std::string file);                    // a picture becomes B
  void open_lesson(const std::string& place, Settings&);  // "NAME" or "NAME:3"; Error with the known ones
  std::string lesson_place() const;                       // of the one that is open; else empty
  void open_pitfall(std::string_view id, Settings&);      // the same
  bool moving(const Settings&) const;                     // time runs, a glide is under way or a camera key is held

  bool is_open(std::string_view panel) const;  // by its id
  // Texts that did not fit their place in the last frame at any legible size. Tests demand none.
  const std::vector<std::string>& cut_texts() const;

 private:
  std::unique_ptr<State> state_;
};

// The window before there is anything to show: what the program does meanwhile, over the whole display.
void draw_start(const std::string& line);

// ---- keys ------------------------------------------------------------------------------------------------
struct KeyRow {
  std::string key;  // as printed: "C", "[ ]", "Shift ,"
  std::string id;   // "lights.cull", or the command's or the panel's id
  std::string help;
  bool can_choose = true;  // by a click in the list; else it is held, or no key
};
// For F1 and `list keys`: the options' keys, the views', the commands' and the panels', F1 … F12 at the end.
std::vector<KeyRow> key_rows();
// The same for the mouse, with what it does in the place of the key.
std::vector<KeyRow> mouse_rows();

}  // namespace gbl::ui
