// 2000 random settings: sound ones against the full-screen loop, and no setting at all makes GL complain.
#include "renderer/options/settings_json.h"
#include "tests/passes/all_pairs.h"

namespace gbl::test {
namespace {

class OnePictureSlow : public GlTest {};

TEST_F(OnePictureSlow, TwoThousandRandomSettings) {
  Pcg32 random(2026);
  int compared = 0;
  for (int k = 0; k < 2000; ++k) {
    Settings s = random_choices(random, {64, 36});
    s.lights.count = std::array{0, 1, 16, 64}[k % 4];
    s.lights.seed = random.next();
    s.camera.position = {random.in(2, 38), random.in(0.5, 12), random.in(2, 50)};
    SCOPED_TRACE(settings_text(s));
    Stage stage(yard());  // fresh programs: thousands of variants would fill the memory
    const Picture as_chosen = stage.lit(s);
    ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    for (const Option& o : options())  // unsound choices give way to the sound twin's, so that each run compares
      if (!sound(s) && o.group == Group::method && o.kind == Kind::choice)
        for (const ValueRow& r : o.values)
          if (!o.values[static_cast<size_t>(chosen(o, s))].sound() && r.sound()) o.set(s, r.id, o);
    if (!sound(s) || !validate(s, limits_here()).empty()) continue;
    s = comparable(s);
    EXPECT_TRUE(like(stage.lit(s), stage.lit(plain_twin(s)), same_picture(s)));
    ++compared;
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace gbl::test
