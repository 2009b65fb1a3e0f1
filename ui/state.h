#pragma once
// What the window remembers between frames and no picture depends on, and what every panel is handed in a frame.
#include <array>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/options/options.h"
#include "ui/bookmarks.h"
#include "ui/captions.h"
#include "ui/compare.h"
#include "ui/history.h"
#include "ui/layout.h"
#include "ui/panel.h"
#include "ui/style.h"
#include "ui/ui.h"
#include "ui/zoom.h"

namespace gbl::ui {

inline constexpr double kCaptionSeconds = 6;
inline constexpr float kSmallestScale = 0.7f, kLargestScale = 2;  // of the type
inline constexpr double kGlideSeconds = 1.2;
inline constexpr const char* kRootWindow = "G-Buffer Lab";

struct Caption {
  Sentence sentence;
  double until = 0;
};

struct Glide {
  Camera from, to;
  double start = 0;
};

// A number to type in, as it was last shown.
struct NumberField {
  std::array<char, 32> text{};
  std::string shows;
};

struct LessonRun {
  Lesson lesson;
  size_t step = 0;
  bool revealed = false;
};

struct State {
  State(Settings loaded, bool presenting)
      : initial(std::move(loaded)), present(presenting), large(presenting || large_before) {}

  Settings initial;
  bool present;                                      // the picture and one caption, in large type
  bool large_before = initial.view.main != "final";  // presenting began
  bool large;                                        // the chosen view alone, else the mosaic
  size_t page = 0;                                   // of the mosaic
  float ui_scale = 1;
  bool hidden = false, playing = false;
  bool on_path = false;              // the camera goes along a pitfall's path
  bool reticle = false;              // a ring in the place of the mouse, on pictures
  std::optional<double> talk_began;  // seconds; empty: no timer

  std::vector<std::unique_ptr<PanelState>> panels = make_panel_states();  // of each row of the table
  // What a panel remembers, by its type.
  template <class T>
  T& of() const {
    for (const auto& p : panels)
      if (T* t = dynamic_cast<T*>(p.get())) return *t;
    std::abort();  // no row makes one
  }

  std::string field;         // has the keyboard, or will have it in the next frame; "" = none that a key has opened
  bool focus_field = false;  // in this frame
  bool entered = false;      // Enter, while something is typed or a field is about to have the keyboard
  std::string field_key;     // Tab, Up or Down, likewise
  void type_into(const char* id) { field = id, focus_field = true; }

  std::vector<KeyEvent> chosen;  // by a click in F1's list: pressed in the next frame

  History history;
  Comparison comparison;
  Bookmarks bookmarks;

  std::optional<LessonRun> lesson;
  std::optional<Caption> caption;
  std::string notice;     // an error to show until the next key
  std::string dismissed;  // the app's message that a key has answered

  std::optional<Glide> glide;
  std::optional<Camera> before_glide;  // the second I returns there
  bool show_distance = false;          // d/r of the picked light
  bool camera_key = false;             // one is held
  double last_seconds = -1;

  std::optional<View> hovered;              // of the frame before
  std::optional<glm::ivec2> hovered_pixel;  // of the frame before
  std::optional<glm::dvec2> held_at;        // 0..1 across the frame: a pixel held stays when the frame's size changes
  std::array<std::optional<Zoom>, kViewCount> own_zoom;  // of panels that are not linked to the others
  std::optional<size_t> carried;                         // the place of the panel whose title is being dragged
  std::optional<View> panning;                           // by the middle button
  bool saving_panel = false;                             // in this frame: without what is no part of the picture
  bool light = false;                                    // the theme
  std::optional<bool> white_figures;                     // empty: as the theme is
  bool figures_on_white() const { return white_figures.value_or(light); }
  bool histogram = false;                   // of the large view
  bool linear_counts = false;               // its bars: by the count, else by its logarithm
  std::array<NumberField, 2> range_fields;  // its black and white
  std::optional<glm::dvec2> held_before;    // the last click
  std::optional<View> focused;              // has the panel keys
  std::vector<std::string> cut_texts;
};

struct FrameContext {
  State& state;
  Settings& settings;
  const Input& input;
  Requests& requests;
  Layout layout;
  Type type;  // text sizes of this frame
  Painter painter;
  Settings stored{};  // the settings with nothing left to choose: what is stored, and where

  glm::ivec2 frame_size() const { return input.report.size.x > 0 ? input.report.size : settings.size; }
  std::optional<glm::ivec2> held_pixel() const {
    if (!state.held_at) return {};
    return glm::clamp(glm::ivec2(*state.held_at * glm::dvec2(frame_size())), glm::ivec2(0), frame_size() - 1);
  }
  void hold(glm::ivec2 pixel) {
    pixel = glm::clamp(pixel, glm::ivec2(0), frame_size() - 1);
    state.held_at = (glm::dvec2(pixel) + 0.5) / glm::dvec2(frame_size());
  }
  View chosen() const { return view_by_id(settings.view.main).view; }
};

// ---- the one way to change something: keys and widgets alike get a caption and an Error becomes a notice ------
void say(FrameContext&, Sentence);
void edit(FrameContext&, const std::function<void(Settings&)>& change);
void edit_option(FrameContext&, const Option&, const OptionValue&);
void edit_option_as_typed(FrameContext&, const Option&, const std::string&);
void step_option(FrameContext&, const Option&, int step);  // choices cycle, whole numbers double and halve
bool replace_settings(FrameContext&, const Settings&);     // by whole ones; the size stays: it is the window's
void choose_preset(FrameContext&, int index);
void show_view(FrameContext&, View);  // alone; again: all views
// The views of a page of the mosaic; empty: the first page, whose places are fixed.
std::vector<LookOf> page_of(const Settings& stored, size_t page);
size_t pages_of(const Settings& stored);

void open_pitfall(State&, Settings&, std::string_view id);  // broken, in its panel; Error with the known ones
void open_lesson(State&, Settings&, LessonPlace);
void show_step(State&, Settings&, size_t step);  // of the open lesson; the size stays
void advance_motion(FrameContext&);              // time, glide and camera keys, once a frame

void ask_figure(FrameContext&);  // of the chosen panel, if a key has asked for it

// ---- looking closely (view_tools.cpp) --------------------------------------------------------------
Zoom zoom_of(const FrameContext&, View);
void set_zoom(FrameContext&, View, const Zoom&, bool this_panel_only);
void show_whole(FrameContext&);  // all panels
void show_pixel_for_pixel(FrameContext&);
double most_zoom(const FrameContext&, const Box& panel);  // a pixel is as large as its numbers need, and no larger
// What is changed of a look is of decoded numbers: stored codes are shown no more.
void change_look(FrameContext&, View, const std::function<void(ViewLook&)>&);
bool toggle_raw(FrameContext&, View);  // the stored codes, or as it was by itself; true: the codes are shown
void use_view_tools(FrameContext&);    // the buttons on the large picture: before what lies below them
void draw_view_tools(FrameContext&);
void draw_pixel_grid(FrameContext&, View, const Box& picture);  // and the numbers on the pixels

// ---- what is always there, one function each; the others are rows of ui/panel.h --------------------
void draw_pictures(FrameContext&);
void use_titles(FrameContext&);    // before what lies below them
void draw_carried(FrameContext&);  // the title that is being dragged
void lock_panel(FrameContext&);    // the main view as it looks now, in the mosaic's last place; again: not any more
void draw_error_numbers(FrameContext&, const Box& panel);  // on the error or reference view, if it is the large one
void draw_strip(FrameContext&);
void draw_lesson(FrameContext&, const Box&);
void draw_control_column(FrameContext&);
void draw_status_bar(FrameContext&);
void draw_notices(FrameContext&);
void draw_hidden_hint(FrameContext&);
float status_height(const Type&);

// A widget in a box: a choice's combo (unsound rows marked, unavailable ones disabled with the reason).
void draw_choice(FrameContext&, const Option&, const Box&, float px);
std::string sound_mark(const Option&, const Settings&);  // "⚠ unsound: pitfall" or ""
void explain_unsound(FrameContext&, const Option&);      // opens the pitfall that its value shows

// A line to type in, over the whole box; true when Enter was pressed in it. It loses the keyboard then. `put` is a text
// that takes the place of what is typed; it is taken once the field has the keyboard.
bool draw_text_field(FrameContext&, const char* id, const Box&, float px, char* buffer, size_t size,
                     std::optional<std::string>* put = nullptr);

// A window for overlays: fixed, above the pictures, without any decoration.
bool begin_overlay(const char* id, const Box&, ImU32 background);
void end_overlay();

}  // namespace gbl::ui
