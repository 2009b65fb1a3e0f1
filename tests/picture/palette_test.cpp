#include "renderer/picture/palette.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>

#include "renderer/base/random.h"
#include "renderer/picture/picture_difference.h"

namespace gbl {
namespace {

Image of(glm::ivec2 size, const std::function<glm::ivec3(int, int)>& colour) {
  Image out{size, {}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::ivec3 c = colour(x, y);
      for (int k = 0; k < 3; ++k) out.rgba.push_back(static_cast<uint8_t>(c[k]));
      out.rgba.push_back(255);
    }
  return out;
}

TEST(Palette, FewColoursStayAsTheyAre) {
  const Image image = of({40, 30}, [](int x, int y) { return glm::ivec3(x / 4 * 25, y / 3 * 25, 7); });  // 100 colours
  const IndexedImage few = indexed(image);
  ASSERT_EQ(few.palette.size(), 100u);
  for (size_t i = 0; i < few.index.size(); ++i)
    for (size_t k = 0; k < 3; ++k) ASSERT_EQ(few.palette[few.index[i]][k], image.rgba[4 * i + k]) << i;
}

// All of a plane of colours in 256: boxes of 16 x 16 codes, whose middles are 8 inside at the border. Within it neighbours make up for
// what a pixel is off.
TEST(Palette, MeansOfManyColoursStay) {
  const Image image = of({256, 256}, [](int x, int y) { return glm::ivec3(x, y, 128); });
  const IndexedImage few = indexed(image);
  EXPECT_EQ(few.palette.size(), 256u);
  EXPECT_LT(largest_square_difference(expanded(few), image, 16), 9);
  const Image narrow = of({256, 256}, [](int x, int y) { return glm::ivec3(64 + x / 2, 64 + y / 2, 128); });
  IndexedImage coarse = indexed(narrow);
  EXPECT_LT(largest_square_difference(expanded(coarse), narrow, 16), 5);
}

TEST(Palette, OnePixelAndOneColour) {
  EXPECT_EQ(indexed(of({1, 1}, [](int, int) { return glm::ivec3(1, 2, 3); })).palette.size(), 1u);
  EXPECT_EQ(indexed(of({9, 9}, [](int, int) { return glm::ivec3(9); })).palette.size(), 1u);
}

TEST(Palette, AFileOfItKeepsItsTexts) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "gbl_palette_test.png";
  const Image image = of({50, 20}, [](int x, int y) { return glm::ivec3(5 * x, 12 * y, 0); });
  write_indexed_png(path, image, {{"key", "text"}}, 118);
  const Image back = read_png(path);
  EXPECT_EQ(back.size, image.size);
  EXPECT_LT(largest_square_difference(back, image, 4), 16);
  EXPECT_EQ(read_png_text(path, "key"), "text");
  std::filesystem::remove(path);
}

TEST(PictureDifference, FindsASmallPlaceThatHasChanged) {
  const Image a = of({100, 60}, [](int, int) { return glm::ivec3(50); });
  Image b = a;
  EXPECT_EQ(largest_square_difference(a, b, 16), 0);
  for (int y = 50; y < 60; ++y)
    for (int x = 96; x < 100; ++x) b.rgba[4 * static_cast<size_t>(y * 100 + x) + 1] = 90;
  EXPECT_EQ(largest_square_difference(a, b, 16), 40 * 10.0 / 12) << "the last square is 4 by 12";
}

}  // namespace
}  // namespace gbl
