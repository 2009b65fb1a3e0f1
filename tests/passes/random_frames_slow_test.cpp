// Three thousand random frames, others each day; GBL_FRAMES=FIRST,COUNT draws the ones of a failure again.
#include <chrono>

#include "tests/passes/random_frames.h"

namespace gbl::test {
namespace {

class RandomFramesSlow : public GlTest {};

TEST_F(RandomFramesSlow, ThreeThousandOthersEachDay) {
  const auto today = std::chrono::duration_cast<std::chrono::days>(std::chrono::system_clock::now().time_since_epoch());
  unsigned long long first = static_cast<unsigned long long>(today.count()) * 10000;
  int count = 3000;
  if (const char* asked = std::getenv("GBL_FRAMES")) {
    ASSERT_EQ(std::sscanf(asked, "%llu,%d", &first, &count), 2);
  }
  const Tally t = expect_sound_frames(first, count);
  fmt::print(
      "{} frames from {}, {} compared with the plain loop, {} pixels judged by the reference, {} off by more than a "
      "code\n",
      t.frames, first, t.compared, t.judged, t.over);
}

}  // namespace
}  // namespace gbl::test
