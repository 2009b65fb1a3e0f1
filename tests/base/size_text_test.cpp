// Sizes and pixels as they are typed.
#include "renderer/base/size_text.h"

#include <gtest/gtest.h>

namespace gbl {
namespace {

TEST(SizeText, ASizeComesBackFromItsText) {
  for (const glm::ivec2 size : {glm::ivec2(1280, 720), glm::ivec2(1, 16384), glm::ivec2(0, 5), glm::ivec2(-3, 7)})
    EXPECT_EQ(size_of(size_text(size)), size) << size_text(size);
  EXPECT_EQ(size_text({1280, 720}), "1280x720");
}

TEST(SizeText, NothingElseIsASize) {
  for (const char* text : {"", "x", "640", "640x", "x360", "640x360x", "640xx360", " 640x360", "640x360 ", "640 x 360",
                           "640,360", "640x36o", "64.0x360", "99999999999x1"})
    EXPECT_FALSE(size_of(text)) << text;
}

TEST(SizeText, APixelIsTwoNumbersHoweverTheyAreParted) {
  for (const char* text : {"7, 360", "7,360", "7 360", " 7;360 ", "7x360", "7 , 360"})
    EXPECT_EQ(pixel_of(text), glm::ivec2(7, 360)) << text;
  EXPECT_EQ(pixel_of("-7, -1"), glm::ivec2(-7, -1));
  for (const char* text : {"", " ", "7", "7,", ", 360", "7, 360, 2", "7; y", "7.5, 2"})
    EXPECT_FALSE(pixel_of(text)) << text;
}

}  // namespace
}  // namespace gbl
