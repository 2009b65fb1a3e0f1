// The watch speaks where the catalogue's broken settings fail, and is silent where they are fixed or where it hides.
#include "renderer/study/pitfalls/watch.h"

#include <gtest/gtest.h>

#include "renderer/frame/frame_lights.h"
#include "renderer/opening/scene_look.h"
#include "renderer/study/pitfalls/catalogue.h"

namespace gbl {
namespace {

std::string watched_in(const PitfallEntry& e, PitfallSide side) {
  static std::map<std::string, std::shared_ptr<const Scene>> scenes;
  const Settings s = settings_of(e, side);
  auto& scene = scenes[s.scene];
  if (!scene) scene = open_scene(s.scene);
  const std::vector<Light> lights = lights_of(s, *scene);
  const std::optional<Watched> w = watched(s, lights, 16.0 / 9);
  return w ? w->pitfall : "";
}

TEST(Watch, NamesThePitfallsThatStateAloneTells) {
  for (const char* id :
       {"backface-cull-inside", "no-culling-doubles", "near-plane-cut", "circumscribe-without-inside-test",
        "far-plane-clips-backfaces", "flat-circle-undercovers", "circle-behind-camera", "fp16-world-position"}) {
    const PitfallEntry e = load_pitfall(id);
    EXPECT_EQ(watched_in(e, PitfallSide::broken), id);
    EXPECT_EQ(watched_in(e, PitfallSide::fixed), "") << id;
    if (e.blind) {
      EXPECT_EQ(watched_in(e, PitfallSide::blind), "") << id;
    }
  }
}

TEST(Watch, IsSilentWhereEverythingIsSound) {
  for (const PitfallEntry& e : load_pitfalls()) {
    const Settings s = settings_of(e, PitfallSide::fixed);
    if (sound(s)) {
      EXPECT_EQ(watched_in(e, PitfallSide::fixed), "") << e.id;
    }
  }
}

TEST(Watch, SaysWhichLight) {
  const PitfallEntry e = load_pitfall("near-plane-cut");
  const Settings s = settings_of(e, PitfallSide::broken);
  const std::vector<Light> lights = lights_of(s, *open_scene(s.scene));
  EXPECT_EQ(watched(s, lights, 16.0 / 9)->sentence, "light 37: the near plane cuts it");
}

}  // namespace
}  // namespace gbl
