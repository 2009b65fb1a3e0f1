// The command line's order and refusals. Nothing is drawn here.
#include <gtest/gtest.h>

#include "app/commands.h"

namespace gbl {
namespace {

Arguments parsed(std::vector<const char*> words) {
  words.insert(words.begin(), "gbufferlab");
  return parse_arguments(static_cast<int>(words.size()), words.data());
}

std::string refused(const std::vector<const char*>& words) {
  try {
    setup_of(parsed(words));
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    return e.what();
  }
  return "accepted";
}

TEST(CommandLine, LaterKindsWinWhateverTheOrderOnTheLine) {
  const Settings s = setup_of(parsed({"render", "--set", "lights.count=3", "--lights", "9", "--set", "camera.fov=50",
                                      "--camera", "1,2,3:0,0:70", "--preset", "nclgl-fixed"}))
                         .settings;
  EXPECT_EQ(s.lights.count, 3) << "--set is last";
  EXPECT_EQ(s.camera.fov, 50);
  EXPECT_EQ(s.camera.position, glm::dvec3(1, 2, 3)) << "--camera after the preset";
  EXPECT_EQ(s.layout, Layout::nclgl) << "the rest is the preset's";
}

TEST(CommandLine, ACommandRefusesOptionsItWouldIgnore) {
  EXPECT_NE(refused({"list", "keys", "--lights", "3"}).find("--lights"), std::string::npos);
  EXPECT_NE(refused({"info", "--scene", "builtin:room"}).find("--scene"), std::string::npos);
  EXPECT_NE(refused({"view", "--json"}).find("--json"), std::string::npos);
}

TEST(CommandLine, WhatIsWrongIsNamed) {
  EXPECT_NE(refused({"rendr"}).find("did you mean 'render'"), std::string::npos);
  EXPECT_NE(refused({"render", "--size", "0x5"}).find("size"), std::string::npos);
  EXPECT_NE(refused({"render", "--lights", "16385"}).find("16384"), std::string::npos);
  EXPECT_NE(refused({"render", "--scene", "nothere.gltf"}).find("nothere.gltf"), std::string::npos);
  EXPECT_NE(refused({"render", "--camera", "1,2"}).find("x,y,z:yaw,pitch"), std::string::npos);
  EXPECT_NE(refused({"probe", "3"}).find("y"), std::string::npos);
  EXPECT_NE(refused({"probe", "-3", "4"}).find("-3"), std::string::npos);
  EXPECT_EQ(refused({"render", "--lights", "0"}), "accepted");
  EXPECT_EQ(refused({"render", "--lights", "16384"}), "accepted");
}

TEST(CommandLine, APixelOutsideThePictureIsRefusedWithTheBounds) {
  try {
    run_probe(parsed({"probe", "64", "0", "--size", "64x36"}));
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    EXPECT_NE(std::string(e.what()).find("0 to 63 and 0 to 35"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace gbl
