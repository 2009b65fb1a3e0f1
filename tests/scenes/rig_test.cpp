#include "renderer/scenes/rig.h"

#include <cmath>
#include <gtest/gtest.h>

#include "renderer/base/error.h"

namespace gbl {
namespace {

std::string refusal(const std::string& text) {
  try {
    parse_rig(text, "rig.json");
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    return e.what();
  }
  return "accepted";
}

TEST(Rig, all_kinds_of_light_are_read) {
  const auto lights = parse_rig(R"({"version": 1, "lights": [
      {"kind": "point", "position": [1, 2, 3], "colour": [1, 0.5, 0], "candela": 40, "range": 6},
      {"kind": "spot", "position": [0, 3, 0], "direction": [0, -2, 0], "candela": 100, "inner_deg": 20, "outer_deg": 60},
      {"kind": "directional", "direction": [0, -1, 0], "lux": 2, "attenuation": [1, 0.7, 1.8]}]})",
                                "rig.json");
  ASSERT_EQ(lights.size(), 3u);
  EXPECT_EQ(lights[0].position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(lights[0].colour, glm::dvec3(40, 20, 0));
  EXPECT_EQ(lights[0].range, 6);
  EXPECT_EQ(lights[1].kind, LightKind::spot);
  EXPECT_EQ(lights[1].direction, glm::dvec3(0, -1, 0)) << "made unit";
  EXPECT_NEAR(lights[1].outer_cos, 0.5, 1e-12);
  EXPECT_TRUE(lights[1].ends_faint) << "no range is stated";
  EXPECT_FALSE(lights[0].ends_faint);
  EXPECT_EQ(lights[2].range, kEndless);
  EXPECT_EQ(lights[2].coefficients, glm::dvec3(1, 0.7, 1.8));
}

TEST(Rig, what_is_wrong_is_named_with_its_place) {
  EXPECT_NE(refusal(R"({"version": 2, "lights": []})").find("newer"), std::string::npos);
  EXPECT_NE(refusal(R"({"lights": []})").find("version: is missing"), std::string::npos);
  EXPECT_NE(refusal(R"({"version": 1, "lights": [{"position": [0, 0, 0]}]})").find("light 0: candela: is missing"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"version": 1, "lights": [{"kind": "lamp"}]})").find("kind"), std::string::npos);
  EXPECT_NE(refusal(R"({"version": 1, "lights": [{"positon": [0, 0, 0]}]})").find("did you mean 'position'"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"version": 1, "lights": [{"position": [0, 0], "candela": 1}]})").find("3 numbers"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"version": 1, "lights": [{"position": [0, 0, 1e300], "candela": 1}]})").find("position"),
            std::string::npos);
  EXPECT_NE(refusal("{").find("rig.json:1"), std::string::npos);
  EXPECT_THROW(rig_lights("no/such/rig.json"), Error);
}

}  // namespace
}  // namespace gbl
