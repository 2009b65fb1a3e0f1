#include "app/viewer.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/resources.h"
#include "renderer/base/size_text.h"

namespace gbl {
namespace {

constexpr double kStillBudgetMs = 2000;  // a frame predicted longer is drawn smaller, with a banner
constexpr double kMovingBudgetMs = 33;   // while something moves, a frame predicted longer is drawn at half size
constexpr double kMaxLitTests = 2e8;     // pairs_lit is a loop over all lights: above this the window leaves it out

// What decides the views: zoom and centre only decide which part of them is seen.
Settings::View drawn_part(Settings::View v) {
  v.zoom = 1, v.centre = {}, v.main.clear();
  return v;
}

// What decides the picture, without what only decides which pictures are looked at.
Settings without_view(Settings s) {
  s.view = {};
  return s;
}

}  // namespace

Settings Viewer::affordable(const Settings& s, bool moving) {
  Settings out = s;
  const std::shared_ptr<const ResolvedFrame> frame = lab_.resolve(s);
  const double predicted = lab_.cost().predict_ms(*frame);
  if (moving && predicted > kMovingBudgetMs && lab_.device().software) out.size = glm::max(s.size / 2, glm::ivec2(1));
  const glm::ivec2 size = lab_.cost().affordable_size(*frame, out.size, kStillBudgetMs);
  banner_ =
      size == out.size ? "" : fmt::format("predicted {:.1f} s a frame: drawn at {}", predicted / 1000, size_text(size));
  out.size = size;
  return out;
}

// A picture that was made smaller than it need be, as its times have shown. By a little it is not drawn again.
bool Viewer::could_be_larger(const Settings& s) const {
  if (banner_.empty() || waiting_ || moving_ || draw_failed_) return false;
  const glm::ivec2 size = lab_.cost().affordable_size(*lab_.resolve(s), s.size, kStillBudgetMs);
  return size == s.size || size.x >= 1.5 * lab_.drawn().size.x;
}

void Viewer::arrive(bool wait, LightSource lights) {
  try {
    if (auto scene = loader_.take(wait)) {
      const bool dropped = opening_ && loader_.name() == opening_->scene;
      say(fmt::format("{}: {} objects", loader_.name(), scene->instances.size()));
      const std::vector<std::string> notes = notes_of(*scene, dropped ? LightSource::scene : lights);
      for (const std::string& note : notes) message_ += "; " + note;
      if (notes.empty() && !dropped) message_.clear();
      lab_.show(loader_.name(), std::move(scene));
      asked_.reset();
      if (dropped && !opening_->said.empty()) say(opening_->said);
      opened_ = opened_ || dropped;
    }
  } catch (const Error& e) {
    if (e.code() != ExitCode::interrupted) fail(e.what());
    refused_ = loader_.name();
    if (!opened_) opening_.reset();
  }
}

void Viewer::begin(FileOpening opening) {
  if (opening.scene.empty() && loader_.loading()) {
    fail(fmt::format("{}: {} is still being read; open this one again then", opening.file, loader_.name()));
    return;
  }
  opening_ = std::move(opening);
  opened_ = opening_->scene.empty() || (opening_->whole && opening_->scene == lab_.scene_name() && !loader_.loading());
  if (opened_)
    say(opening_->said);
  else
    loader_.start(opening_->scene);
}

void Viewer::drop(const std::string& file) {
  try {
    begin(opening_of(file, lab_.limits()));
  } catch (const Error& e) {
    fail(e.what());
  }
}

void Viewer::open_scene(const std::string& name) { begin(scene_opening(name)); }

std::optional<Viewer::Opened> Viewer::take_opened(const Settings& s) {
  if (!opened_) return {};
  opened_ = false;
  const FileOpening opening = *std::exchange(opening_, std::nullopt);
  try {
    Settings settings = opening.settings(s, lab_.scene());
    require_valid(settings, lab_.limits());
    return Opened{opening.file, std::move(settings), opening.whole};
  } catch (const Error& e) {
    fail(e.what());
    return {};
  }
}

// Is the scene that these settings name the one on the GPU? Else sees to it that it will be.
bool Viewer::scene_ready(const Settings& s) {
  arrive(false, s.lights.source);
  if (s.scene == lab_.scene_name()) {
    refused_.clear();
    return true;
  }
  if (!loader_.loading() && s.scene != refused_ && !opened_) loader_.start(s.scene);
  return false;
}

void Viewer::draw_frame(const Settings& s, bool moving) {
  asked_ = s;
  try {
    lab_.draw(affordable(s, moving));
    fresh_.fill(false);
    probe_asked_.reset();
    waiting_ = count_due_ = !moving;
    if (std::exchange(draw_failed_, false)) say("");  // what was wrong has been fixed
  } catch (const Error& e) {
    fail(e.what());
    draw_failed_ = true;
    fresh_.fill(false);  // the frame before was drawn again
  }
}

void Viewer::count_pairs() {
  count_due_ = false;
  const glm::dvec2 size = lab_.drawn().size;
  lab_.count_pairs(size.x * size.y * lab_.report().light_count <= kMaxLitTests);
}

// The reference takes a second or more: its views appear when it is there, and the window goes on meanwhile. Nothing
// is begun while something moves: it would be given up at the next frame.
void Viewer::draw_truth(const Settings& s, const ui::Requests& requests, bool all) {
  bool wanted = requests.account, complete = true;
  for (const View view : {View::reference, View::error}) {
    bool& fresh = fresh_[static_cast<size_t>(view)];
    if (!requests.visible[static_cast<size_t>(view)] || !why_missing(view, lab_.drawn()).empty()) continue;
    wanted = true;
    if (moving_) continue;
    if (all || !fresh || !(drawn_part(s.view) == drawn_part(view_drawn_))) {
      lab_.look_at(s.view);
      fresh = lab_.draw_truth_view(view, false);
      drawn_now_[static_cast<size_t>(view)] |= fresh;
      stats_pending_ |= fresh && view == View::error;
    }
    complete &= fresh;
  }
  if (!wanted || moving_) lab_.stop_truth();
  if (stats_pending_ && lab_.take_error_stats()) stats_pending_ = false;
  truth_waiting_ = wanted && !moving_ && (!complete || stats_pending_);
}

// What the colours and the histogram of a view are made from arrives some frames later; the view is then drawn again.
void Viewer::take_stats(const ui::Requests& requests) {
  stats_waiting_ = false;
  for (int v = 0; v < kViewCount; ++v) {
    const View view = static_cast<View>(v);
    const bool over = find_overlay(lab_.drawn().view.overlays, row(view).id) != nullptr;
    if (lab_.take_stats(view) && follows_picture(view, lab_.drawn().view))
      fresh_[over ? static_cast<size_t>(view_by_id(lab_.drawn().view.main).view) : static_cast<size_t>(v)] = false;
    stats_waiting_ |= (requests.visible[v] || over) && lab_.stats_pending(view);
  }
}

// Once for each frame.
void Viewer::ask_stats(View view) {
  if (needs_truth(view) || !why_missing(view, lab_.drawn()).empty()) return;
  if (std::exchange(asked_stats_[static_cast<size_t>(view)], true)) return;
  lab_.ask_stats(view);
  stats_waiting_ = true;
}

void Viewer::draw_views(const Settings& s, const ui::Requests& requests, bool all) {
  // A difference is one of what lies below the overlays.
  const bool laid_over =
      !(requests.compare && requests.compare->difference && row(requests.compare->view).id == s.view.main);
  const bool overlays_changed = !(drawn_part(s.view) == drawn_part(view_drawn_)) || s.view.main != view_drawn_.main ||
                                std::exchange(laid_over_, laid_over) != laid_over;
  if (all) asked_stats_.fill(false);
  take_stats(requests);
  for (int v = 0; v < kViewCount; ++v) {
    const View view = static_cast<View>(v);
    const bool looks_changed = look_of(s.view.looks, row(view).id) != look_of(view_drawn_.looks, row(view).id);
    const bool main = row(view).id == s.view.main, was_main = row(view).id == view_drawn_.main;
    const bool stale = all || !fresh_[v] || looks_changed || ((main || was_main) && overlays_changed);
    if (needs_truth(view) || !requests.visible[v] || !stale || !why_missing(view, lab_.drawn()).empty()) continue;
    lab_.look_at(s.view);
    lab_.draw_view(view, {.overlays = main && laid_over});
    fresh_[v] = drawn_now_[v] = true;
    if (main || follows_picture(view, s.view)) ask_stats(view);
  }
  for (const Overlay& o : s.view.overlays) ask_stats(view_by_id(o.view).view);
  draw_truth(s, requests, all);
  view_drawn_ = s.view;
}

// First the truth, then how often its lights were shaded, one in each frame: a pass of its own each.
void Viewer::work_out_account(const ui::Requests& requests) {
  account_waiting_ = requests.account && requests.probe && !moving_;
  if (!requests.account) account_.reset();
  if (!account_waiting_ || !probe_ || probe_->pixel != requests.probe) return;
  try {
    if (!account_) account_ = lab_.account(*probe_, false);
    if (!account_) return;
    if (!lab_.shades_pixels()) {
      account_waiting_ = false;
      return;
    }
    const auto first =
        std::find_if(account_->lights.begin(), account_->lights.end(), [](const LightShare& l) { return !l.shaded; });
    account_waiting_ = first != account_->lights.end() &&
                       first - account_->lights.begin() < static_cast<std::ptrdiff_t>(kCountedLights);
    if (account_waiting_) first->shaded = lab_.times_shaded(account_->pixel, {first->index}).front();
  } catch (const Error& e) {
    fail(e.what());
    account_waiting_ = false;
  }
}

void Viewer::ask_numbers(const ui::Requests& requests, bool all) {
  if (auto values = lab_.take_numbers()) numbers_ = {numbers_asked_->first, numbers_asked_->second, std::move(*values)};
  if (!requests.numbers) numbers_.reset(), numbers_asked_.reset();
  if (!requests.numbers || (!all && numbers_asked_ == requests.numbers)) return;
  numbers_asked_ = requests.numbers;
  lab_.ask_numbers(numbers_asked_->first, numbers_asked_->second);
}

// Each is drawn in its look and copied; the view's own picture is drawn again when it is looked at next.
void Viewer::draw_locked(const ui::Requests& requests, bool all) {
  const std::vector<LookOf>& wanted = requests.locked;
  bool same = locked_.size() == wanted.size() && !all;
  for (size_t i = 0; i < wanted.size() && same; ++i) same = locked_[i].look == wanted[i];
  if (same) return;
  locked_.clear();
  const Settings::View own = lab_.drawn().view;
  for (const LookOf& l : wanted) {
    const View view = view_by_id(l.view).view;
    if (!why_missing(view, lab_.drawn()).empty()) {
      locked_.push_back({l, {}});
      continue;
    }
    Settings::View looked = own;
    set_look(looked.looks, l.view, l.look);
    lab_.look_at(looked);
    lab_.draw_view(view);
    locked_.push_back({l, lab_.copy_of(view)});
    fresh_[static_cast<size_t>(view)] = false;
  }
  lab_.look_at(own);
}

// Drawn again when the frame is another one or the camera outside has moved.
void Viewer::draw_outside(const ui::Requests& requests) {
  if (!requests.outside) return outside_.reset();
  const ui::OutsideRequest& wanted = *requests.outside;
  if (outside_ && outside_->asked == wanted && !drawn_now_[static_cast<size_t>(wanted.colours)]) return;
  if (!outside_ || outside_->picture.texture.size != wanted.size) {
    outside_.emplace();
    outside_->depth = gl::make_texture({.size = wanted.size, .format = Format::d32f, .label = "outside.depth"});
    outside_->picture = make_canvas({.size = wanted.size, .label = "outside"}, &outside_->depth);
  }
  outside_->asked = wanted;
  lab_.draw_outside({wanted.from, wanted.size}, wanted.colours, outside_->picture);
}

void Viewer::reload() {
  try {
    lab_.reload_shaders();
    for (const auto& job : jobs_) job->forget();
    say("shaders read again");
    asked_.reset();
  } catch (const Error& e) {
    fail(e.what());  // the last good programs go on drawing
  }
}

bool Viewer::shaders_saved() const { return shaders_ != 0 && shaders_stamp() != shaders_; }

void Viewer::update(const Settings& s, const ui::Requests& requests, bool moving) {
  const long long stamp = shaders_stamp();
  const bool saved = shaders_ != 0 && stamp != shaders_;
  shaders_ = stamp;
  if (saved || requests.reload_shaders) reload();
  const bool settled = moving_ && !moving;  // drawn again in full size, and counted
  moving_ = moving;
  const bool changed = !asked_ || !(without_view(s) == without_view(*asked_)) || settled;
  const bool ready = scene_ready(s);
  const bool anew = ready && (changed || could_be_larger(s));
  const bool count_now = count_due_ && !anew;  // the picture is on screen by then
  if (anew) draw_frame(s, moving);
  if (!lab_.has_drawn()) return;
  try {
    if (count_now) count_pairs();
    drawn_now_.fill(false);
    draw_locked(requests, anew);
    draw_views(s, requests, anew);
    comparer_.update(requests.compare, requests.compare && drawn_now_[static_cast<size_t>(requests.compare->view)],
                     fresh_[static_cast<size_t>(View::reference)]);
    draw_outside(requests);
    lab_.show_squares(requests.magnified);
    ask_numbers(requests, anew);
    if (requests.probe && requests.probe != probe_asked_) {
      lab_.start_probe(*requests.probe);
      probe_asked_ = requests.probe;
    }
  } catch (const Error& e) {
    fail(e.what());
  }
  lab_.collect(false);
  waiting_ = waiting_ && !lab_.report().pairs;
  if (auto p = lab_.take_probe()) {
    probe_ = p;
    account_.reset();
  }
  if (!requests.probe) probe_.reset(), probe_asked_.reset(), account_.reset();
  work_out_account(requests);
}

bool Viewer::measures_more() const {
  return std::any_of(jobs_.begin(), jobs_.end(), [](const auto& job) { return job->busy(); });
}

void Viewer::measure(const Settings& s, const ui::Requests& requests, bool quiet) {
  bool free = quiet && !drawing();
  measuring_ = free;
  for (const auto& job : jobs_) {
    job->update(s, requests, free);
    free = free && !job->busy();
  }
  measuring_ = measuring_ && measures_more();
}

ui::Input Viewer::input(double seconds) const {
  ui::Input in = ui_input(lab_);
  in.probe = probe_;
  in.account = account_ ? &*account_ : nullptr;
  in.compare = comparer_.input();
  for (const Locked& l : locked_) in.locked.push_back({l.picture.texture.id(), l.picture.texture.size});
  if (outside_) in.outside = {outside_->picture.texture.id(), outside_->picture.texture.size};
  in.numbers = numbers_ ? &*numbers_ : nullptr;
  for (const auto& job : jobs_) job->fill(in);
  in.truth_progress = lab_.truth_progress();
  in.message = message_;
  in.message_is_error = failed_;
  in.banner = loader_.loading()  ? fmt::format("reading {}: {}", loader_.name(), loader_.progress())
              : !banner_.empty() ? banner_
              : !lab_.doubts().empty()
                  ? fmt::format("this device, with these shaders: {}; numbers may be wrong", lab_.doubts().front())
                  : "";
  in.seconds = seconds;
  return in;
}

}  // namespace gbl
