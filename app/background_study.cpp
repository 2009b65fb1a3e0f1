#include "app/background_study.h"

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/study/study.h"
#include "renderer/study/study_here.h"

namespace gbl {
namespace {

constexpr size_t kKeptTruths = 6;  // of 14 MB each: a study may go through light counts in its inner loop
constexpr size_t kMostRuns = 16;   // studies with their truths; the oldest goes
constexpr size_t kMostTried = 64;  // set-ups tried by hand; the oldest goes
constexpr int kTimedFrames = 9;    // an odd number has a median of its own; more would double the wait
constexpr const char* kByHand = "by-hand";

}  // namespace

BackgroundStudy::BackgroundStudy(Lab& lab) : lab_(lab) { shown_.size = kBackgroundSize; }

bool BackgroundStudy::Run::fits(const Settings& s) const { return same_truth_but(truth, s, varied); }

void BackgroundStudy::forget() {
  give_up();
  running_ = nullptr;
  runs_.clear();
  tried_.clear();
  bench_.reset();
  note_.clear();
  changed_ = true;
}

void BackgroundStudy::give_up() {
  if (bench_) bench_->stop();
  task_ = Task::none;
}

BackgroundStudy::Run* BackgroundStudy::run_here(const std::string& study, const Settings& now) {
  for (Run& run : runs_)
    if (run.study == study && run.fits(now)) return &run;
  return nullptr;
}

// A broken file beside the program must not keep the chart from opening.
void BackgroundStudy::list_studies() {
  try {
    for (const BuiltinStudy& b : builtin_studies()) {
      const StudySpec spec = load_study(b.id);
      if (can_run_here(spec)) shown_.studies.push_back({b.id, b.label, spec.x, spec.y, spec.family});
    }
  } catch (const Error& e) {
    note_ = e.what();
    changed_ = true;
  }
}

BackgroundStudy::Run BackgroundStudy::make_run(const std::string& study, const Settings& now) const {
  const StudySpec spec = load_study(study);
  const auto scene = [this](const std::string&) { return scene_->shared_scene(); };
  return {study, now, varied_truth(spec), expand(study_here(spec, now, kBackgroundSize), scene, lab_.limits()), {}};
}

// Goes on where it was stopped; one that is complete is measured anew.
void BackgroundStudy::start(const std::string& study, const Settings& now) {
  if (now.scene != lab_.scene_name()) return;  // it is being read
  give_up();
  note_.clear();
  changed_ = true;
  running_ = run_here(study, now);
  if (running_ && running_->complete()) running_->rows.clear(), running_->spent_s = 0;
  if (running_) return;
  try {
    runs_.push_front(make_run(study, now));
    if (runs_.size() > kMostRuns) runs_.pop_back();
    if (!runs_.front().complete()) running_ = &runs_.front();  // complete: it has no case that can be drawn here
  } catch (const Error& e) {
    note_ = e.what();
  }
}

void BackgroundStudy::stop(const std::string& why) {
  note_ = fmt::format("{} stopped after {} of {}{}. R goes on.", running_->study, running_->rows.size(),
                      running_->plan.cases.size(), why);
  if (task_ == Task::study) give_up();
  running_ = nullptr;
  changed_ = true;
}

void BackgroundStudy::take(const ui::ChartRequest& asked, const Settings& now) {
  if (asked.open && shown_.studies.empty() && note_.empty()) list_studies();
  if (asked.study != study_) {
    study_ = asked.study;
    note_.clear();
    changed_ = true;
  }
  if (asked.run && !study_.empty()) start(study_, now);
  if (asked.stop && running_) stop("");
  if (running_ && !running_->fits(now))
    stop(fmt::format(": the truth has changed ({}); its rows come back with its own truth",
                     differing_truth(running_->truth, now, running_->varied)));
}

void BackgroundStudy::update(const Settings& now, const ui::Requests& requests, bool quiet) {
  const ui::ChartRequest& asked = requests.chart;
  if (scene_ != lab_.gpu_scene()) {
    scene_ = lab_.gpu_scene();
    forget();
  }
  if (!scene_) return;
  take(asked, now);
  if (asked.open || running_ || changed_) show(now);
  wanted_ = asked.open && !shown_.current && now.scene == lab_.scene_name();
  if (task_ == Task::at_hand && (!wanted_ || !(measured_.settings == as_measured(now)))) give_up();
  if (quiet) work(now);
  if (changed_) show(now);
  wanted_ = wanted_ && !shown_.current;
  shown_.measuring = wanted_;
}

// False: there is nothing to measure.
bool BackgroundStudy::begin_next(const Settings& now) {
  if (!wanted_ && !running_) return false;
  task_ = wanted_ ? Task::at_hand : Task::study;
  measured_ = wanted_ ? StudyCase{"tried by hand", as_measured(now), {}} : running_->plan.cases[running_->rows.size()];
  begun_s_ = now_s();
  require_valid(measured_.settings, lab_.limits());
  require_quick(measured_.settings, lab_, "chart", "measure it with `gbufferlab study`");
  if (!bench_) bench_.emplace(lab_.renderer(), lab_.cost(), lab_.machine(), kKeptTruths);
  bench_->start(measured_.settings, scene_, {.frames = kTimedFrames});
  return true;
}

// One step of one row. What goes wrong is that row's reason to have failed: the window goes on.
void BackgroundStudy::work(const Settings& now) {
  const auto study = [this] { return task_ == Task::study ? running_->study : std::string(kByHand); };
  try {
    if (task_ == Task::none && !begin_next(now)) return;
    if (bench_->step(false)) finish(measured_row(study(), measured_, bench_->row()));
  } catch (const std::exception& e) {
    if (bench_) bench_->stop();
    finish(failed_row(study(), measured_, e.what()));
  }
}

void BackgroundStudy::finish(StudyRow row) {
  Row done{std::move(row), measured_.settings};
  if (task_ == Task::study) {
    running_->rows.push_back(std::move(done));
    running_->spent_s += now_s() - begun_s_;
    if (running_->complete()) running_ = nullptr;
  } else {
    tried_.push_back(std::move(done));
    if (tried_.size() > kMostTried) tried_.erase(tried_.begin());
  }
  task_ = Task::none;
  changed_ = true;
}

std::string BackgroundStudy::words_for(const Run* run) const {
  if (!note_.empty()) return note_;
  if (!run) {
    size_t elsewhere = 0;
    for (const Run& other : runs_)
      if (other.study == study_) elsewhere += other.rows.size();
    return elsewhere == 0 ? "" : fmt::format("{} rows of this study belong to another truth: not shown.", elsewhere);
  }
  size_t impossible = 0;
  std::string reason;
  for (const LeftOut& l : run->plan.left_out)
    if (l.by == LeftOutBy::invalid && ++impossible == 1) reason = l.reason;
  return impossible == 0 ? "" : fmt::format("{} of its cases cannot be drawn here, the first: {}.", impossible, reason);
}

void BackgroundStudy::show_progress(const Run* run) {
  const Run* counted = running_ ? running_ : run;
  shown_.running = running_ ? running_->study : "";
  shown_.done = counted ? counted->rows.size() : 0;
  shown_.total = counted ? counted->plan.cases.size() : 0;
  shown_.seconds_left.reset();
  if (running_ && shown_.done > 0)
    shown_.seconds_left = counted->spent_s / double(shown_.done) * double(shown_.total - shown_.done);
  shown_.note = words_for(run);
}

void BackgroundStudy::show(const Settings& now) {
  const Settings at_hand = as_measured(now);
  if (!changed_ && at_hand == shown_for_) return;
  changed_ = false;
  shown_for_ = at_hand;
  shown_.rows.clear();
  shown_.settings.clear();
  shown_.current.reset();
  std::set<std::string> keys;
  const auto add = [&](const Row& done) {
    if (!keys.insert(done.row.key).second) return;  // also tried by hand
    if (done.settings == at_hand) shown_.current = shown_.rows.size();
    shown_.rows.push_back(done.row);
    shown_.settings.push_back(done.settings);
  };
  const Run* run = run_here(study_, now);
  if (run)
    for (const Row& row : run->rows) add(row);
  for (const Row& row : tried_)
    if (same_truth_but(row.settings, now, run ? run->varied : std::vector<std::string>{})) add(row);
  show_progress(run);
}

}  // namespace gbl
