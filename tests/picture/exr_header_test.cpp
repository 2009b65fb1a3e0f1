// Headers of EXR files that would have the library take memory for what is not there are refused before it sees them.
#include "renderer/picture/exr_header.h"

#include "tests/test_support.h"

namespace gbl {
namespace {

std::string attribute(std::string_view name, std::string_view type, std::string_view value, uint32_t length) {
  std::string out(name);
  out += '\0', out += type, out += '\0';
  for (int k = 0; k < 4; ++k) out += static_cast<char>(length >> (8 * k));
  return out + std::string(value);
}
std::string attribute(std::string_view name, std::string_view type, std::string_view value) {
  return attribute(name, type, value, static_cast<uint32_t>(value.size()));
}
std::string header(const std::string& attributes) { return "v/1\1\2" + std::string(3, '\0') + attributes + '\0'; }
std::string channel(char name) { return std::string(1, name) + std::string(17, '\0'); }

bool refused(const std::string& start) {
  try {
    require_sound_exr_header(start, start.size(), "a.exr");
    return false;
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    return contains(e.what(), "cut short or damaged");
  }
}

TEST(ExrHeader, WholeOnesPass) {
  const std::string channels = channel('B') + channel('G') + channel('R') + '\0';
  EXPECT_FALSE(refused(header(attribute("channels", "chlist", channels) +
                              attribute("dataWindow", "box2i", std::string(16, 'x')) +
                              attribute("comment", "string", "…") + attribute("mine", "unknown", "12345"))));
}

TEST(ExrHeader, AnAttributeLongerThanTheFileIsRefused) {
  EXPECT_TRUE(refused(header(attribute("comment", "string", "short", 1u << 30))));
  EXPECT_TRUE(refused(header(attribute("comment", "string", "short", ~0u))));
}

TEST(ExrHeader, AnAttributeOfAnotherLengthThanItsTypeIsRefused) {
  EXPECT_TRUE(refused(header(attribute("dataWindow", "box2i", std::string(15, 'x')))));
  EXPECT_TRUE(refused(header(attribute("channels", "chlist", channel('B') + '\0' + "left over"))));
  EXPECT_TRUE(refused(header(attribute("channels", "chlist", channel('B')))));
  EXPECT_TRUE(refused(header(attribute("preview", "preview", std::string(8, '\1')))));
}

}  // namespace
}  // namespace gbl
