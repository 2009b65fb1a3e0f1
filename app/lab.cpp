#include "app/lab.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/calibration.h"
#include "renderer/base/threads.h"
#include "renderer/opening/scene_look.h"
#include "renderer/passes/float_rows.h"
#include "renderer/truth/ties.h"

namespace gbl {

namespace {

// Weighed as on this device from its first frame on.
gl::Device weighed(gl::Device device) {
  std::string trouble;
  use_work_weights(weights_for(calibration_file(), device, trouble));
  if (!trouble.empty()) fmt::print(stderr, "gbufferlab: {}\n", trouble);
  return device;
}

}  // namespace

Lab::Lab(FeatureSet without)
    : device_(weighed(gl::probe_device(without))),
      cost_(device_.software),
      formats_(format_file(), device_),
      truths_(1, std::max(1, all_processors() - 1)) {}

void Lab::open(const std::string& name) {
  if (name != scene_name_) show(name, open_scene(name));
}

void Lab::show(const std::string& name, std::shared_ptr<const Scene> scene) {
  gpu_scene_ = std::make_shared<GpuScene>(std::move(scene));
  truths_.forget();
  meter_.forget();
  scene_name_ = name;
}

void Lab::draw(const Settings& s) {
  require_valid(s, limits());
  open(s.scene);
  formats_.check(resolve(s)->settings);
  static const FrameReport kNothingDrawn;  // of a temporary GCC 12 thinks at -O3 that its strings are never made
  try {
    report_ = renderer_.render(s, *gpu_scene_, targets_);
  } catch (...) {  // a shader that does not compile, a refused texture: the targets hold half a frame
    if (has_drawn() && drawn_.scene == scene_name_)
      renderer_.render(drawn_, *gpu_scene_, targets_);
    else
      report_ = kNothingDrawn;
    throw;
  }
  drawn_ = s;
  work_[work_index(targets_.timers.frame())] = {targets_.drawn->settings.lights.method, targets_.drawn->light_work};
}

void Lab::reload_shaders() {
  renderer_.reload_shaders();
  formats_ = FormatKeeper(format_file(), device_);
}

const std::vector<Light>& Lab::lights() const {
  static const std::vector<Light> none;
  return targets_.drawn ? targets_.drawn->lights : none;
}

void Lab::draw_view(View view, ViewOptions options) {
  options.stats = meter_.of(view);
  options.stats_of = [this](View v) { return meter_.of(v); };
  renderer_.draw_view(view, drawn_, *gpu_scene_, targets_, options);
}

void Lab::measure_now(View view) {
  if (needs_truth(view) || !why_missing(view, drawn_).empty()) return;
  ask_stats(view);
  meter_.take(view, true);
}

void Lab::draw_measured_view(View view, const ViewOptions& options) {
  if (follows_picture(view, drawn_.view)) measure_now(view);
  if (options.overlays)
    for (const Overlay& o : drawn_.view.overlays) measure_now(view_by_id(o.view).view);
  draw_view(view, options);
}

std::vector<glm::vec4> Lab::numbers_of(View v) {
  ViewOptions options;
  std::shared_ptr<const TruthSet> truth;
  if (needs_truth(v)) {
    truth = truths_.get(renderer_, *gpu_scene_, drawn_, true);
    options.truth = &truth->textures;
    if (v == View::error) renderer_.draw_errors(drawn_, *gpu_scene_, targets_, truth->textures);
    judged_by_ = truth;
  }
  renderer_.draw_numbers(v, drawn_, *gpu_scene_, targets_, {{0, 0}, {1, 1}, drawn_.size}, options);
  return rows_from_top<glm::vec4>(drawn_.size, gl::read_rgba32f(targets_.canvases.numbers().texture));
}

void Lab::ask_numbers(View v, const PixelGrid& pixels) {
  renderer_.draw_numbers(v, drawn_, *gpu_scene_, targets_, pixels);
  numbers_.start(targets_.canvases.numbers().texture);
  numbers_asked_ = pixels.count;
}

std::optional<std::vector<glm::vec4>> Lab::take_numbers() {
  const std::vector<float>* floats = numbers_.take(false);
  if (!floats) return {};
  return rows_from_top<glm::vec4>(numbers_asked_, *floats);
}

std::optional<PixelAccount> Lab::account(const PixelProbe& probe, bool wait) {
  const std::shared_ptr<const TruthSet> truth = truths_.get(renderer_, *gpu_scene_, drawn_, wait);
  if (!truth) return {};
  const size_t i =
      static_cast<size_t>(probe.pixel.y) * static_cast<size_t>(drawn_.size.x) + static_cast<size_t>(probe.pixel.x);
  const SeenSurface shown = renderer_.surface_at(drawn_, *gpu_scene_, targets_, probe.pixel);
  PixelAccount account = account_of(targets_.drawn->settings, *truth->scene, truth->texels[i], probe);
  account.shown = shown, account.tie = is_tie(truth->truth, i, shown);
  return account;
}

bool Lab::shades_pixels() const { return shading_of(report_.drawn.lights.method) != Shading::forward; }

std::vector<int> Lab::times_shaded(glm::ivec2 pixel, const std::vector<int>& lights) {
  return renderer_.times_shaded(lights, pixel, drawn_, *gpu_scene_, targets_);
}

bool Lab::draw_truth_view(View view, bool wait) {
  const std::shared_ptr<const TruthSet> truth = truths_.get(renderer_, *gpu_scene_, drawn_, wait);
  if (!truth) return false;
  const TruthTextures& textures = truth->textures;
  if (view == View::error) {
    renderer_.draw_errors(drawn_, *gpu_scene_, targets_, textures);
    judged_by_ = truth;
    if (wait) return take_error_stats(true);
  }
  const double range = error_stats_ ? error_stats_->range : 1;  // of the frame before, until this one's answer is here
  renderer_.draw_view(view, drawn_, *gpu_scene_, targets_, {.truth = &textures, .error_range = range});
  return true;
}

bool Lab::take_error_stats(bool wait) {
  const std::vector<float>* errors = targets_.reads.error.take(wait);
  if (!errors) return false;
  std::vector<float> marked = *errors;
  if (mark_ties(judged_by_->truth, marked)) gl::write_texels(targets_.canvases.errors().texture, marked.data());
  const Settings::View::Error& e = drawn_.view.error;
  error_stats_ = gbl::error_stats(e.of, drawn_.size, marked, e.range);
  renderer_.draw_view(View::error, drawn_, *gpu_scene_, targets_, {.error_range = error_stats_->range});
  return true;
}

void Lab::collect(bool wait) {
  renderer_.collect(targets_, report_, wait);
  const long long answered = targets_.timers.answered();
  if (answered == learnt_ || report_.time_source == "cpu-clock") return;
  learnt_ = answered;  // the times may be of a frame or two ago: learnt with the work of that frame
  const Work& work = work_[work_index(answered)];
  for (const PassTime& p : report_.passes)
    if (p.pass == "lighting" && p.ms) cost_.learn(work.method, work.units, *p.ms);
}

Image Lab::image_of(View view) const {
  const gl::Texture& t = targets_.canvases.drawn_view(view)->texture;
  return image_from_gl_rows(t.size, gl::read_rgba8(t));
}

ui::ViewImage Lab::handle_of(View view) const {
  const Canvas* canvas = targets_.canvases.drawn_view(view);
  return canvas ? ui::ViewImage{canvas->texture.id(), canvas->texture.size} : ui::ViewImage{};
}

Canvas Lab::copy_of(View view, bool squares) const { return copied(*targets_.canvases.drawn_view(view), squares); }

void count_lights(Lab& lab, PixelAccount& account, size_t most) {
  if (!lab.shades_pixels()) return;
  std::vector<int> lights;
  for (size_t i = 0; i < std::min(account.lights.size(), most); ++i) lights.push_back(account.lights[i].index);
  const std::vector<int> times = lab.times_shaded(account.pixel, lights);
  for (size_t i = 0; i < times.size(); ++i) account.lights[i].shaded = times[i];
}

ui::Input ui_input(const Lab& lab) { return ui_input(lab, lab.report()); }

ui::Input ui_input(const Lab& lab, const FrameReport& report) {
  ui::Input input{.scene = lab.scene(), .lights = lab.lights(), .features = lab.device().features, .report = report};
  for (int v = 0; v < kViewCount; ++v) input.images[v] = lab.handle_of(static_cast<View>(v));
  for (int v = 0; v < kViewCount; ++v) input.stats[v] = lab.stats_of(static_cast<View>(v));
  input.error = lab.error_stats();
  return input;
}

}  // namespace gbl
