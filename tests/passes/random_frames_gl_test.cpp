// Random frames over all axes, scenes, sizes and cameras; the slow test draws many more.
#include "tests/passes/random_frames.h"

#include "tests/shader_copy.h"

namespace gbl::test {
namespace {

class RandomFrames : public GlTest {
 protected:
  // In parts, so that they run side by side.
  void expect_part(uint64_t part) {
    const Tally t = expect_sound_frames(1 + 50 * part, 50);
    RecordProperty("judged", static_cast<int>(t.judged));
    EXPECT_GT(t.compared, 40u);
    EXPECT_GT(t.judged, 10000u) << "pixels with a surface";
  }
};

TEST_F(RandomFrames, TheFirstFiftyAreRight) { expect_part(0); }
TEST_F(RandomFrames, TheSecondFiftyAreRight) { expect_part(1); }
TEST_F(RandomFrames, TheThirdFiftyAreRight) { expect_part(2); }

// The judge itself: a method that is wrong is off the plain loop's picture, arithmetic that is wrong off the reference's.
TEST_F(RandomFrames, AFaultIsFound) {
  ShaderCopy copy;
  Framed frame{yard(), settings_for(yard()), View::final};
  frame.settings.lights.method = LightMethod::volumes_instanced;
  const auto wrong = [&] { return FrameJudge().judge(frame).wrong; };
  EXPECT_EQ(wrong(), "");
  copy.insert("shaders/light_volume.frag", "  if (!s.present) discard;",
              "  if (int(gl_FragCoord.x) % 3 == 0) discard;");
  EXPECT_NE(wrong().find("off the plain loop's"), std::string::npos) << wrong();
  copy.restore("shaders/light_volume.frag");
  copy.insert("shaders/shade.glsl", "lane arriving = arriving_share", "  light.colour *= 0.5;");
  EXPECT_EQ(wrong().find("off the plain loop's"), std::string::npos) << "both are";
  EXPECT_NE(wrong().find("off the reference"), std::string::npos) << wrong();
}

}  // namespace
}  // namespace gbl::test
