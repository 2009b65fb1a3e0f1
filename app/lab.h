#pragma once
// The renderer with its scene and targets: what window and headless commands both drive, so that they draw the same.
#include <array>
#include <memory>
#include <string>

#include "app/format_keeper.h"
#include "app/truth_keeper.h"
#include "app/view_meter.h"
#include "renderer/frame/estimate.h"
#include "renderer/frame/validate.h"
#include "renderer/gl/device.h"
#include "renderer/passes/frame.h"
#include "renderer/picture/image.h"
#include "renderer/study/rows/study_row.h"
#include "renderer/truth/error_stats.h"
#include "renderer/truth/pixel_account.h"
#include "ui/ui.h"

namespace gbl {

// pairs_lit is a full-screen loop over all lights: with more turns than this the commands leave it out.
inline constexpr double kMostLitTests = 4e9;

class Lab {
 public:
  explicit Lab(FeatureSet without);  // needs a current context

  DeviceLimits limits() const { return {device_.features, device_.max_size, device_.max_draw_buffers}; }
  const gl::Device& device() const { return device_; }
  const Scene& scene() const { return gpu_scene_->scene(); }
  std::shared_ptr<const GpuScene> gpu_scene() const { return gpu_scene_; }
  Renderer& renderer() { return renderer_; }
  Machine machine() const { return {device_.version, device_.renderer}; }
  FrameCost& cost() { return cost_; }

  void open(const std::string& name);  // nothing if it is open already; on an Error the old one stays
  void show(const std::string& name, std::shared_ptr<const Scene>);  // a scene opened elsewhere
  // What this device was found to store otherwise than the tables say, of the formats drawn so far: one clause each.
  const std::vector<std::string>& doubts() const { return formats_.doubts(); }
  const std::string& scene_name() const { return scene_name_; }
  // Validates, opens the scene, draws up to `lit`. On an Error nothing has changed.
  void draw(const Settings&);
  void look_at(const Settings::View& view) { drawn_.view = view; }  // what overlays are drawn; the frame stays
  // With what is known of its numbers: `measured` works that out first, and waits for it.
  void draw_view(View, ViewOptions = {});
  void draw_measured_view(View, const ViewOptions& = {});
  bool is_main(View v) const { return drawn_.view.main == row(v).id; }  // what overlays are laid over
  void ask_stats(View v) { meter_.ask(v, renderer_, drawn_, *gpu_scene_, targets_, {}); }
  bool take_stats(View v) { return meter_.take(v, false); }  // true: a new answer
  bool stats_pending(View v) const { return meter_.waiting(v); }
  const ViewStats* stats_of(View v) const { return meter_.of(v); }
  std::vector<glm::vec4> numbers_of(View);  // all of the frame, rows top to bottom; waits
  void ask_numbers(View, const PixelGrid&);
  std::optional<std::vector<glm::vec4>> take_numbers();               // rows top to bottom, once they are there
  void show_squares(bool on) { targets_.canvases.show_squares(on); }  // where pictures are magnified
  void count_pairs(bool lit_too) { renderer_.count_pairs(drawn_, *gpu_scene_, targets_, lit_too); }
  void start_probe(glm::ivec2 pixel) { renderer_.start_probe(drawn_, *gpu_scene_, targets_, pixel); }
  std::optional<PixelProbe> take_probe(bool wait = false) { return renderer_.take_probe(targets_, wait); }
  // Why the pixel of this probe looks as it does; nothing while the reference is being made. Lights are not counted.
  std::optional<PixelAccount> account(const PixelProbe&, bool wait);
  // Does the frame's method shade pixels? Forward shading shades surfaces, hidden ones too: no count of it says more.
  bool shades_pixels() const;
  std::vector<int> times_shaded(glm::ivec2 pixel, const std::vector<int>& lights);  // waits for the GPU
  void draw_outside(const OutsideView& v, View colours, const Canvas& into) {
    renderer_.draw_outside(v, colours, drawn_, *gpu_scene_, targets_, into);
  }
  // The views `reference` and `error` of the frame just drawn. False while the reference is being made.
  bool draw_truth_view(View, bool wait);
  double truth_progress() const { return truths_.progress(); }  // 0..1
  void stop_truth() { truths_.stop(); }
  const std::optional<ErrorStats>& error_stats() const { return error_stats_; }  // of the error view drawn last
  bool take_error_stats(
      bool wait = false);  // an answer of the error view has arrived: its colours are drawn with its range
  void collect(bool wait);
  void reload_shaders();  // what formats were checked with the old ones says nothing about the new

  bool has_drawn() const { return report_.size.x > 0; }
  const Settings& drawn() const { return drawn_; }
  const FrameReport& report() const { return report_; }
  const Targets& targets() const { return targets_; }
  const std::vector<Light>& lights() const;  // of the frame drawn last; none before the first
  std::shared_ptr<const ResolvedFrame> resolve(const Settings& s) { return renderer_.resolve(s, *gpu_scene_); }
  Image image_of(View) const;  // of the view drawn last; waits for the GPU
  ui::ViewImage handle_of(View) const;
  Canvas copy_of(View, bool squares = false) const;

 private:
  gl::Device device_;
  FrameCost cost_;
  FormatKeeper formats_;
  Renderer renderer_;
  std::string scene_name_;
  std::shared_ptr<const GpuScene> gpu_scene_;
  Targets targets_;
  Settings drawn_;
  FrameReport report_;
  TruthKeeper truths_;
  std::shared_ptr<const TruthSet> judged_by_;  // of the errors that are under way
  std::optional<ErrorStats> error_stats_;
  ViewMeter meter_;
  gl::AsyncRead numbers_;
  glm::ivec2 numbers_asked_{0};  // how many pixels

  void measure_now(View);

  // Of the frames whose times may still be under way: a ring by their numbers.
  static size_t work_index(long long frame) { return static_cast<size_t>(frame) % 8; }
  struct Work {
    LightMethod method{};
    double units = 0;
  };
  std::array<Work, 8> work_{};
  long long learnt_ = 0;
};

// How often the strongest lights of an account were shaded, into it.
void count_lights(Lab&, PixelAccount&, size_t most);

// What a panel reads, from what the lab has drawn.
ui::Input ui_input(const Lab&);
ui::Input ui_input(const Lab&, const FrameReport&);  // with another report of the same frame

}  // namespace gbl
