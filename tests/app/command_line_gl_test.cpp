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
  EXPECT_NE(refused({"probe", "3"}).find("y is required"), std::string::npos);
  EXPECT_NE(refused({"probe", "-3", "4"}).find("-3"), std::string::npos);
  EXPECT_EQ(refused({"render", "--lights", "0"}), "accepted");
  EXPECT_EQ(refused({"render", "--lights", "16384"}), "accepted");
}

// One rule for every number, and no value is ever taken as not given.
TEST(CommandLine, NumbersAreDecimalsAndValuesAreNotEmpty) {
  for (const char* text : {"010", "0x10", "1.5", "+8", " 8", "8 ", "", "1e2"})
    EXPECT_NE(refused({"render", "--lights", text}).find("--lights"), std::string::npos) << text;
  for (const char* text : {".5", "nan", "inf", "1e999", "0x1p3", ""})
    EXPECT_NE(refused({"render", "--time", text}).find("--time"), std::string::npos) << text;
  EXPECT_NE(refused({"render", "--camera", ".5,2,3:0,0"}).find("'.5' is not a number"), std::string::npos);
  EXPECT_NE(refused({"render", "--camera", "nan,2,3:0,0"}).find("'nan' is not a number"), std::string::npos);
  EXPECT_NE(refused({"render", "--size", "064x36"}).find("--size"), std::string::npos);
  for (const char* option : {"--scene", "--preset", "--state", "--rig", "--set", "--without", "--only", "-o"})
    EXPECT_NE(refused({"render", option, ""}).find("empty value"), std::string::npos) << option;
  EXPECT_NE(refused({"study", ""}).find("empty value"), std::string::npos);
  EXPECT_NE(refused({"render", "--set", "mistakes="}).find("mistakes=[]"), std::string::npos);
  EXPECT_NE(refused({"list", "keys", "--md", "--json"}).find("--json"), std::string::npos);
}

TEST(CommandLine, ListsAreWrittenWithCommas) {
  const auto mistakes = [](const char* text) { return setup_of(parsed({"render", "--set", text})).settings.mistakes; };
  EXPECT_EQ(mistakes("mistakes=tbn-precedence"), mistakes("mistakes=[\"tbn-precedence\"]"));
  EXPECT_EQ(mistakes("mistakes=tbn-precedence").size(), 1u);
  EXPECT_EQ(setup_of(parsed({"render", "--set", "camera.position=1,-2.5,3"})).settings.camera.position,
            glm::dvec3(1, -2.5, 3));
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
