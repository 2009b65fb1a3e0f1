#pragma once
// What the system of windows does: a desktop's (window_system.cpp) or a browser's (web/window_system.cpp).
#include <glm/glm.hpp>
#include <string>

#include "renderer/gl/device.h"
#include "renderer/options/settings.h"

struct GLFWwindow;

namespace gbl {

void ask_for_context(gl::Api);  // of the next window
void name_lost_displays();      // the program ends in its own words when its display goes

// Until the first event, at latest so long; was there any? A browser says by itself when a frame is due.
bool wait_for_events(double seconds);

std::string printed_name(int key, int scancode);  // what this keyboard prints on it, lower case; empty: nothing
float content_scale_of(GLFWwindow*);              // how much larger than usual its monitor wants things; in quarters
void fit_monitor(GLFWwindow*);                    // no larger than there is room for

void adjust_imgui(GLFWwindow*);  // after ImGui's back-end, where it takes another system for granted

bool wants_less_motion();  // whoever uses this system

// Beside the window: a page's address, which brings these settings and the lesson's step back ("": no lesson), and its words
// for who does not see the picture.
void show_in_address(const Settings&, const std::string& lesson_place);
void say_in_words(const std::string&);
// A file that somebody asked to be saved: a page has no folder, so it is given as a download.
void hand_over(const std::string& file);

class FullScreen {
 public:
  bool on(GLFWwindow*) const;
  void toggle(GLFWwindow*);  // and back to where it was; Error where there is no monitor

 private:
  glm::ivec2 place_{0}, size_{0};  // of the window, while it fills the screen
};

}  // namespace gbl
