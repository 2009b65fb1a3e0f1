#pragma once
// A and B: two whole settings, the truth or a picture from a file beside what the window draws. Both have one camera, one
// time and one view while they show one scene: a difference is then a difference of what is compared.
#include <optional>
#include <string>

#include "renderer/options/options.h"
#include "ui/compare_io.h"
#include "ui/text.h"
#include "ui/zoom.h"

namespace gbl::ui {

struct FrameContext;
struct KeyEvent;

enum class CompareMode { off, wipe, side_by_side, difference };

struct Comparison {
  CompareMode mode = CompareMode::off;
  BesideA what = BesideA::settings;
  std::optional<Settings> other;  // that the window does not draw; of `settings`
  bool b_drawn = false;           // the window draws B, and `other` is A
  std::string file;
  bool with_sign = false;
  double wipe = 0.5;  // where its line stands, 0..1 across the panel
  bool has_b() const { return other || what != BesideA::settings; }
};

// Is it part of what A and B are? What they share and what is looked at is not.
bool compared(const Option&);
// What A and B differ in: "Cull: back", "Normal: oct8, Lights: 8 and 2 more"; the values of `of`.
std::string differences(const Settings& of, const Settings& than);

void flip(FrameContext&, const KeyEvent&);          // Tab
void next_mode(FrameContext&, const KeyEvent&);     // /
void flip_to_cure(FrameContext&, const KeyEvent&);  // X: the unsound choices replaced, and back
void set_b(FrameContext&, Settings, const std::string& what);
void set_b_to_file(Comparison&, std::string file);

// The panel's part in which A is drawn: its left half where they stand side by side.
Box box_of_a(const FrameContext&, const Box& panel);
void use_wipe(FrameContext&);                           // its handle: before what lies below it
void draw_comparison(FrameContext&, const Box& panel);  // B, the difference, line and labels over the main picture
void ask_comparison(FrameContext&);
std::string comparison_in_words(const FrameContext&);  // empty: nothing is compared

}  // namespace gbl::ui
