#include "app/background_warm_up.h"

#include "renderer/inspect/views.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/presets.h"

namespace gbl {
namespace {

constexpr glm::ivec2 kSize{32, 18};  // programs do not depend on it

}  // namespace

bool BackgroundWarmUp::done() const {
  return next_.preset >= presets().size() || !lab_.renderer().has_room_for_programs();
}

void BackgroundWarmUp::draw(const Settings& s) {
  require_valid(s, lab_.limits());
  if (s.scene != scene_name_ || !scene_) {
    scene_ = std::make_unique<GpuScene>(open_scene(s.scene));
    scene_name_ = s.scene;
  }
  // What `auto` chooses depends on the size: it is chosen at the window's.
  drawn_ = lab_.renderer().resolve(s, *scene_)->settings;
  drawn_.size = kSize, drawn_.view = s.view;
  if (!targets_) targets_ = std::make_unique<Targets>();
  lab_.renderer().render(drawn_, *scene_, *targets_);
}

// A view that cannot be shown or that nobody looks at costs nothing: the next that does is drawn.
void BackgroundWarmUp::draw_next(glm::ivec2 window_size, const ui::Requests& requests) {
  if (next_.view < 0) {
    Settings s = presets()[next_.preset].make();
    s.size = window_size;
    draw(s);
    next_.view = 0;
    return;
  }
  while (next_.view < kViewCount) {
    const View view = static_cast<View>(next_.view++);
    if (!requests.visible[static_cast<size_t>(view)] || needs_truth(view) || !why_missing(view, drawn_).empty())
      continue;
    lab_.renderer().draw_view(view, drawn_, *scene_, *targets_, {.overlays = row(view).id == drawn_.view.main});
    return;
  }
  next_ = {next_.preset + 1};
}

void BackgroundWarmUp::update(const Settings& now, const ui::Requests& requests, bool quiet) {
  if (quiet && !done()) work(now.size, requests);
  if (done()) scene_.reset(), targets_.reset();  // also where others have filled the cache
}

void BackgroundWarmUp::work(glm::ivec2 window_size, const ui::Requests& requests) {
  begun_ = true;
  try {
    draw_next(window_size, requests);
  } catch (const std::exception&) {  // this device cannot draw it, or there is no room: who chooses it is told why
    next_ = {next_.preset + 1};
  }
}

}  // namespace gbl
