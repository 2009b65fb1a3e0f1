#include "tests/ui/window_desk.h"

#include <chrono>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "renderer/options/settings_json.h"
#include "tests/test_paths.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// First line of what a command prints.
std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  char line[256] = {};
  const bool got = pipe && std::fgets(line, sizeof line, pipe);
  if (pipe) pclose(pipe);
  std::string text = got ? line : "";
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

bool have(const char* program) { return !output_of(fmt::format("command -v {}", program)).empty(); }

template <class Ready>
bool wait_for(Ready ready, std::chrono::seconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (std::chrono::steady_clock::now() < end) {
    if (ready()) return true;
    std::this_thread::sleep_for(30ms);
  }
  return ready();
}

void stop(int& child) {
  if (child <= 0) return;
  kill(child, SIGTERM);
  waitpid(child, nullptr, 0);
  child = -1;
}

}  // namespace

WindowDesk::WindowDesk(std::vector<std::string> arguments) {
  for (const char* needed : {"Xvfb", "xdotool"})
    if (!have(needed)) missing_ = needed;
  if (!missing_.empty()) return;
  char name[] = "/tmp/gbl-window-XXXXXX";
  folder_ = mkdtemp(name);
  // A server may name its display and yet refuse the first client; then another one is started.
  for (int attempt = 0; attempt < 4 && !server_answers(); ++attempt) {
    stop(server_);
    start_server();
  }
  if (!server_answers()) why_not_ = "Xvfb does not answer";
  if (!why_not_.empty()) return;
  start_program(arguments);
  wait_for([&] { return !(window_ = find_window()).empty(); }, 20s);
  if (window_.empty())
    why_not_ = "the window did not open";
  else
    wait_until_drawn();
}

WindowDesk::~WindowDesk() {
  stop(program_);
  stop(server_);
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void WindowDesk::start_server() {
  int fds[2];
  if (pipe(fds) != 0) return void(why_not_ = "no pipe");
  server_ = fork();
  if (server_ == 0) {
    const std::string fd = std::to_string(fds[1]);
    ::close(fds[0]);
    const int null = ::open("/dev/null", O_WRONLY);
    dup2(null, 2);
    execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1600x900x24", "-nolisten", "tcp", "-noreset",
           nullptr);
    _exit(127);
  }
  ::close(fds[1]);
  char number[16] = {};
  if (read(fds[0], number, sizeof number - 1) <= 0) why_not_ = "Xvfb did not start";
  ::close(fds[0]);
  display_ = fmt::format(":{}", std::atoi(number));
}

bool WindowDesk::server_answers() const {
  if (display_.empty()) return false;
  const std::string ask = fmt::format("DISPLAY={} xdotool getdisplaygeometry 2>/dev/null", display_);
  return wait_for([&] { return output_of(ask) == "1600 900"; }, 2s);
}

void WindowDesk::start_program(const std::vector<std::string>& arguments) {
  program_ = fork();
  if (program_ != 0) return;
  setenv("DISPLAY", display_.c_str(), 1);
  unsetenv("WAYLAND_DISPLAY");
  if (chdir(folder_.c_str()) != 0) _exit(127);
  std::string program_file = test::program();
  std::vector<char*> argv = {program_file.data(), const_cast<char*>("view")};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  execv(program_file.c_str(), argv.data());
  _exit(127);
}

std::string WindowDesk::find_window() const {
  return output_of(fmt::format("DISPLAY={} xdotool search --name 'G-Buffer Lab' 2>/dev/null", display_));
}

void WindowDesk::wait_until_drawn() {
  // The first picture that F12 saves tells that keys arrive; a key sent before that is lost.
  for (int attempt = 0; attempt < 20; ++attempt) {
    press("F12");
    if (wait_for([&] { return fs::exists(folder_ / "out"); }, 1s)) break;
  }
  std::this_thread::sleep_for(500ms);
  std::error_code ignored;
  fs::remove_all(folder_ / "out", ignored);
}

void WindowDesk::press(const std::string& key) {
  (void)std::system(
      fmt::format("DISPLAY={} xdotool windowfocus {} key --clearmodifiers {} 2>/dev/null", display_, window_, key)
          .c_str());
  std::this_thread::sleep_for(60ms);
}

void WindowDesk::hold(const std::string& key, int milliseconds) {
  (void)std::system(fmt::format("DISPLAY={} xdotool windowfocus {} keydown {} sleep {} keyup {}", display_, window_,
                                key, milliseconds / 1000.0, key)
                        .c_str());
}

Figure WindowDesk::figure() {
  std::this_thread::sleep_for(450ms);  // a frame on the software driver, its counts, and ImGui's settling
  const fs::path folder = folder_ / "out";
  press("F12");
  fs::path saved;
  wait_for(
      [&] {
        for (std::error_code e; const auto& entry : fs::directory_iterator(folder, e))
          if (entry.path().extension() == ".png") saved = entry.path();
        return !saved.empty();
      },
      10s);
  EXPECT_FALSE(saved.empty()) << "F12 saved no picture";
  if (saved.empty()) return {};
  Figure f{read_png(saved), parse_settings(read_png_text(saved, kSettingsKey), "figure")};
  fs::remove(saved);
  return f;
}

void WindowDesk::keep(const std::string& name, const Figure& f) const {
  fs::create_directories("window");
  write_png(fs::path("window") / (name + ".png"), f.picture);
}

}  // namespace gbl
