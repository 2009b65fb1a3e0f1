// The comparator that all picture tests rely on.
#include "tests/picture.h"

namespace gbl::test {
namespace {

Picture flat(float value) { return {{4, 2}, std::vector<glm::vec4>(8, glm::vec4(value))}; }

Picture with(float value, size_t texel, int channel, float other) {
  Picture p = flat(value);
  p.texels[texel][channel] = other;
  return p;
}

TEST(PictureComparison, SeesEveryChannelOfEveryTexel) {
  EXPECT_TRUE(like(flat(0.5f), flat(0.5f), {}));
  for (size_t texel = 0; texel < 8; ++texel)
    for (int k = 0; k < 4; ++k) {
      EXPECT_TRUE(unlike(with(0.5f, texel, k, 0.5001f), flat(0.5f), {}));
      EXPECT_TRUE(unlike(flat(0.5f), with(0.5f, texel, k, 0.5001f), {}));
    }
}

TEST(PictureComparison, ToleratesAsMuchAndAsManyAsSaidAndNoMore) {
  const Picture off = with(1, 3, 1, 1.25f);
  EXPECT_TRUE(like(off, flat(1), {.max_abs = 0.25}));
  EXPECT_TRUE(unlike(off, flat(1), {.max_abs = 0.2}));
  EXPECT_TRUE(like(off, flat(1), {.max_abs = 0.2, .failing_fraction = 1.0 / 8}));
  EXPECT_TRUE(unlike(off, flat(1), {.max_abs = 0.2, .failing_fraction = 0.9 / 8}));
}

TEST(PictureComparison, NonFiniteValuesAreNeverWithinATolerance) {
  const Tolerance wide{.max_abs = 1e30};
  for (const float odd : {NAN, INFINITY, -INFINITY}) {
    EXPECT_TRUE(unlike(with(0, 5, 2, odd), flat(0), wide));
    EXPECT_TRUE(unlike(flat(0), with(0, 5, 2, odd), wide));
    EXPECT_TRUE(like(with(0, 5, 2, odd), with(0, 5, 2, odd), {}));
    EXPECT_EQ(nonfinite(with(0, 5, 2, odd)), 1u);
  }
  EXPECT_TRUE(unlike(flat(INFINITY), flat(-INFINITY), wide));
  EXPECT_EQ(nonfinite(flat(0)), 0u);
}

TEST(PictureComparison, SameBitsKnowsTheSignOfZeroAndTheSize) {
  EXPECT_TRUE(same_bits(flat(0), flat(0)));
  EXPECT_TRUE(like(flat(0), flat(-0.0f), {}));
  EXPECT_FALSE(same_bits(flat(0), flat(-0.0f)));
  Picture turned = flat(0);
  turned.size = {2, 4};
  EXPECT_FALSE(same_bits(flat(0), turned));
  EXPECT_TRUE(unlike(flat(0), turned, {}));
}

TEST(PictureComparison, AFailureNamesPlaceReasonAndImage) {
  const auto result = like(with(0, 6, 0, 0.5f), flat(0), {.max_abs = 0.1, .why = "because"});
  const std::string text = result.message();
  EXPECT_NE(text.find("1 of 8"), std::string::npos) << text;
  EXPECT_NE(text.find("(2, 1 from below)"), std::string::npos) << text;
  EXPECT_NE(text.find("because"), std::string::npos) << text;
  const std::string path = text.substr(text.find("Difference: ") + 12);
  const Image image = read_png(path);
  ASSERT_EQ(image.size, glm::ivec2(4, 2));
  // Texel 6 is the third of the upper row: first in the file, red as there is too much.
  const std::vector<uint8_t> red(&image.rgba[8], &image.rgba[8] + 3);
  EXPECT_EQ(red, (std::vector<uint8_t>{255, 0, 0}));
  EXPECT_EQ(image.rgba[0], 0);
  std::filesystem::remove(path);
}

// A test that expects a difference leaves no picture behind; what is left below the build folder is a failure's.
TEST(PictureComparison, OnlyAnUnwantedDifferenceLeavesAPicture) {
  const auto test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto written = [&] {
    const auto folder = build_folder() / "differences";
    size_t n = 0;
    if (std::filesystem::exists(folder))
      for (const auto& entry : std::filesystem::directory_iterator(folder))
        n += entry.path().filename().string().find(test->name()) != std::string::npos;
    return n;
  };
  const size_t before = written();
  EXPECT_TRUE(unlike(flat(1), flat(0), {}));
  EXPECT_FALSE(unlike(flat(1), flat(1), {}));
  EXPECT_TRUE(like(flat(1), flat(1), {}));
  EXPECT_EQ(written(), before);
  const auto result = like(flat(1), flat(0), {});
  EXPECT_EQ(written(), before + 1);
  const std::string text = result.message();
  std::filesystem::remove(text.substr(text.find("Difference: ") + 12));
}

TEST(PictureComparison, TheImageTellsTooMuchFromTooLittleFromNotANumber) {
  Picture got = flat(0);
  got.texels[0].x = 1, got.texels[1].y = -0.5f, got.texels[2].z = NAN;
  const Image image = difference_image(got, flat(0));
  const uint8_t* lower = &image.rgba[4 * 4];  // the picture's lower row comes second in the file
  EXPECT_EQ(glm::ivec3(lower[0], lower[1], lower[2]), glm::ivec3(255, 0, 0));
  EXPECT_EQ(glm::ivec3(lower[4], lower[5], lower[6]), glm::ivec3(0, 0, 127));
  EXPECT_EQ(glm::ivec3(lower[8], lower[9], lower[10]), glm::ivec3(255, 0, 255));
  EXPECT_EQ(glm::ivec3(lower[12], lower[13], lower[14]), glm::ivec3(0));
}

}  // namespace
}  // namespace gbl::test
