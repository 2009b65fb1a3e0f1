// layers.exr as another program reads it. It prints nine decimals.
#include "app/layers_exr.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>

#include "tests/gl_fixture.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  for (std::array<char, 4096> part; pipe && std::fgets(part.data(), part.size(), pipe);) text += part.data();
  if (pipe) pclose(pipe);
  return text;
}

class LayersExr : public GlTest {};

TEST_F(LayersExr, AnotherProgramReadsTheNumbersOfTheViews) {
  if (std::system("command -v oiiotool > /dev/null") != 0)
    GTEST_SKIP() << "oiiotool is not installed (openimageio-tools)";
  const TemporaryFolder folder("exr");
  const std::string file = (folder / "layers.exr").string();
  Lab lab(FeatureSet{});
  lab.show("yard", std::make_shared<const Scene>(make_yard()));
  Settings s = settings_for(yard(), {8, 5});
  s.scene = "yard";
  lab.draw(s);
  const std::vector<View> shown = {View::albedo,           View::normal,    View::depth,
                                   View::lights_per_pixel, View::object_id, View::reference};
  write_layers(file, lab, shown, {{"gbufferlab-settings", "{ }"}});
  const std::string info = output_of(fmt::format("oiiotool --info -v {}", file));
  for (const char* part : {"8 x    5", "albedo.R", "normal.X", "depth.Z", "lights-per-pixel.Y", "object-id.Y (uint)",
                           "reference.B", "gbufferlab-settings"})
    EXPECT_NE(info.find(part), std::string::npos) << part << "\n" << info;
  for (const View v : shown) {
    const std::vector<glm::vec4> numbers = lab.numbers_of(v);
    const std::string letter = v == View::normal               ? "X"
                               : v == View::depth              ? "Z"
                               : row(v).values.components == 1 ? "Y"
                                                               : "R";
    const char* whole = counted(v) || row(v).numbered ? "-d uint32" : "";  // else the reader makes shares of them
    const std::string one = (folder / "one.exr").string();
    const std::string dump = output_of(fmt::format("oiiotool --native {} --ch {}.{} {} -o {} && oiiotool --dumpdata {}",
                                                   file, row(v).id, letter, whole, one, one));
    int read = 0;
    for (int y = 0; y < s.size.y; ++y)
      for (int x = 0; x < s.size.x; ++x) {
        const std::string place = fmt::format("Pixel ({}, {}):", x, y);
        const size_t at = dump.find(place);
        ASSERT_NE(at, std::string::npos) << dump;
        const double value = std::strtod(dump.c_str() + at + place.size(), nullptr);
        const double expected = double(numbers[static_cast<size_t>(y * s.size.x + x)].x);
        EXPECT_NEAR(value, expected, 1e-6 * (1 + std::abs(expected))) << row(v).id << " " << place;
        ++read;
      }
    EXPECT_EQ(read, 40);
  }
}

TEST_F(LayersExr, AFolderThatIsNotThereLeavesNothing) {
  Lab lab(FeatureSet{});
  lab.show("yard", std::make_shared<const Scene>(make_yard()));
  Settings s = settings_for(yard(), {8, 5});
  s.scene = "yard";
  lab.draw(s);
  EXPECT_THROW(write_layers("/nowhere/layers.exr", lab, {View::albedo}, {}), Error);
}

}  // namespace
}  // namespace gbl::test
