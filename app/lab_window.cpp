#include "app/lab_window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>
#include <future>
#include <limits>
#include <utility>

#include "app/figure_file.h"
#include "app/imgui_screen.h"
#include "app/layout_watch.h"
#include "app/load_stage.h"
#include "app/path_completion.h"
#include "app/picture_texts.h"
#include "app/start.h"
#include "app/viewer.h"
#include "app/window.h"
#include "renderer/base/files.h"
#include "renderer/base/memory.h"
#include "renderer/base/threads.h"
#include "renderer/gl/gl.h"
#include "renderer/opening/scene_look.h"

namespace gbl {
namespace {

constexpr glm::ivec2 kWindowSize{1600, 900};
constexpr double kFrameSeconds = 1.0 / 60;  // pace while something happens
constexpr double kMeasureSeconds = 0.001;   // pace of a study that nobody disturbs: each frame is a step of it
constexpr double kQuietSeconds = 0.3;       // without a hand on the window before anything is measured beside it
constexpr double kIdleSeconds = 0.25;       // how late a saved shader or an answer may be noticed
constexpr double kSettledSeconds = 1;       // after which nothing that was touched changes any more, tooltips included
constexpr double kAddressSeconds = 0.3;     // without a change before the address follows; less than the above
constexpr int kSettledFrames = 4;           // ImGui needs a few
constexpr double kNever = std::numeric_limits<double>::infinity();

// ImGui's GLFW back-end for as long as the window runs.
struct GlfwBackend {
  explicit GlfwBackend(const Window& w) { ImGui_ImplGlfw_InitForOpenGL(w.handle(), true), adjust_imgui(w.handle()); }
  ~GlfwBackend() { ImGui_ImplGlfw_Shutdown(); }
};

void show_start(Window& window, ImguiScreen& screen, const std::string& line) {
  const glm::ivec2 size = window.framebuffer_size();
  if (size.x == 0 || size.y == 0) return;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  screen.draw(size, [&] { ui::draw_start(line); });
  window.swap();
}

// Reads what the window starts with while it says how far it is. Nothing if the window was closed meanwhile.
std::optional<Start> open_meanwhile(const Arguments& a, SessionKeeper& keeper, Window& window, ImguiScreen& screen) {
  LoadStage stage;
  const std::string scene =
      goes_on(a) && keeper.found().last ? keeper.found().last->settings.scene : a.scene.value_or("");
  std::future<Start> work = in_background([&] { return start_of(a, keeper, &stage.progress()); });
  while (work.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    show_start(window, screen, fmt::format("reading {}: {}", scene, stage.text()));
    window.wait_events(kFrameSeconds);
    if (!window.closing()) continue;
    stage.cancel();
    work.wait();
    return {};
  }
  return work.get();
}

class Loop {
 public:
  Loop(const Arguments& a, Window& window, ImguiScreen& screen, SessionKeeper& keeper, Start start)
      : window_(window),
        screen_(screen),
        keeper_(keeper),
        session_(keeper.found()),
        remembered_(is_remembered(a)),
        lab_(without_of(a)),
        nearest_(nearest_with(lab_.limits().features, std::move(start.asked.settings))),
        settings_(nearest_.settings),
        ui_(settings_, a.present),
        viewer_(lab_),
        backend_(window_) {
    ui_.start_type(window_.content_scale(), window_.framebuffer_size());
    ui_.set_bookmarks(session_.bookmarks);
    viewer_.say(fmt::format("{}", fmt::join(nearest_.sentences, "; ")));
    if (start.asked.scene) show(std::move(start.asked.scene));
    if (start.left) go_on(*std::move(start.left), std::move(start.left_scene));
    for (const auto& file : {a.scene, a.rig, a.state})
      if (file && (file != a.scene || is_file(*file))) remember(session_.recent, *file);
    if (!a.lesson.empty()) ui_.open_lesson(a.lesson, settings_);
    if (!a.lesson.empty() && a.state) settings_ = nearest_.settings;  // what somebody made of the step
    if (!a.pitfall.empty()) ui_.open_pitfall(a.pitfall, settings_);
    settings_.size = {800, 450};
    ui::Requests first;  // the picture is there at once; what else is visible is drawn when the window has asked for it
    first.visible[static_cast<size_t>(view_by_id(settings_.view.main).view)] = true;
    lab_.open(settings_.scene);
    viewer_.update(settings_, first, false);
    if (kHasThreads) viewer_.compile_ahead();  // a page would stand still meanwhile
    in_address_ = wherever(settings_), lesson_in_address_ = ui_.lesson_place();
    say_trouble();
  }

  bool step() {
    if (window_.closing()) return false;
    draw_frame();
    return true;
  }

  std::optional<LabWindow::Probed> probed() const {
    return probed_ ? std::optional(LabWindow::Probed{*probed_, settings_.size}) : std::nullopt;
  }

  void keep() {
    keeper_.keep(session(), glfwGetTime());
    if (const std::string trouble = keeper_.take_trouble(); !trouble.empty())
      fmt::print(stderr, "gbufferlab: {}\n", trouble);
  }

 private:
  void show(std::shared_ptr<const Scene> scene) {
    std::vector<std::string> said = nearest_.sentences;
    for (std::string& note : notes_of(*scene, settings_.lights.source)) said.push_back(std::move(note));
    viewer_.say(fmt::format("{}", fmt::join(said, "; ")));
    lab_.show(settings_.scene, std::move(scene));
  }

  // Where the window was left, as near as this device comes to it.
  void go_on(ui::Snapshot left, std::shared_ptr<const Scene> scene) {
    Settings home = settings_;
    home.size = left.settings.size;
    try {
      nearest_ = nearest_with(lab_.limits().features, std::move(left.settings));
      left.settings = nearest_.settings;
      require_valid(left.settings, lab_.limits());
      ui_.show(left, settings_);
      show(std::move(scene));
      if (nearest_.sentences.empty() && !(left.settings == home))
        viewer_.say("As the window was left. Home: as it is loaded.");
    } catch (const Error& e) {
      keeper_.put_aside(e.what());
    }
  }

  void toggle_full_screen() {
    try {
      window_.toggle_full_screen();
    } catch (const Error& e) {
      viewer_.fail(e.what());
    }
  }

  void drop(const std::vector<std::string>& files) {
    if (files.size() > 1) return viewer_.fail(fmt::format("{} files at once: drop one", files.size()));
    if (!files.empty()) open(files.front());
  }

  // While A and B are set up a picture is B; so is one that brings no settings back.
  void open(const std::string& file) {
    if (!only_a_picture(file) && !(ui_.is_open("compare") && is_picture(file))) return viewer_.drop(file);
    ui_.compare_with(file);
    remember(session_.recent, file);
  }

  void take(const Viewer::Opened& opened) {
    if (opened.whole)
      ui_.show({opened.settings, opened.settings.view.main != "final"}, settings_);
    else
      settings_ = opened.settings;
    if (is_file(opened.file)) remember(session_.recent, opened.file);
  }

  Session session() const {
    Session now = session_;
    if (remembered_) now.last = ui_.snapshot(settings_);
    now.bookmarks = ui_.bookmarks();
    return now;
  }

  // -> is there anything to say?
  bool say_trouble() {
    const std::string trouble = keeper_.take_trouble();
    if (!trouble.empty()) viewer_.fail(trouble);
    return !trouble.empty();
  }

  bool keep_session(double seconds) {
    if (!keeper_.due(seconds)) return false;
    keeper_.keep(session(), seconds);
    return say_trouble();
  }

  // -> was it saved?
  bool take_saved_layout() {
    if (settings_.layout_file.empty()) return false;
    try {
      const auto name = layout_watch_.saved(settings_.layout_file);
      if (name) settings_.layout_file = *name;
      return name.has_value();
    } catch (const Error& e) {
      viewer_.fail(e.what());  // the last good one goes on drawing
      return true;
    }
  }

  void draw_frame() {
    window_.wait_events(pace());
    const glm::ivec2 size = window_.framebuffer_size();
    if (size.x == 0 || size.y == 0) return;  // minimised
    if (window_.saw_input()) stir();
    if (resting()) return;
    ++quiet_frames_;
    const double begin = glfwGetTime();
    const bool was_busy = viewer_.busy();
    ui::Input input = viewer_.input(glfwGetTime());
    input.full_screen = window_.full_screen();
    input.still = wants_less_motion();
    path_.recent = session_.recent;
    input.path = &path_;
    input.held.assign(window_.held().begin(), window_.held().end());
    ui::Requests requests;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    const std::vector<ui::KeyEvent> keys = window_.take_keys();
    if (!keys.empty()) viewer_.say("");
    drop(window_.take_drops());
    if (const auto opened = viewer_.take_opened(settings_)) take(*opened);
    take_saved_layout();
    ImGui_ImplGlfw_NewFrame();
    const Settings before = settings_;
    screen_.draw(size, [&] { requests = ui_.draw(settings_, input, keys); });
    if (touched(input, keys)) touched_s_ = input.seconds;
    // Another scene and nothing else: it is to bring its camera, its lights and its look, as a dropped file does.
    Settings renamed = before;
    renamed.scene = settings_.scene;
    if (settings_.scene != before.scene && settings_ == renamed)
      viewer_.open_scene(std::exchange(settings_.scene, before.scene));
    if (requests.path.open && requests.path.typed != path_.asked) path_ = completions(requests.path.typed);
    if (!requests.path.file.empty()) open(at_home(requests.path.file));
    if (requests.figure) save(*requests.figure, size);
    if (requests.copy_command) copy_command();
    window_.swap();
    wakes_s_ = requests.wake_in ? glfwGetTime() + *requests.wake_in : kNever;
    if (requests.toggle_full_screen) toggle_full_screen();
    if (requests.quit) glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
    if (requests.picture_size.x > 0) settings_.size = requests.picture_size;
    probed_ = requests.probe;
    viewer_.update(settings_, requests, ui_.moving(settings_));
    viewer_.measure(settings_, requests, input.seconds - touched_s_ > kQuietSeconds);
    tell_system(requests.in_words);
    const bool trouble = keep_session(input.seconds), slow = glfwGetTime() - begin > kIdleSeconds;
    if (trouble || slow || was_busy || viewer_.busy()) stir();  // what came of it is drawn by the next steps
  }

  // The size is the window's, wherever it is opened.
  static Settings wherever(Settings s) {
    s.size = Settings{}.size;
    return s;
  }

  void tell_system(const std::string& words) {
    if (words != in_words_) say_in_words(in_words_ = words);
    if (ui_.moving(settings_) || glfwGetTime() - stirred_s_ < kAddressSeconds) return;
    const Settings now = wherever(settings_);
    const std::string lesson = ui_.lesson_place();
    if (now == in_address_ && lesson == lesson_in_address_) return;
    show_in_address(in_address_ = now, lesson_in_address_ = lesson);
  }

  void stir() { quiet_frames_ = 0, stirred_s_ = glfwGetTime(), tidy_ = false; }

  // What is on the screen is drawn already, and nothing can change it but an event, a file that is saved, or a moment
  // that was asked for. Then only files are looked at, and no processor works for a window that nobody touches.
  bool resting() {
    const double now = glfwGetTime();
    const bool settled = quiet_frames_ >= kSettledFrames && now - stirred_s_ > kSettledSeconds;
    if (!settled || now >= wakes_s_ || ImGui::GetIO().WantTextInput || viewer_.busy()) return false;
    if (viewer_.shaders_saved() || keep_session(now) || take_saved_layout()) {
      stir();
      return false;
    }
    if (!std::exchange(tidy_, true)) return_free_pages();
    return true;
  }

  void save(const ui::Figure& figure, glm::ivec2 size) {
    try {
      viewer_.say(save_figure(figure, size, screen_, settings_, lab_.machine()));
    } catch (const Error& e) {
      viewer_.fail(e.what());
    }
  }

  void copy_command() {
    const std::string line = command_line("gbufferlab render", settings_);
    ImGui::SetClipboardText(line.c_str());
    viewer_.say(fmt::format("copied: {}", line));
  }

  // Not every event is a hand's: the window system has its own.
  static bool touched(const ui::Input& input, const std::vector<ui::KeyEvent>& keys) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool mouse = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0 || ImGui::IsAnyMouseDown();
    return mouse || !keys.empty() || !input.held.empty();
  }

  // Full pace while something moves or has just happened (ImGui needs a few frames to settle), else nearly asleep.
  double pace() const {
    if (viewer_.measuring()) return kMeasureSeconds;
    if (viewer_.busy() || quiet_frames_ < kSettledFrames) return kFrameSeconds;
    return std::clamp(wakes_s_ - glfwGetTime(), 0.0, kIdleSeconds);
  }

  Window& window_;
  ImguiScreen& screen_;
  SessionKeeper& keeper_;
  Session session_;
  ui::PathInput path_ = completions("");
  bool remembered_;  // what is shown, for the next window
  Lab lab_;
  Nearest nearest_;  // to what was asked for, on this device
  Settings settings_;
  ui::Ui ui_;
  Viewer viewer_;
  GlfwBackend backend_;
  LayoutWatch layout_watch_;
  int quiet_frames_ = 0;
  double touched_s_ = glfwGetTime();  // by a hand; that it was opened counts
  double stirred_s_ = 0;              // when anything happened last
  double wakes_s_ = kNever;           // when the window changes by itself
  bool tidy_ = false;                 // nothing has happened since memory was given back
  Settings in_address_;               // what it started with stands there already
  std::string lesson_in_address_;
  std::string in_words_;
  std::optional<glm::ivec2> probed_;
};

}  // namespace

// In this order they come and, the other way round, go.
struct LabWindow::Parts {
  explicit Parts(gl::Api api) : window(kWindowSize, "G-Buffer Lab", api), screen(api), keeper(session_file()) {}

  Window window;
  ImguiScreen screen;
  SessionKeeper keeper;
  std::optional<Loop> loop;  // empty: the window was closed before it was open
};

LabWindow::LabWindow(const Arguments& a) : parts_(std::make_unique<Parts>(api_of(a))) {
  Parts& p = *parts_;
  std::optional<Start> start = open_meanwhile(a, p.keeper, p.window, p.screen);
  if (!start) return;
  show_start(p.window, p.screen, "compiling shaders, drawing the first frame");
  p.loop.emplace(a, p.window, p.screen, p.keeper, std::move(*start));
}

LabWindow::~LabWindow() = default;

bool LabWindow::step() { return parts_->loop && parts_->loop->step(); }

void LabWindow::keep() {
  if (parts_->loop) parts_->loop->keep();
}

std::optional<LabWindow::Probed> LabWindow::probed() const {
  return parts_->loop ? parts_->loop->probed() : std::nullopt;
}

}  // namespace gbl
