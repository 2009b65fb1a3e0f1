#pragma once
// What the window does between two frames, without the window: when to draw, at which size, and what to say. Kept
// apart from GLFW so that it can be tested on a headless context.
#include <string>

#include "app/background.h"
#include "app/background_warm_up.h"
#include "app/comparer.h"
#include "app/file_opening.h"
#include "app/lab.h"
#include "app/scene_loader.h"

namespace gbl {

class Viewer {
 public:
  explicit Viewer(Lab& lab) : lab_(lab), comparer_(lab), jobs_(background_jobs(lab)) {}
  // After whatever panels ask for: until then nothing is compiled ahead.
  void compile_ahead() { jobs_.push_back(std::make_unique<BackgroundWarmUp>(lab_)); }

  // Draws what the requests ask for and what has changed, nothing else. Never throws for a bad setting or shader:
  // the message says what is wrong and the old picture stays.
  void update(const Settings&, const ui::Requests&, bool moving);
  // A piece of what the panels ask to be measured, if the machine is free for it. `quiet`: nobody has touched the
  // window lately.
  void measure(const Settings&, const ui::Requests&, bool quiet);
  bool measuring() const { return measuring_; }  // it did so in this frame
  ui::Input input(double seconds) const;

  // A file dropped on the window, as what it is. A scene that it needs is read beside the running picture: what is shown
  // stays until it is there, and for good if the file cannot be used.
  void drop(const std::string& file);
  // The same with a scene named in the options: "builtin:NAME" or a model's file.
  void open_scene(const std::string& name);
  // Once: the file, and the settings with it, when all of it has been read.
  struct Opened {
    std::string file;
    Settings settings;
    bool whole;  // the view that is looked at is the file's, too
  };
  std::optional<Opened> take_opened(const Settings&);
  void finish_loading() {
    while (loader_.loading()) arrive(true, LightSource::scene);
  }  // for tests and the first frame
  void say(std::string message) { message_ = std::move(message), failed_ = false; }
  void fail(std::string message) { message_ = std::move(message), failed_ = true; }

  // Is there more to come without any input: an answer under way, a smaller picture to be replaced, a study that runs?
  bool busy() const { return drawing() || measures_more(); }
  bool shaders_saved() const;  // since they were read last

 private:
  bool drawing() const {
    return comparer_.waiting() || waiting_ || moving_ || truth_waiting_ || stats_waiting_ || account_waiting_ ||
           loader_.loading();
  }
  bool measures_more() const;
  bool scene_ready(const Settings&);
  void arrive(bool wait, LightSource lights);  // lights: those shown in the scene, unless it was dropped
  void draw_frame(const Settings&, bool moving);
  void count_pairs();
  void draw_truth(const Settings&, const ui::Requests&, bool all);
  void take_stats(const ui::Requests&);
  void ask_stats(View);
  void work_out_account(const ui::Requests&);
  void draw_locked(const ui::Requests&, bool all);
  void draw_outside(const ui::Requests&);
  void ask_numbers(const ui::Requests&, bool all);
  void draw_views(const Settings&, const ui::Requests&, bool all);
  void reload();
  Settings affordable(const Settings&, bool moving);
  bool could_be_larger(const Settings&) const;

  Lab& lab_;
  Comparer comparer_;
  struct Outside {
    ui::OutsideRequest asked;
    gl::Texture depth;
    Canvas picture;
  };
  std::optional<Outside> outside_;
  struct Locked {
    LookOf look;
    Canvas picture;
  };
  std::vector<Locked> locked_;
  std::vector<std::unique_ptr<BackgroundJob>> jobs_;
  SceneLoader loader_;
  void begin(FileOpening);
  std::optional<FileOpening> opening_;
  bool opened_ = false;            // all that it needs has been read
  std::string refused_;            // a scene that cannot be read
  std::optional<Settings> asked_;  // of the last attempt, drawn or refused; empty: to be drawn anew
  bool count_due_ = false;         // of the frame drawn last: how many pairs
  bool waiting_ = false, moving_ = false, draw_failed_ = false, measuring_ = false;
  bool truth_waiting_ = false;                  // a visible view still waits for the reference
  bool stats_pending_ = false;                  // of the error view
  std::array<bool, kViewCount> fresh_{};        // views that show the frame drawn last
  std::array<bool, kViewCount> asked_stats_{};  // of the frame drawn last
  bool stats_waiting_ = false;                  // of a visible view
  std::array<bool, kViewCount> drawn_now_{};    // in this frame
  Settings::View view_drawn_;
  bool laid_over_ = true;                // overlays are drawn
  std::optional<PixelAccount> account_;  // of probe_
  bool account_waiting_ = false;
  std::optional<ui::PixelNumbers> numbers_;
  std::optional<std::pair<View, PixelGrid>> numbers_asked_;
  std::optional<PixelProbe> probe_;
  std::optional<glm::ivec2> probe_asked_;
  std::string message_, banner_;
  bool failed_ = false;  // the message is an error
  long long shaders_ = 0;
};

}  // namespace gbl
