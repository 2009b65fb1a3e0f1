#pragma once
// The functions of the command table. A command gets the key of its row that was pressed ("," or ".").
#include "ui/ui.h"

namespace gbl::ui {

struct Frame;

void show_all(Frame&, const KeyEvent&);
void next_preset(Frame&, const KeyEvent&);
void toggle_options(Frame&, const KeyEvent&);
void go_home(Frame&, const KeyEvent&);
void glide(Frame&, const KeyEvent&);
void solo_light(Frame&, const KeyEvent&);
void pick_light(Frame&, const KeyEvent&);
void pick_object(Frame&, const KeyEvent&);
void show_error(Frame&, const KeyEvent&);
void go_to_worst(Frame&, const KeyEvent&);
void step_lesson(Frame&, const KeyEvent&);
void reveal_answer(Frame&, const KeyEvent&);
void toggle_chart(Frame&, const KeyEvent&);
void toggle_stability(Frame&, const KeyEvent&);
void toggle_advisor(Frame&, const KeyEvent&);
void toggle_card(Frame&, const KeyEvent&);
void toggle_time(Frame&, const KeyEvent&);
void toggle_help(Frame&, const KeyEvent&);
void toggle_hidden(Frame&, const KeyEvent&);
void reload_shaders(Frame&, const KeyEvent&);
void toggle_navigation(Frame&, const KeyEvent&);
void save_figure(Frame&, const KeyEvent&);
void scale_type(Frame&, const KeyEvent&);
void nudge_pixel(Frame&, const KeyEvent&);
void open_go_to(Frame&, const KeyEvent&);
void close_top(Frame&, const KeyEvent&);

// While an overlay is open its own keys come first; true = the key was its.
bool press_in_chooser(Frame&, const KeyEvent&);
bool press_in_options(Frame&, const KeyEvent&);
bool press_in_chart(Frame&, const KeyEvent&);
bool press_in_stability(Frame&, const KeyEvent&);
bool press_in_advisor(Frame&, const KeyEvent&);
void stop_typing(Frame&);

}  // namespace gbl::ui
