// The command line's order and refusals, and the ways of `bench`.
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <optional>

#include "app/calibration.h"
#include "app/commands.h"
#include "app/headless.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"

namespace gbl {
namespace {

Arguments parsed(std::vector<const char*> words) {
  words.insert(words.begin(), "gbufferlab");
  return parse_arguments(static_cast<int>(words.size()), words.data()).value();
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

Json json_of_bench(std::vector<const char*> words) {
  words.insert(words.begin(), {"bench", "--json"});
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_bench(parsed(words)), ExitCode::done);
  return Json::parse(testing::internal::GetCapturedStdout());
}

std::string refused_by_bench(std::vector<const char*> words) {
  words.insert(words.begin(), "bench");
  try {
    run_bench(parsed(words));
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    return e.what();
  }
  return "accepted";
}

TEST(CommandLine, BenchAgainstMeasuresBothAndTheirErrors) {
  const Json j = json_of_bench({"--scene", "builtin:yard", "--size", "64x36", "--preset", "compact", "--frames", "3",
                                "--set", "lights.method=fullscreen", "--against", "accumulation.targets=split",
                                "--against", "accumulation.format=rgba8"});
  EXPECT_EQ(j["rounds"], 3);
  EXPECT_GT(j["ratio"], 0);
  EXPECT_LE(j["ratio_low"], j["ratio"]);
  EXPECT_GE(j["ratio_high"], j["ratio"]);
  EXPECT_EQ(int(j["B"]["bytes_per_pixel"]) - int(j["A"]["bytes_per_pixel"]), 8) << "two sums in RGBA8";
  EXPECT_GT(double(j["B"]["over_half_255_display"]), double(j["A"]["over_half_255_display"])) << "8 bits are too few";
}

TEST(CommandLine, BenchMicroHasARowForEachModelFalloffAndMethod) {
  const Json j = json_of_bench({"--micro", "--size", "64x36"});
  std::map<std::string, int> rows;
  for (const Json& r : j) {
    ++rows[r["group"]];
    EXPECT_TRUE(r["ns_per_pair"].is_number());
    EXPECT_TRUE(r["arithmetic_ns_per_pair"].is_null() || r["group"] != "lights.method")
        << "how it is read is not in it";
  }
  EXPECT_EQ(rows["shading.model"], 4);
  EXPECT_EQ(rows["attenuation"], 7);
  EXPECT_GE(rows["lights.method"], 5) << "six where there are compute shaders";
}

TEST(CommandLine, BenchTimesWhatAUserWaitsForBesideThePasses) {
  const Json j = json_of_bench({"--scene", "builtin:yard", "--size", "320x180", "--frames", "3", "--no-truth"});
  const auto median = [&](const char* what) { return double(j[std::string("time_ms_") + what + "_median"]); };
  EXPECT_GT(median("wall"), 0);
  EXPECT_GT(median("cpu"), 0);
  EXPECT_GT(median("submission"), 0);
  EXPECT_LE(median("submission"), median("wall")) << "a part of it";
}

// Into a folder of its own, so that no test beside this one chooses by it.
TEST(CommandLine, BenchCalibrateMeasuresTheDeviceAndKeepsIt) {
  const char* const set = std::getenv("XDG_STATE_HOME");
  const std::optional<std::string> before = set ? std::optional<std::string>(set) : std::nullopt;
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "bench-calibrate";
  std::filesystem::remove_all(folder);
  setenv("XDG_STATE_HOME", folder.c_str(), 1);
  const Json j = json_of_bench({"--calibrate", "--size", "64x36", "--scene", "builtin:yard"});
  const std::filesystem::path file = calibration_file().value();
  before ? setenv("XDG_STATE_HOME", before->c_str(), 1) : unsetenv("XDG_STATE_HOME");
  EXPECT_GT(int(j["set_ups"]), 30);
  EXPECT_GT(double(j["ns_per_unit"]), 0);
  EXPECT_EQ(j["units"]["turn"], 1);
  EXPECT_EQ(j["units"].size(), kWorkKinds);
  const HeadlessContext context;
  std::string trouble;
  const WorkWeights kept = weights_for(file, gl::probe_device({}), trouble);
  EXPECT_EQ(trouble, "");
  EXPECT_EQ(kept.ns_per_unit, double(j["ns_per_unit"]));
  std::filesystem::remove_all(folder);
}

TEST(CommandLine, BenchGrowthHasARowForEachPointAndAChart) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "bench-growth";
  std::filesystem::remove_all(folder);
  const Json j = json_of_bench({"--growth", "overlap", "--size", "64x36", "--scene", "builtin:hall", "--frames", "1",
                                "--set", "lights.method=clustered", "-o", folder.c_str()});
  ASSERT_GE(j["rows"].size(), 4u) << "the smallest lights may reach nothing";
  EXPECT_EQ(j["powers"].size(), j["rows"].size() - 1);
  double before = 0;
  for (const Json& r : j["rows"]) {
    EXPECT_GT(double(r["x"]), before);
    EXPECT_GT(double(r["total_ms"]), 0);
    EXPECT_GE(double(r["tested_per_pixel"]), double(r["x"]) * (1 - 1e-9)) << "what reaches a pixel is tested";
    EXPECT_GT(double(r["targets_mib"]), 0);
    before = r["x"];
  }
  EXPECT_NE(read_text_file(folder / "growth-overlap.svg").find("lights that reach a pixel"), std::string::npos);
  std::filesystem::remove_all(folder);
  EXPECT_NE(refused_by_bench({"--growth", "light"}).find("did you mean 'lights'"), std::string::npos);
  EXPECT_NE(refused_by_bench({"--growth", "lights", "--micro"}).find("--micro"), std::string::npos);
  EXPECT_NE(refused_by_bench({"--growth", "lights", "--lights", "64"}).find("--lights"), std::string::npos);
  EXPECT_NE(refused_by_bench({"--growth", "pixels", "--size", "64x36"}).find("--size"), std::string::npos);
  EXPECT_NE(refused_by_bench({"-o", "out"}).find("--growth"), std::string::npos);
}

TEST(CommandLine, BenchRefusesWhatItWouldIgnore) {
  EXPECT_NE(refused_by_bench({"--calibrate", "--frames", "3"}).find("--calibrate"), std::string::npos);
  EXPECT_NE(refused_by_bench({"--calibrate", "--micro"}).find("--micro"), std::string::npos);
  EXPECT_NE(refused_by_bench({"--micro", "--lights", "3"}).find("--lights"), std::string::npos);
  EXPECT_NE(refused_by_bench({"--micro", "--against", "colour=srgb"}).find("--against"), std::string::npos);
  EXPECT_NE(refused_by_bench({"--against", "no.such=1"}).find("no.such"), std::string::npos);
  EXPECT_NE(refused_by_bench({"--frames", "0", "--against", "lights.count=1"}).find("0 frames"), std::string::npos);
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
