// How texts break into lines.
#include "ui/text.h"

#include <algorithm>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <sstream>

#include "renderer/base/random.h"
#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

constexpr float kPx = 14;

float width(std::string_view text) { return text_size(text, kPx).x; }

TEST(Text, ANumberIsNotBrokenAtItsPoint) {
  const Desk desk({1280, 720});
  const float up_to_the_point = width("lighting 384.");
  ASSERT_LT(up_to_the_point, width("lighting 384.0"));
  const ImVec2 size = text_size("lighting 384.0", kPx, up_to_the_point);
  EXPECT_EQ(size.x, std::max(width("lighting"), width("384.0")));
  EXPECT_EQ(size.y, 2 * text_size("x", kPx).y);
}

TEST(Text, AsManyWordsStandInALineAsFitAndNoneIsBroken) {
  const Desk desk({1280, 720});
  constexpr const char* kWords[] = {"a", "0.25", "geometry", "·", "16.0,", "(why?)", "1 430 424"};
  Pcg32 random(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::string> words;
    for (int i = 0; i < 12; ++i) words.emplace_back(kWords[random.next() % std::size(kWords)]);
    const std::string text = fmt::format("{}", fmt::join(words, " "));
    const float longest = width("1 430 424"), wrap = longest + static_cast<float>(random.unit()) * 200;
    float line = 0, widest = 0;
    int lines = 1;
    std::istringstream parts(text);
    for (std::string word; parts >> word;) {
      const float more = line == 0 ? width(word) : line + width(" ") + width(word);
      if (more > wrap) ++lines;
      line = more > wrap ? width(word) : more;
      widest = std::max(widest, line);
    }
    const ImVec2 size = text_size(text, kPx, wrap);
    EXPECT_EQ(size.y, static_cast<float>(lines) * text_size("x", kPx).y) << text << " in " << wrap;
    EXPECT_NEAR(size.x, widest, 1) << text << " in " << wrap;  // ImGui gives whole pixels
  }
}

TEST(Text, LinesOfItsOwnStayAndAWordWithoutRoomIsBroken) {
  const Desk desk({1280, 720});
  EXPECT_EQ(text_size("one\ntwo three", kPx, 1000).y, 2 * text_size("x", kPx).y);
  EXPECT_LE(text_size("/a/path/that/no/line/has/room/for.glb", kPx, 100).x, 100);
}

}  // namespace
}  // namespace gbl::ui
