#include "renderer/figures/figure_spec.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/figures/drawings.h"
#include "renderer/inspect/views.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

Json plain_figure() {
  return {{"id", "one"},
          {"title", "One"},
          {"caption", "A figure."},
          {"preset", "start"},
          {"panels", {{{"view", "final"}}}}};
}

std::string refusal(const Json& figure) {
  try {
    parse_figure(figure, "f.json");
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    return e.what();
  }
  return "accepted";
}

TEST(Figures, EveryBuiltInSetIsReadAndOpensItsScenes) {
  for (const BuiltinFigures& set : builtin_figures()) {
    const FigureSet read = load_figures(set.id, {});
    EXPECT_EQ(read.title, set.title);
    for (const FigureSpec& f : read.figures) {
      EXPECT_FALSE(f.caption.empty()) << f.id;
      for (const FigurePanel& p : f.panels)
        if (p.recipe.scene.empty()) {
          EXPECT_EQ(why_missing(view_by_id(p.view).view, settings_of(p.recipe, f.size, f.id)), "")
              << f.id << " " << p.view;
        }
    }
  }
}

TEST(Figures, APanelSaysWhatItsFigureDoesNot) {
  Json j = plain_figure();
  j["scene"] = "builtin:yard", j["camera"] = "1,2,3:0,0:50";
  j["set"] = {{"lights.count", 3}, {"exposure", 2}};
  j["panels"] = {{{"view", "final"}},
                 {{"view", "depth"}, {"set", {{"lights.count", 4}}}, {"camera", "4,5,6:0,0"}},
                 {{"view", "normal"}, {"scene", "builtin:room"}}};
  const FigureSpec f = parse_figure(j, "f.json");
  const Settings first = settings_of(f.panels[0].recipe, {64, 36}, ""),
                 second = settings_of(f.panels[1].recipe, {64, 36}, ""),
                 third = settings_of(f.panels[2].recipe, {64, 36}, "");
  EXPECT_EQ(first.lights.count, 3);
  EXPECT_EQ(first.camera.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(first.size, glm::ivec2(64, 36));
  EXPECT_EQ(second.lights.count, 4);
  EXPECT_EQ(second.exposure, 2);
  EXPECT_EQ(second.camera.position, glm::dvec3(4, 5, 6));
  EXPECT_EQ(third.scene, "builtin:room");
  EXPECT_NE(third.camera.position, first.camera.position) << "another scene has a camera of its own";
}

TEST(Figures, WhatIsReadMakesTheSameFigureAgain) {
  Json j = plain_figure();
  j["panels"][0]["inset"] = {{"scale", 8}, {"centre", {0.25, 0.75}}, {"corner", "bottom left"}};
  const FigureSpec f = parse_figure(j, "f.json"), again = parse_figure(parse_json(f.json, "again"), "again");
  EXPECT_EQ(f.json, again.json);
  EXPECT_EQ(again.panels[0].inset->centre, glm::dvec2(0.25, 0.75));
  EXPECT_FALSE(again.panels[0].inset->right || again.panels[0].inset->top);
}

TEST(Figures, StoredPanelsAreThoseThatHaveAKeyAndAreStored) {
  Json j = plain_figure();
  j["preset"] = "nclgl", j["panels"] = "stored";
  const FigureSpec f = parse_figure(j, "f.json");
  const Settings s = preset("nclgl").make();
  size_t stored = 0;
  for (const ViewRow& v : views()) stored += *v.key && why_missing(v.view, s).empty();
  EXPECT_EQ(f.panels.size(), stored);
  EXPECT_GT(stored, 8u);
}

TEST(Figures, ARefusalNamesFilePlaceAndFix) {
  const auto with = [](const char* member, Json value) {
    Json j = plain_figure();
    j[member] = std::move(value);
    return refusal(j);
  };
  EXPECT_EQ(refusal(plain_figure()), "accepted");
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(with("panels", {{{"view", "finall"}}}), "f.json: one: panel 1"))
      << with("panels", {{{"view", "finall"}}});
  EXPECT_TRUE(has(with("panels", {{{"view", "finall"}}}), "did you mean 'final'"));
  EXPECT_TRUE(has(with("panels", {{{"view", "final"}, {"set", {{"lights.cul", "back"}}}}}), "lights.cull"));
  EXPECT_TRUE(has(with("panles", 1), "did you mean 'panels'"));
  EXPECT_TRUE(has(with("id", "a/b"), "names files"));
  EXPECT_TRUE(has(with("size", {0, 10}), "\"size\" is [0,10]"));
  EXPECT_TRUE(has(with("drawing", "packing"), "either"));
  EXPECT_TRUE(has(with("frames", {{"keys", {{{"time_s", 0}}}}}), "at least two"));
  EXPECT_TRUE(has(with("frames", {{"keys", {{{"time_s", 0}}, {{"exposure", 1}}}}}), "the same paths"));
  EXPECT_TRUE(has(with("panels", {{{"view", "final"}, {"inset", {{"corner", "middle"}}}}}), "top left"));
  EXPECT_TRUE(has(with("panels", {{{"view", "final"}, {"against", {{"left", "a"}}}}}), "both sides"));
  const Json against = {{"set", {{"exposure", 2}}}};
  EXPECT_TRUE(has(with("panels", {{{"view", "depth"}, {"numbers", true}, {"against", against}}}), "one picture only"));
  EXPECT_TRUE(
      has(with("panels", {{{"view", "depth"}, {"outside", "0,0,9:0,0"}, {"against", against}}}), "one picture only"));
}

TEST(Figures, WholeNumbersStayWholeBetweenKeys) {
  Json j = plain_figure();
  j["frames"] = {{"count", 4}, {"keys", {{{"lights.count", 1}}, {{"lights.count", 3}}}}};
  const FigureSpec f = parse_figure(j, "f.json");
  std::vector<int> counts;
  for (int k = 0; k < 4; ++k) {
    Settings s;
    apply_patch(s, patch_at(*f.frames, k / 3.0), "test");
    counts.push_back(s.lights.count);
  }
  EXPECT_EQ(counts, (std::vector<int>{1, 2, 2, 3}));
}

TEST(Figures, FramesGoEvenlyFromKeyToKey) {
  Json j = plain_figure();
  j["frames"] = {
      {"count", 5},
      {"keys", {{{"camera", "0,0,0:0,0:40"}, {"time_s", 0}}, {{"camera", "10,0,0:90,0:60"}, {"time_s", 4}}}}};
  const FigureSpec f = parse_figure(j, "f.json");
  const auto at = [&](double share) {
    Settings s;
    apply_patch(s, patch_at(*f.frames, share), "test");
    return s;
  };
  EXPECT_EQ(at(0).camera.position.x, 0);
  EXPECT_EQ(at(1).camera.position.x, 10);
  EXPECT_EQ(at(1).time_s, 4);
  EXPECT_NEAR(at(0.25).camera.position.x, 2.5, 1e-12);
  EXPECT_NEAR(at(0.5).camera.fov, 50, 1e-12);
  EXPECT_NEAR(yaw_pitch_of(at(0.5).camera.orientation).x, 45, 1e-9) << "it turns, evenly";
  EXPECT_NEAR(glm::length(at(0.3).camera.orientation), 1, 1e-12);
}

// Facing it, a disc through the middle covers 1 - (r / d)^2 of the outline: 0.556; its 36 corners 0.995 of that.
TEST(Drawings, ADiscCoversTheShareThatIsKnown) {
  const std::string svg = figure_drawing("disc").svg(Settings(), "Disc");
  EXPECT_NE(svg.find("straight ahead: 55 % covered"), std::string::npos) << svg;
}

// The engine blog's shortcut ends a light of strength 100 at 64 to 65 % of where it fades to 5/256.
TEST(Drawings, TheShortcutEndsALightTooEarly) {
  const std::string svg = figure_drawing("falloff").svg(preset("viewspace").make(), "Range");
  EXPECT_NE(svg.find(": 64 %"), std::string::npos) << svg;
  EXPECT_NE(svg.find("true range 28.2"), std::string::npos) << svg;
}

TEST(Drawings, ALightFromTheSideSaysWhereTheCameraIs) {
  Settings s = preset("start").make();
  s.view.pick = 37;
  EXPECT_NE(figure_drawing("light-from-side").svg(s, "Side").find("which is inside"), std::string::npos);
  s.view.pick = 4000;
  EXPECT_THROW(figure_drawing("light-from-side").svg(s, "Side"), Error);
}

TEST(Drawings, TitlesAreEscaped) {
  for (const FigureDrawing& d : figure_drawings()) {
    const std::string svg = d.svg(preset("nclgl").make(), "a < b & c");
    EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos) << d.id;
    EXPECT_EQ(svg.find("a < b"), std::string::npos) << d.id;
  }
}

}  // namespace
}  // namespace gbl
