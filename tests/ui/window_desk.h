#pragma once
// A real window for a test: an X server of its own, the program in it, keys sent as a user would, and what it did read
// back from the pictures that F12 saves (they carry the settings).
#include <chrono>
#include <filesystem>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "renderer/options/settings.h"
#include "renderer/picture/image.h"
#include "ui/ui.h"

namespace gbl {

struct Figure {
  Image picture;
  Settings settings;
  std::filesystem::path file;  // as long as the desk stands
};

std::string xdotool_name(const ui::KeyEvent&);

class WindowDesk {
 public:
  // state: the folder of XDG_STATE_HOME, for runs that follow each other; empty: one that goes with the desk.
  explicit WindowDesk(const std::vector<std::string>& arguments = {}, std::filesystem::path state = {});
  ~WindowDesk();
  WindowDesk(const WindowDesk&) = delete;

  bool open() const { return !window_.empty(); }
  std::string why_not() const { return why_not_; }
  double computed_s() const;    // seconds of a processor that the program has used
  double resident_mib() const;  // the program's memory that is in RAM
  bool runs() const;
  std::string said() const;                         // by the program, on stderr
  std::string missing() const { return missing_; }  // a program that the test needs; empty = all there
  void press(const std::string& xdotool_key);       // "c", "shift+c", "Page_Down"
  void hold(const std::string& key, int milliseconds);
  void resize(glm::ivec2);
  void type(const std::string& text);
  int close();         // by its key; the program's exit code
  int lose_display();  // its X server is killed; the program's exit code
  // Presses F12 and reads the file it saved: what is shown once the window rests, or after so long.
  Figure figure(const char* key = "shift+F12", std::chrono::seconds most = std::chrono::seconds(2));
  void keep(const std::string& name, const Figure&) const;  // a picture to look at, in the build folder

 private:
  void start_server();
  void start_program(const std::vector<std::string>& arguments);
  int ended(const char* why_not);  // waits; the exit code
  std::string find_window() const;
  void wait_until_drawn();
  void wait_until_at_rest(std::chrono::seconds most = std::chrono::seconds(2)) const;
  std::filesystem::path folder_;  // the program's working folder
  std::filesystem::path state_;
  std::string display_, window_, why_not_, missing_;
  int server_ = -1, program_ = -1;
  int figures_ = 0;
};

#define SKIP_WITHOUT_WINDOW(desk)                                                         \
  if (!(desk).missing().empty()) GTEST_SKIP() << (desk).missing() << " is not installed"; \
  ASSERT_TRUE((desk).open()) << (desk).why_not()

}  // namespace gbl
