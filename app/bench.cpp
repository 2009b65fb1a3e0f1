#include "app/bench.h"

#include <chrono>
#include <cmath>
#include <ctime>

#include "app/lab.h"

namespace gbl {
namespace {

constexpr double kCountOnlyMs = 60000;  // a frame predicted longer than this is counted, not timed

Display display_of(const Settings& s) { return {s.exposure, s.colour}; }

double cpu_s() { return double(std::clock()) / CLOCKS_PER_SEC; }  // of all threads, a driver's too

}  // namespace

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void Bench::start(const Settings& s, std::shared_ptr<const GpuScene> scene, BenchWishes wishes) {
  stop();
  if (scene_ != scene) truths_.forget();
  settings_ = s, scene_ = std::move(scene), wishes_ = wishes;
  truth_.reset();
  timing_ = {}, errors_ = {}, report_ = {}, drawn_ = {};
  if (cost_.predict_ms(*renderer_.resolve(s, *scene_)) > kCountOnlyMs && !wishes_.all_frames) wishes_.times = false;
  phase_ = wishes_.errors ? Phase::truth : wishes_.times ? Phase::warm_up : Phase::judge;
}

void Bench::stop() {
  truths_.stop();
  phase_ = Phase::done;
}

bool Bench::step(bool wait) {
  do switch (phase_) {
      case Phase::truth:
        truth_ = truths_.get(renderer_, *scene_, settings_, wait);
        if (truth_) phase_ = wishes_.times ? Phase::warm_up : Phase::judge;
        break;
      case Phase::warm_up:  // programs are compiled, targets made
        report_ = renderer_.render(settings_, *scene_, targets_);
        renderer_.collect(targets_, report_, true);
        begun_s_ = now_s(), slowest_s_ = 0;
        phase_ = Phase::times;
        break;
      case Phase::times:
        time_a_frame();
        if (timing_.frames >= wishes_.frames ||
            (!wishes_.all_frames && measured_enough(timing_.frames, now_s() - begun_s_, slowest_s_)))
          phase_ = Phase::judge;
        break;
      case Phase::judge:
        judge();
        phase_ = Phase::done;
        break;
      case Phase::done: return true;
    }
  while (wait && phase_ != Phase::done);
  return phase_ == Phase::done;
}

void Bench::time_a_frame() {
  glFinish();                           // what a window has asked for in between is not this frame's work
  targets_.clusters.clusters.forget();  // as if the camera had moved
  const double begin = now_s(), cpu_begin = cpu_s();
  report_ = renderer_.render(settings_, *scene_, targets_);
  const double submitted = now_s();
  glFinish();
  const double end = now_s(), cpu_end = cpu_s();
  renderer_.collect(targets_, report_, true);
  slowest_s_ = std::max(slowest_s_, end - begin);
  ++timing_.frames;
  timing_.pass_ms["wall"].push_back((end - begin) * 1e3);
  timing_.pass_ms["upload"].push_back(report_.upload_ms);
  timing_.pass_ms["submission"].push_back((submitted - begin) * 1e3);
  timing_.pass_ms["cpu"].push_back((cpu_end - cpu_begin) * 1e3);
  double total = 0;
  for (const PassTime& p : report_.passes) {
    if (!p.ms) continue;
    timing_.pass_ms[p.pass].push_back(*p.ms);
    total += *p.ms;
  }
  timing_.pass_ms["total"].push_back(total);
}

void Bench::judge() {
  report_ = renderer_.render(settings_, *scene_, targets_);
  if (!wishes_.columns) {
    if (truth_) drawn_.lit = read_lit(targets_);
    return;
  }
  // The reference has counted the pairs that are lit; without one the GPU does.
  const bool count_lit = !truth_ && double(settings_.size.x) * settings_.size.y * report_.light_count <= kMostLitTests;
  renderer_.count_pairs(settings_, *scene_, targets_, count_lit);
  renderer_.collect(targets_, report_, true);
  if (!truth_) return;
  if (report_.pairs) report_.pairs->lit = truth_->lit_pairs;
  drawn_ = read_drawn(renderer_, report_.drawn, *scene_, targets_, true);
  errors_ = measure(truth_->truth, drawn_, display_of(settings_));
}

MeasuredColumns Bench::row() const { return {cells_of({report_, errors_, timing_, machine_}), report_.drawn}; }

Image Bench::picture() {
  renderer_.render(settings_, *scene_, targets_);  // judging left a frame without lights
  renderer_.draw_view(View::final, settings_, *scene_, targets_);
  const gl::Texture& t = targets_.canvases.drawn_view(View::final)->texture;
  return image_from_gl_rows(t.size, gl::read_rgba8(t));
}

Thumbnails Bench::thumbnails() { return make_thumbnails(picture(), truth_->truth, drawn_.lit, display_of(settings_)); }

double Bench::total_ms() const {
  const auto total = timing_.pass_ms.find("total");
  return total == timing_.pass_ms.end() ? INFINITY : spread_of(total->second).median;
}

BoundCheck Bench::bound(double display_difference) const {
  return check_bound(truth_->truth, drawn_.lit, truth_->witness_lit, display_of(settings_), display_difference);
}

}  // namespace gbl
