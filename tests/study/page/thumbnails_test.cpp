#include "renderer/study/page/thumbnails.h"

#include <fstream>
#include <gtest/gtest.h>
#include <limits>

#include "renderer/base/files.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

Truth grey_truth(glm::ivec2 size) {
  Truth t;
  t.size = size;
  t.present.assign(t.pixels(), 1);
  t.lit.assign(t.pixels(), glm::dvec3(0.5));
  return t;
}

TEST(SizeWithin, KeepsTheShapeAndNeverGrows) {
  EXPECT_EQ(size_within({640, 360}, kThumbnailSize), glm::ivec2(128, 72));
  EXPECT_EQ(size_within({1000, 1000}, kThumbnailSize), glm::ivec2(72, 72));
  EXPECT_EQ(size_within({64, 36}, kThumbnailSize), glm::ivec2(64, 36));
  EXPECT_EQ(size_within({4000, 1}, kThumbnailSize), glm::ivec2(128, 1));
}

TEST(Shrunk, TakesTheMeanInLinearLight) {
  const Image black_and_white{{2, 1}, {0, 0, 0, 255, 255, 255, 255, 255}};
  const Image grey = shrunk(black_and_white, {1, 1});
  EXPECT_EQ(grey.rgba, (std::vector<uint8_t>{188, 188, 188, 255})) << "half the light is code 188, not 128";
}

TEST(PalettePng, IsReadBackAsWritten) {
  const TemporaryFolder folder("palette");
  const IndexedImage image{{3, 2}, {{255, 0, 0}, {0, 255, 0}, {7, 8, 9}}, {0, 1, 2, 2, 1, 0}};
  write_text_file(folder / "p.png", png_bytes(image));
  const Image read = read_png(folder / "p.png");
  ASSERT_EQ(read.size, image.size);
  for (size_t i = 0; i < image.index.size(); ++i) {
    const std::array<uint8_t, 3> c = image.palette[image.index[i]];
    EXPECT_EQ((std::array{read.rgba[4 * i], read.rgba[4 * i + 1], read.rgba[4 * i + 2]}), c) << i;
  }
}

TEST(ErrorMap, ShowsTheWorstPixelBelowEachDot) {
  Truth truth = grey_truth({4, 2});
  truth.present[7] = 0;
  const Display linear{1, Colour::as_tutorial};
  std::vector<glm::vec3> lit(truth.pixels(), glm::vec3(0.5f));
  lit[1] = glm::vec3(0.5f, 0.5f + 5.0f / 255, 0.5f);  // of one channel: code 4 to 16
  lit[2].x = std::numeric_limits<float>::quiet_NaN();
  const IndexedImage map = error_map(truth, lit, linear, {2, 1});
  EXPECT_EQ(map.index, (std::vector<uint8_t>{4, 6})) << "not a number is as wrong as can be";
  lit[1] = lit[2] = glm::vec3(0.5f);
  EXPECT_EQ(error_map(truth, lit, linear, {2, 1}).index, (std::vector<uint8_t>{1, 1}));
  EXPECT_EQ(error_map(truth, lit, linear, {4, 2}).index.back(), 0) << "no surface";
}

TEST(ErrorMap, IsBrighterWhereItIsWorse) {
  const auto grey = [](const std::array<uint8_t, 3>& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
  for (size_t i = 2; i < kErrorSteps.size(); ++i)
    EXPECT_GT(grey(kErrorSteps[i].colour), grey(kErrorSteps[i - 1].colour) + 10) << i;
}

TEST(Thumbnails, AreKeptBesideTheJournal) {
  const TemporaryFolder folder("thumbs");
  const Image picture{{64, 36}, std::vector<uint8_t>(4 * 64 * 36, 128)};
  const Truth truth = grey_truth({64, 36});
  const std::vector<glm::vec3> lit(truth.pixels(), glm::vec3(0.5f));
  const Thumbnails made = make_thumbnails(picture, truth, lit, {});
  write_thumbnails(folder.path(), "key", made);
  const Thumbnails read = read_thumbnails(folder.path(), "key");
  EXPECT_EQ(read.picture, made.picture);
  EXPECT_EQ(read.error_map, made.error_map);
  EXPECT_EQ(read_thumbnails(folder.path(), "other").picture, "");
  std::ofstream(thumbnail_folder(folder.path()) / "other.jpg") << "no picture";
  std::ofstream(thumbnail_folder(folder.path()) / "other.png") << "\x89PNG" << std::string(100'000, ' ');
  EXPECT_EQ(read_thumbnails(folder.path(), "other").picture, "") << "not a JPEG";
  EXPECT_EQ(read_thumbnails(folder.path(), "other").error_map, "") << "too large to be one of ours";
}

}  // namespace
}  // namespace gbl
