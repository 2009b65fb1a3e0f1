#include "app/pitfall_pictures.h"

#include <algorithm>

#include "renderer/opening/scene_look.h"

namespace gbl {

void PitfallPictures::forget() {
  todo_.clear(), next_ = 0;
  shown_.clear(), canvases_.clear();
  let_go();
}

void PitfallPictures::let_go() { scene_.reset(), scene_name_.clear(), targets_.reset(); }

// A scene is uploaded once for all entries that show it.
void PitfallPictures::make_list() {
  for (PitfallEntry& e : load_pitfalls())
    for (const PitfallSide side : {PitfallSide::broken, PitfallSide::fixed}) todo_.push_back({e, side});
  std::stable_sort(todo_.begin(), todo_.end(), [](const Todo& a, const Todo& b) {
    return settings_of(a.entry, a.side).scene < settings_of(b.entry, b.side).scene;
  });
}

void PitfallPictures::draw(const Todo& todo) {
  Settings s = settings_of(todo.entry, todo.side);
  s.size = ui::kPitfallPicture;
  if (!validate(s, lab_.limits()).empty()) return;  // to open it says why
  if (scene_name_ != s.scene) scene_ = std::make_shared<GpuScene>(open_scene(s.scene)), scene_name_ = s.scene;
  const View wanted = view_by_id(s.view.main).view, view = needs_truth(wanted) ? View::final : wanted;
  if (!targets_) targets_ = std::make_unique<Targets>();
  Renderer& renderer = lab_.renderer();
  renderer.render(s, *scene_, *targets_);
  if (!why_missing(view, targets_->drawn->settings).empty()) return;
  renderer.draw_view(view, s, *scene_, *targets_, {.overlays = true});
  canvases_.push_back(copied(*targets_->canvases.drawn_view(view)));
  ui::PitfallPicture& picture = shown_[todo.entry.id];
  (todo.side == PitfallSide::broken ? picture.broken : picture.fixed) = canvases_.back().texture.id();
}

void PitfallPictures::update(const Settings&, const ui::Requests& requests, bool quiet) {
  open_ = requests.pitfall.list;
  if (!open_ || !quiet) return;
  try {
    if (todo_.empty()) make_list();
    if (next_ < todo_.size()) draw(todo_[next_++]);
  } catch (const std::exception&) {  // an entry that cannot be drawn has no picture; to open it says why
  }
  if (next_ == todo_.size()) let_go();
}

}  // namespace gbl
