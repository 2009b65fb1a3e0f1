// What a command line gives to sweeps, and the page that they write.
#include "renderer/study/stability/stability_given.h"

#include <cmath>
#include <gtest/gtest.h>

#include "renderer/opening/scene_look.h"
#include "renderer/study/stability/stability_chart.h"
#include "renderer/study/stability/stability_page.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

SweepGiven hall() {
  SweepGiven given{.place = true, .words = "--scene builtin:hall"};
  given.scene = open_scene("builtin:hall");
  apply_scene(given.settings, "builtin:hall", *given.scene);
  given.settings.camera.near = 0.25;
  return given;
}

TEST(SweepGiven, ASceneStandsInThePlaceOfTheSweepsAndTheParameterStaysItsOwn) {
  const SweepGiven given = hall();
  const Sweep& s = sweep("near-plane");
  ASSERT_EQ(refusal(s, given), "");
  SweepSetup setup = s.at(0.01);
  given_over(s, given)(setup);
  EXPECT_EQ(setup.scene, given.scene);
  EXPECT_EQ(setup.settings.scene, "builtin:hall");
  EXPECT_EQ(setup.settings.camera.position, given.settings.camera.position);
  EXPECT_EQ(setup.settings.camera.near, 0.01) << "what is moved";
  EXPECT_EQ(setup.settings.size, s.at(0.01).settings.size) << "unless a size is given";
  EXPECT_EQ(setup.settings.layout, Layout::float32) << "all but what is studied stays exact";
}

TEST(SweepGiven, OptionsGoOverThoseOfASweep) {
  SweepGiven given{.paths = {"ambient", "size"}, .words = "--set ambient=0.5"};
  given.settings.ambient = 0.5, given.settings.size = {80, 45};
  for (const Sweep& s : sweeps()) {
    if (has_families(s) || !refusal(s, given).empty()) continue;
    SweepSetup setup = s.at(s.values().front());
    const std::shared_ptr<const Scene> own = setup.scene;
    given_over(s, given)(setup);
    EXPECT_EQ(setup.settings.ambient, 0.5) << s.id;
    EXPECT_EQ(setup.settings.size, glm::ivec2(80, 45)) << s.id;
    EXPECT_EQ(setup.scene, own) << s.id;
  }
}

TEST(SweepGiven, WhatASweepVariesOrNeedsIsRefused) {
  const auto given = [](const char* path) { return SweepGiven{.paths = {path}, .words = path}; };
  EXPECT_TRUE(contains(refusal(sweep("near-plane"), given("depth.format")), "depth.format")) << "its curves";
  EXPECT_TRUE(contains(refusal(sweep("near-plane"), given("camera.near")), "camera.near")) << "its parameter";
  EXPECT_TRUE(contains(refusal(sweep("shadow-bias"), given("shadows")), "shadows")) << "what it is about";
  EXPECT_EQ(refusal(sweep("near-plane"), given("ambient")), "");
  for (const Sweep& s : sweeps()) EXPECT_EQ(refusal(s, hall()).empty(), !s.keeps.empty()) << s.id;
  EXPECT_TRUE(contains(refusal(sweep("near-corner"), hall()), "near-plane")) << "it says which take a scene";
}

TEST(SweepGiven, AStateBringsItsSceneToTheSweepsThatTakeOne) {
  SweepGiven given = hall();
  given.place = false, given.state = given.ways = true;
  given.settings.accumulation.format = AccumulationFormat::r11g11b10f;
  for (const Sweep& s : sweeps()) {
    if (has_families(s)) continue;
    ASSERT_EQ(refusal(s, given), "") << s.id;
    SweepSetup setup = s.at(s.values().front());
    const std::shared_ptr<const Scene> own = setup.scene;
    given_over(s, given)(setup);
    EXPECT_EQ(setup.scene, s.keeps.empty() ? own : given.scene) << s.id;
    if (std::string_view(s.id) == "light-count") continue;  // its curves are these formats
    EXPECT_EQ(setup.settings.accumulation.format, AccumulationFormat::r11g11b10f) << s.id;
  }
}

TEST(SweepGiven, PlacesAreKnown) {
  for (const char* path : {"scene", "camera.near", "lights.count", "lights.rig"}) EXPECT_TRUE(is_place(path)) << path;
  for (const char* path : {"lights.method", "size", "ambient"}) EXPECT_FALSE(is_place(path)) << path;
}

TEST(SweepGiven, NothingIsJudgedThen) {
  const SweepGiven given = hall();
  const Sweep& s = sweep("volume-level");
  SweepRun run{.over = given_over(s, given), .given = given.words};
  for (const FeatureRow& f : kFeatures) run.limits.features.add(f.feature);
  SweepRunner runner(s, run);
  while (!runner.complete()) runner.add(SweepRow{.sweep = s.id, .value = 1.0});
  EXPECT_TRUE(runner.result().holds());
  for (const CurveResult& c : runner.result().curves) EXPECT_TRUE(c.judged.empty());
}

SweepResult result_of(const char* id, const std::vector<double>& values) {
  SweepResult result{.sweep = &sweep(id)};
  result.curves.push_back({.curve = "a <b>", .judged = {{"is flat", {false, "it is not"}}}});
  for (size_t i = 0; i < values.size(); ++i)
    result.curves[0].rows.push_back(
        {.sweep = id, .curve = "a <b>", .x = double(i + 1), .metric = "m", .value = values[i]});
  result.curves.push_back({.curve = "c", .not_drawn = "no compute"});
  return result;
}

TEST(StabilityPage, EveryPointAndEveryCurveExplainsItself) {
  const SweepResult result = result_of("near-plane", {0.5, 0, std::nan(""), INFINITY});
  const Page page = stability_page({result}, {"driver", "device"}, "to nearest");
  ASSERT_EQ(page.charts.size(), 1u);
  EXPECT_EQ(page.charts[0].points.size(), 4u);
  EXPECT_TRUE(contains(page.charts[0].points[2].words, "not finite"));
  EXPECT_TRUE(contains(page.charts[0].note, "not finite"));
  ASSERT_EQ(page.rows.size(), 2u);
  EXPECT_EQ(page.rows[0].command, "gbufferlab stability near-plane");
  EXPECT_EQ(page.rows[0].cells[3].text, "DOES NOT HOLD");
  EXPECT_EQ(page.rows[1].failed, "no compute");
  const std::string html = page_html(page);
  EXPECT_TRUE(contains(html, "a &lt;b&gt;"));
  EXPECT_EQ(html.find("translate(nan"), std::string::npos);
}

TEST(StabilityChart, IsInPercentTellsSoundFromUnsoundAndGivesZeroARow) {
  SweepResult result = result_of("volume-level", {0.1, 0.0001, 0});
  result.curves[1] = {.curve = "b", .rows = result.curves[0].rows};
  result.curves[1].settings.lights.volume.fit = VolumeFit::inscribed;
  const std::string script = stability_script(result, "device", StabilityFile::svg);
  for (const char* part : {"sound (filled):", "unsound (open):", "'%g %%'", "set object rectangle", "ytics add ('0'"})
    EXPECT_TRUE(contains(script, part)) << part << "\n" << script;
}

TEST(StabilityPage, OfNoPointsHasNoChart) {
  EXPECT_TRUE(stability_page({result_of("near-plane", {})}, {}, "").charts.empty());
  EXPECT_TRUE(contains(page_html(stability_page({}, {}, "")), "None has been measured"));
}

}  // namespace
}  // namespace gbl
