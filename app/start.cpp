#include "app/start.h"

#include "renderer/opening/scene_look.h"
#include "renderer/scenes/rig.h"

namespace gbl {

bool goes_on(const Arguments& a) {
  const bool says_what = a.scene || a.preset || a.state || a.rig || a.layout_file || a.camera || a.size || a.lights ||
                         a.seed || a.time || !a.set.empty();
  return !says_what && !a.fresh && is_remembered(a);
}

bool is_remembered(const Arguments& a) { return !a.present && a.lesson.empty() && a.pitfall.empty(); }

Start start_of(const Arguments& a, SessionKeeper& keeper, const LoadProgress* progress) {
  Start start{setup_of(a, progress), {}, nullptr};
  const std::optional<ui::Snapshot>& last = keeper.found().last;
  if (!last || !goes_on(a)) return start;
  try {
    if (!last->settings.lights.rig.empty()) rig_lights(last->settings.lights.rig);
    layout_of(last->settings);
    start.left_scene = open_scene(last->settings.scene, progress);
    start.left = last;
  } catch (const Error& e) {
    if (e.code() == ExitCode::interrupted) throw;  // the window was closed meanwhile
    keeper.put_aside(e.what());
  }
  return start;
}

}  // namespace gbl
