#include "tests/ui/window_desk.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "renderer/options/settings_json.h"
#include "tests/flatness.h"
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

// Looks again and again, with a pause between: a look that starts a program needs a longer one.
template <class Ready>
bool wait_for(Ready ready, std::chrono::milliseconds limit, std::chrono::milliseconds pause = 5ms) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (std::chrono::steady_clock::now() < end) {
    if (ready()) return true;
    std::this_thread::sleep_for(pause);
  }
  return ready();
}

// What a process does, all threads together.
struct Activity {
  uint64_t computed_ns = 0;  // since it began
  bool awake = false;        // a thread computes now, or would if it got a processor
};

Activity activity_of(int process) {
  Activity out;
  for (std::error_code e; const auto& task : fs::directory_iterator(fmt::format("/proc/{}/task", process), e)) {
    uint64_t ns = 0;
    std::ifstream(task.path() / "schedstat") >> ns;
    out.computed_ns += ns;
    std::string stat;
    std::getline(std::ifstream(task.path() / "stat"), stat);
    const size_t name_end = stat.rfind(')');  // "pid (name) S ..."
    out.awake |= name_end != std::string::npos && name_end + 2 < stat.size() && stat[name_end + 2] != 'S';
  }
  return out;
}

void stop(int& child) {
  if (child <= 0) return;
  kill(child, SIGTERM);
  waitpid(child, nullptr, 0);
  child = -1;
}

}  // namespace

std::string xdotool_name(const ui::KeyEvent& e) {
  static const std::map<std::string, std::string> kNames = {
      {"[", "bracketleft"}, {"]", "bracketright"}, {",", "comma"},    {".", "period"},
      {"+", "plus"},        {"-", "minus"},        {"PgUp", "Prior"}, {"PgDn", "Next"},
      {"Enter", "Return"},  {"Space", "space"},    {"Esc", "Escape"}, {"/", "slash"}};
  const auto named = kNames.find(e.key);
  return std::string(e.ctrl ? "ctrl+" : "") + (e.shift ? "shift+" : "") +
         (named == kNames.end() ? e.key : named->second);
}

WindowDesk::WindowDesk(const std::vector<std::string>& arguments, fs::path state) : state_(std::move(state)) {
  for (const char* needed : {"Xvfb", "xdotool"})
    if (!have(needed)) missing_ = needed;
  if (!missing_.empty()) return;
  char name[] = "/tmp/gbl-window-XXXXXX";
  folder_ = mkdtemp(name);
  if (state_.empty()) state_ = folder_ / "state";
  start_server();
  if (!why_not_.empty()) return;
  start_program(arguments);
  wait_for([&] { return !(window_ = find_window()).empty(); }, 20s, 50ms);
  if (window_.empty())
    why_not_ = "the window did not open";
  else
    wait_until_drawn();
}

WindowDesk::~WindowDesk() {
  stop(program_);
  stop(server_);
  fmt::print(stderr, "{}", said());
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
  // The server writes its display's number when clients may come, and a line's end after it: where that second write
  // finds no reader, it dies.
  std::string number;
  for (char c = 0; c != '\n' && read(fds[0], &c, 1) == 1;) number += c;
  ::close(fds[0]);
  if (!number.ends_with('\n')) why_not_ = "Xvfb did not start";
  display_ = fmt::format(":{}", std::atoi(number.c_str()));
}

void WindowDesk::start_program(const std::vector<std::string>& arguments) {
  program_ = fork();
  if (program_ != 0) return;
  setenv("DISPLAY", display_.c_str(), 1);
  unsetenv("WAYLAND_DISPLAY");
  setenv("XDG_STATE_HOME", state_.c_str(), 1);  // and never the session of whoever runs the tests
  if (chdir(folder_.c_str()) != 0) _exit(127);
  dup2(::open("said", O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
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
    press("shift+F12");
    if (wait_for([&] { return fs::exists(folder_ / "out"); }, 2s)) break;
  }
  wait_until_at_rest();
  std::error_code ignored;
  fs::remove_all(folder_ / "out", ignored);
}

// The program draws at full pace while anything happens and is nearly asleep else (a look every 250 ms): it rests when
// neither it nor the server has computed for longer than a frame's pause. A study at work never rests.
void WindowDesk::wait_until_at_rest(std::chrono::seconds most) const {
  constexpr auto kLongerThanAPause = 50ms;
  uint64_t computed_ns = 0;
  auto since = std::chrono::steady_clock::now();
  wait_for(
      [&] {
        const Activity program = activity_of(program_), server = activity_of(server_);
        const auto now = std::chrono::steady_clock::now();
        const uint64_t sum_ns = program.computed_ns + server.computed_ns;
        if (program.awake || server.awake || sum_ns != computed_ns) computed_ns = sum_ns, since = now;
        return now - since >= kLongerThanAPause;
      },
      most);
}

void WindowDesk::press(const std::string& key) {
  const uint64_t before_ns = activity_of(program_).computed_ns;
  (void)std::system(
      fmt::format("DISPLAY={} xdotool windowfocus {} key --clearmodifiers {} 2>/dev/null", display_, window_, key)
          .c_str());
  constexpr uint64_t kFrameNs = 2'000'000;  // the interface alone takes longer
  wait_for([&] { return activity_of(program_).computed_ns - before_ns > kFrameNs; }, 300ms);
}

void WindowDesk::hold(const std::string& key, int milliseconds) {
  (void)std::system(fmt::format("DISPLAY={} xdotool windowfocus {} keydown {} sleep {} keyup {}", display_, window_,
                                key, milliseconds / 1000.0, key)
                        .c_str());
}

void WindowDesk::resize(glm::ivec2 size) {
  (void)std::system(
      fmt::format("DISPLAY={} xdotool windowsize --sync {} {} {}", display_, window_, size.x, size.y).c_str());
}

// Slowly enough for a frame between two keys: what is pressed and let go within one never was.
void WindowDesk::type(const std::string& text) {
  wait_until_at_rest();
  (void)std::system(
      fmt::format("DISPLAY={} xdotool windowfocus {} type --delay 60 '{}'", display_, window_, text).c_str());
  wait_until_at_rest();
}

double WindowDesk::computed_s() const { return static_cast<double>(activity_of(program_).computed_ns) * 1e-9; }

double WindowDesk::resident_mib() const { return test::resident_mib(program_); }

std::string WindowDesk::said() const {
  std::ostringstream text;
  text << std::ifstream(folder_ / "said").rdbuf();
  return text.str();
}

bool WindowDesk::runs() const { return program_ > 0 && waitpid(program_, nullptr, WNOHANG) == 0; }

int WindowDesk::close() {
  press("ctrl+x");
  return ended("Ctrl+X did not close the window");
}

int WindowDesk::lose_display() {
  kill(server_, SIGKILL);
  waitpid(server_, nullptr, 0);
  server_ = -1;
  return ended("it did not end with its display");
}

int WindowDesk::ended(const char* why_not) {
  int status = 0;
  const bool ended = wait_for([&] { return waitpid(program_, &status, WNOHANG) == program_; }, 10s);
  EXPECT_TRUE(ended) << why_not;
  if (!ended) return -1;
  program_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

Figure WindowDesk::figure(const char* key, std::chrono::seconds most) {
  wait_until_at_rest(most);
  const fs::path folder = folder_ / "out";
  std::error_code ignored;
  fs::remove_all(folder, ignored);  // what an earlier press has saved late
  press(key);
  fs::path saved;
  wait_for(
      [&] {
        for (std::error_code e; const auto& entry : fs::directory_iterator(folder, e))
          if (entry.path().extension() == ".png") saved = entry.path();
        return !saved.empty();
      },
      10s);
  EXPECT_FALSE(saved.empty()) << key << " saved no picture";
  if (saved.empty()) return {};
  Figure f{read_png(saved), parse_settings(read_png_text(saved, kSettingsKey), "figure")};
  f.file = folder_ / fmt::format("figure-{}.png", ++figures_);
  fs::rename(saved, f.file);
  return f;
}

void WindowDesk::keep(const std::string& name, const Figure& f) const {
  const fs::path folder = test::build_folder() / "window";
  fs::create_directories(folder);
  fs::copy_file(f.file, folder / (name + ".png"), fs::copy_options::overwrite_existing);
}

}  // namespace gbl
