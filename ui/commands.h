#pragma once
// The functions of the command table. A command gets the key of its row that was pressed ("," or ".").
#include "ui/ui.h"

namespace gbl::ui {

struct FrameContext;

void undo(FrameContext&, const KeyEvent&);
void redo(FrameContext&, const KeyEvent&);
void quit(FrameContext&, const KeyEvent&);
void keep_bookmark(FrameContext&, const KeyEvent&);  // bookmarks.cpp
void go_to_bookmark(FrameContext&, const KeyEvent&);
void show_whole_picture(FrameContext&, const KeyEvent&);
void show_pixels(FrameContext&, const KeyEvent&);
void step_channels(FrameContext&, const KeyEvent&);
void step_map(FrameContext&, const KeyEvent&);
void lock_view(FrameContext&, const KeyEvent&);
void fit_range(FrameContext&, const KeyEvent&);
void show_codes(FrameContext&, const KeyEvent&);
void toggle_histogram(FrameContext&, const KeyEvent&);
void show_all(FrameContext&, const KeyEvent&);
void next_preset(FrameContext&, const KeyEvent&);
void go_home(FrameContext&, const KeyEvent&);
void glide(FrameContext&, const KeyEvent&);
void solo_light(FrameContext&, const KeyEvent&);
void pick_light(FrameContext&, const KeyEvent&);
void pick_object(FrameContext&, const KeyEvent&);
void show_error(FrameContext&, const KeyEvent&);
void go_to_worst(FrameContext&, const KeyEvent&);
void reveal_answer(FrameContext&, const KeyEvent&);
void meter_light(FrameContext&, const KeyEvent&);
void toggle_time(FrameContext&, const KeyEvent&);
void toggle_presenting(FrameContext&, const KeyEvent&);
void toggle_reticle(FrameContext&, const KeyEvent&);
void toggle_talk_timer(FrameContext&, const KeyEvent&);
void toggle_hidden(FrameContext&, const KeyEvent&);
void reload_shaders(FrameContext&, const KeyEvent&);
void toggle_navigation(FrameContext&, const KeyEvent&);
void toggle_white_figures(FrameContext&, const KeyEvent&);
void toggle_full_screen(FrameContext&, const KeyEvent&);
void toggle_theme(FrameContext&, const KeyEvent&);
void scale_type(FrameContext&, const KeyEvent&);
void nudge_pixel(FrameContext&, const KeyEvent&);
void close_top(FrameContext&, const KeyEvent&);

void stop_typing(FrameContext&);

}  // namespace gbl::ui
