#include "renderer/frame/validate.h"

#include <fmt/format.h>
#include <functional>
#include <limits>
#include <set>

#include "renderer/frame/attachments.h"
#include "renderer/options/options.h"
#include "renderer/options/presets.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

const DeviceLimits kCorePath{};  // nothing beyond GL 3.3 core

DeviceLimits every_feature() {
  DeviceLimits all;
  for (const FeatureRow& f : kFeatures) all.features.add(f.feature);
  return all;
}

// As few targets as OpenGL ES 3.0 promises, for the one problem that only such a device has.
DeviceLimits limits_for(ProblemId id) {
  DeviceLimits limits = every_feature();
  if (id == ProblemId::too_many_targets) limits.max_draw_buffers = 4;
  return limits;
}

struct Case {
  ProblemId id;
  const char* path;
  std::function<void(Settings&)> breaks;
};

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

const Case kCases[] = {
    {ProblemId::not_finite, "exposure", [](Settings& s) { s.exposure = kNan; }},
    {ProblemId::not_finite, "camera.position", [](Settings& s) { s.camera.position.z = kInfinity; }},
    {ProblemId::not_finite, "camera.orientation", [](Settings& s) { s.camera.orientation.w = kNan; }},
    {ProblemId::not_finite, "background.colour", [](Settings& s) { s.background.colour.y = -kInfinity; }},
    {ProblemId::size_above_limit, "size", [](Settings& s) { s.size.x = 16385; }},
    {ProblemId::size_above_limit, "size", [](Settings& s) { s.size.y = 16385; }},
    {ProblemId::far_not_beyond_near, "camera.far", [](Settings& s) { s.camera.far = s.camera.near; }},
    {ProblemId::rig_not_read, "lights.rig", [](Settings& s) { s.lights.rig = "stage.json"; }},
    {ProblemId::rig_not_named, "lights.rig", [](Settings& s) { s.lights.source = LightSource::rig; }},
    {ProblemId::no_such_light, "lights.only", [](Settings& s) { s.lights.only = s.lights.count; }},
    {ProblemId::alpha_not_stored, "background.skip", [](Settings& s) { s.background.skip = BackgroundSkip::alpha; }},
    {ProblemId::prepass_needs_split, "accumulation.targets",
     [](Settings& s) {
       s.lights.method = LightMethod::prepass;
       s.accumulation.targets = AccumulationTargets::one;
     }},
    {ProblemId::antialias_needs_gbuffer, "antialias",
     [](Settings& s) {
       s.lights.method = LightMethod::forward;
       s.antialias = Antialias::msaa_resolved;
     }},
    {ProblemId::too_many_targets, "layout",
     [](Settings& s) {
       s.layout = Layout::objectid;
       s.position.source = PositionSource::world32f;
     }},
    {ProblemId::stencil_needs_d24, "depth.format",
     [](Settings& s) {
       s.lights.method = LightMethod::volumes_stencil;
       s.depth.format = DepthFormat::d16;
     }},
    {ProblemId::less_equal_needs_back, "lights.cull",
     [](Settings& s) { s.lights.volume.depth = VolumeDepth::less_equal; }},
    {ProblemId::greater_equal_needs_front, "lights.cull",
     [](Settings& s) {
       s.lights.method = LightMethod::volumes_instanced;
       s.lights.volume.depth = VolumeDepth::greater_equal;
     }},
};

// compact and exact stand for reversed depth, which the core path cannot draw: they say so, and nothing else.
TEST(Validate, PresetsAreValidOnTheCorePathOrSayWhatTheyNeed) {
  for (const Preset& p : presets()) {
    if (std::string_view(p.id) == "compact" || std::string_view(p.id) == "exact") {
      const std::vector<Problem> problems = validate(p.make(), kCorePath);
      ASSERT_EQ(problems.size(), 1u) << p.id;
      EXPECT_EQ(problems[0].id, ProblemId::feature_missing);
      EXPECT_EQ(problems[0].path, "depth.format");
      continue;
    }
    const std::vector<Problem> problems = validate(p.make(), kCorePath);
    EXPECT_TRUE(problems.empty()) << p.id << ": " << problems.front().path << " " << problems.front().sentence;
    EXPECT_NO_THROW(require_valid(p.make(), kCorePath)) << p.id;
  }
}

// A link from a machine that has more: the nearest picture is shown, and what gave way is named.
TEST(Validate, WhatADeviceLacksGivesWayToWhatItHas) {
  for (const Option& o : options())
    for (const ValueRow& r : o.values) {
      SCOPED_TRACE(std::string(o.path) + "=" + r.id);
      Settings asked = preset("start").make();
      o.set(asked, r.id, o);
      EXPECT_EQ(nearest_with(every_feature().features, asked).settings, asked);
      const Nearest n = nearest_with({}, asked);
      const ValueRow& shown = o.values[static_cast<size_t>(chosen(o, n.settings))];
      EXPECT_EQ(shown.needs, Feature::none);
      ASSERT_EQ(n.sentences.size(), r.needs == Feature::none ? 0u : 1u);
      if (r.needs == Feature::none) {
        EXPECT_EQ(n.settings, asked);
        continue;
      }
      const std::string& sentence = n.sentences.front();
      for (const char* word : {o.path, r.id, shown.id}) EXPECT_TRUE(contains(sentence, word)) << sentence;
    }
  EXPECT_EQ(nearest_with({}, preset("exact").make()).settings.depth.format, DepthFormat::d32f);
}

TEST(Validate, EachMistakeIsFoundAloneByItsIdAndPath) {
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.path);
    Settings s = preset("start").make();
    c.breaks(s);
    const std::vector<Problem> problems = validate(s, limits_for(c.id));
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].id, c.id) << problems[0].sentence;
    EXPECT_EQ(problems[0].path, c.path);
    EXPECT_NO_THROW(option(problems[0].path));
    const std::string line = error_line(ExitCode::bad_input, [&] { require_valid(s, limits_for(c.id)); });
    EXPECT_EQ(line, std::string(c.path) + ": " + problems[0].sentence + " [" + id_of(c.id) + "]");
  }
}

TEST(Validate, LimitsAreTheDevicesAndBothEndsAreAllowed) {
  Settings s = preset("start").make();
  s.size = {16384, 1};
  EXPECT_TRUE(validate(s, kCorePath).empty());
  DeviceLimits small;
  small.max_size = 4096;
  ASSERT_EQ(validate(s, small).size(), 1u);
  EXPECT_TRUE(contains(validate(s, small)[0].sentence, "16384x1 is above this driver's limit of 4096"));
  s.size = {4096, 4096};
  s.lights.only = s.lights.count - 1;
  EXPECT_TRUE(validate(s, small).empty());
  s.lights.count = 0;  // no light, and no single one asked for
  s.lights.only = -1;
  EXPECT_TRUE(validate(s, small).empty());
}

TEST(Validate, AsManyTargetsAsTheDeviceHasAreAllowedAndNoMore) {
  Settings s = preset("start").make();
  s.layout = Layout::objectid;
  s.position.source = PositionSource::world32f;
  int targets = 0;
  for (const Attachment& a : attachments(s)) targets += a.written_by == Pass::geometry && a.stores != Stores::depth;
  DeviceLimits limits = every_feature();
  limits.max_draw_buffers = targets;
  EXPECT_TRUE(validate(s, limits).empty());
  limits.max_draw_buffers = targets - 1;
  ASSERT_EQ(validate(s, limits).size(), 1u);
  EXPECT_TRUE(contains(validate(s, limits)[0].sentence, fmt::format("{} colour targets", targets)));
}

std::vector<Problem> missing_features(const Settings& s, const DeviceLimits& limits) {
  std::vector<Problem> found;
  for (const Problem& p : validate(s, limits))
    if (p.id == ProblemId::feature_missing) found.push_back(p);
  return found;
}

TEST(Validate, AMissingFeatureNamesRowAndFeature) {
  std::set<std::string> rows_that_need;
  for (const Option& o : options())
    for (const ValueRow& r : o.values) {
      if (r.needs == Feature::none) continue;
      SCOPED_TRACE(std::string(o.path) + "=" + r.id);
      rows_that_need.insert(std::string(o.path) + "=" + r.id);
      Settings s = preset("start").make();
      o.set(s, r.id, o);
      DeviceLimits all = every_feature();
      EXPECT_TRUE(missing_features(s, all).empty());
      all.features.remove(r.needs);
      const std::vector<Problem> problems = missing_features(s, all);
      ASSERT_EQ(problems.size(), 1u);
      EXPECT_EQ(problems[0].path, o.path);
      EXPECT_TRUE(contains(problems[0].sentence, r.id)) << problems[0].sentence;
      EXPECT_TRUE(contains(problems[0].sentence, kFeatures[static_cast<int>(r.needs) - 1].id)) << problems[0].sentence;
    }
  EXPECT_EQ(rows_that_need.count("lights.method=tiled"), 1u);
}

// What a depth test needs is asked of those methods that make it, and each need is met by one row.
TEST(Validate, ADepthTestGoesWithOneCullingRule) {
  for (const ValueRow& depth : rows<VolumeDepth>()) {
    int valid = 0;
    for (const ValueRow& cull : rows<LightCull>()) {
      Settings s = preset("start").make();
      s.lights.volume.depth = static_cast<VolumeDepth>(depth.value);
      s.lights.cull = static_cast<LightCull>(cull.value);
      valid += validate(s, every_feature()).empty();
      for (const LightMethod m : {LightMethod::fullscreen, LightMethod::volumes_stencil}) {
        s.lights.method = m;
        EXPECT_TRUE(validate(s, every_feature()).empty()) << depth.id << " " << cull.id;
      }
    }
    const bool tests = depth.value != static_cast<int>(VolumeDepth::none);
    EXPECT_EQ(valid, tests ? 1 : static_cast<int>(rows<LightCull>().size())) << depth.id;
  }
}

TEST(Validate, D16IsRefusedForTheStencilThatAskedForIt) {
  Settings s = preset("start").make();
  s.depth.format = DepthFormat::d16;
  s.background.skip = BackgroundSkip::stencil;
  const std::vector<Problem> problems = validate(s, every_feature());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].id, ProblemId::stencil_needs_d24);
  EXPECT_TRUE(contains(problems[0].sentence, "background.skip=stencil")) << problems[0].sentence;
}

TEST(Validate, EveryIdIsUniqueAndProducedAbove) {
  std::set<ProblemId> produced;
  for (const Case& c : kCases) produced.insert(c.id);
  // feature_missing is the test before this one's: every row that needs a feature, as soon as there is one.
  const int count = static_cast<int>(ProblemId::too_many_targets) + 1;
  EXPECT_EQ(static_cast<int>(produced.size()), count - 1);
  EXPECT_EQ(produced.count(ProblemId::feature_missing), 0u);
  std::set<std::string> ids;
  for (int i = 0; i < count; ++i) EXPECT_TRUE(ids.insert(id_of(static_cast<ProblemId>(i))).second) << i;
}

TEST(Validate, SeveralMistakesAreAllTold) {
  Settings s = preset("start").make();
  s.camera.far = kNan;  // neither finite nor beyond near
  s.lights.only = 64;
  std::set<ProblemId> found;
  for (const Problem& p : validate(s, kCorePath)) found.insert(p.id);
  EXPECT_EQ(found,
            (std::set<ProblemId>{ProblemId::not_finite, ProblemId::far_not_beyond_near, ProblemId::no_such_light}));
}

}  // namespace
}  // namespace gbl
