#include "renderer/inspect/views.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "renderer/base/error.h"
#include "renderer/base/resources.h"
#include "renderer/gbuffer/layouts.h"
#include "renderer/options/presets.h"

namespace gbl {
namespace {

const Bounds kTerrain{{0, 0, 0}, {4096, 319, 4096}};

double luminance(const glm::vec3& coded) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(coded.r) + 0.7152 * linear(coded.g) + 0.0722 * linear(coded.b);
}

TEST(Views, RowIsViewAndIdsAreThePromisedOnes) {
  const char* promised[] = {
      "final",          "albedo",           "normal",       "depth",      "material",     "diffuse-light",
      "specular-light", "lights-per-pixel", "position",     "lit",        "wasted-pairs", "reflectance",
      "metal",          "emission",         "occlusion",    "ambient",    "exponent",     "object-id",
      "footprint",      "miscounted-pairs", "tested-pairs", "tile-edges", "overdraw",     "triangle-size",
      "wire",           "back-faces",       "outlines",     "background", "checks",       "reference",
      "error"};
  ASSERT_EQ(views().size(), static_cast<size_t>(kViewCount));
  size_t place = 0;
  for (const char* id : promised) {
    size_t i = 0;
    while (i < views().size() && views()[i].id != std::string(id)) ++i;
    ASSERT_LT(i, views().size()) << "the view " << id << " is gone, and scripts rely on it";
    EXPECT_GE(i, place) << id << " has another place: the window pages through the views in this order";
    place = i;
  }
  for (int i = 0; i < kViewCount; ++i) {
    const ViewRow& r = views()[i];
    EXPECT_EQ(r.view, static_cast<View>(i));
    EXPECT_EQ(&row(r.view), &r);
    EXPECT_EQ(&view_by_id(r.id), &r);
    EXPECT_EQ(std::string(r.key), i < 9    ? std::to_string(i + 1)
                                  : i < 18 ? "Shift " + std::to_string(i - 8)
                                           : "")
        << r.id << ": the first views have the keys 1 to 9, the next Shift 1 to 9, and a new one stands after them";
  }
}

TEST(Views, EveryCardIsFilledInAndSpeaksOfAllSources) {
  for (const ViewRow& r : views()) {
    for (const char* text :
         {r.label, r.sentence, r.space, r.unit, r.range, r.read_by, r.decode, r.in_sources, r.mistake})
      EXPECT_STRNE(text, "") << r.id;
    const std::string said = r.in_sources;
    if (said.starts_with("none of the five")) continue;
    const bool four_at_once = said.find("the other four") != std::string::npos;
    for (const char* source : {"nclgl", "stereo", "learnopengl", "objectid", "viewspace"})
      EXPECT_TRUE(four_at_once || said.find(source) != std::string::npos)
          << r.id << ": .in_sources does not name " << source
          << "; say what each of the five calls it, or begin with \"none of the five\"";
  }
}

TEST(Views, EachHasItsFileAndEachFileItsRow) {
  std::set<std::string> files;
  for (const ViewRow& r : views()) {
    const std::string file = "shaders/" + shader_of(r.view);
    if (r.fragment) {
      EXPECT_FALSE(resource(file).empty()) << r.id;
      continue;
    }
    files.insert(file);
    for (const char* function : {"vec3 value(ivec2 texel)", "vec4 shown(ivec2 texel)", "vec4 raw(ivec2 texel)"})
      EXPECT_NE(resource(file).find(function), std::string::npos) << file << ": no " << function;
  }
  const std::vector<std::string> there = resource_names("shaders/views/");
  EXPECT_EQ(std::set<std::string>(there.begin(), there.end()), files);
}

TEST(Views, UnknownIdListsTheKnownOnes) {
  try {
    view_by_id("normals");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    EXPECT_NE(std::string(e.what()).find("did you mean 'normal'?"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("lights-per-pixel"), std::string::npos);
  }
}

TEST(Views, MissingOnlyWhereNothingIsStoredAndWithAReason) {
  Settings s = preset("start").make();
  for (const ViewRow& r : views()) {
    const bool of_metals =
        r.view >= View::reflectance && r.view <= View::exponent;  // albedo-roughness keeps none of it
    const bool of_shadows = r.view >= View::visibility && r.view <= View::shadow_maps;
    EXPECT_EQ(why_missing(r.view, s).empty(), !of_metals && !of_shadows && r.view != View::tile_edges) << r.id;
  }
  s.shadows = Shadows::all;
  for (const View v : {View::visibility, View::shadow_map_read, View::shadow_texel, View::shadow_maps})
    EXPECT_EQ(why_missing(v, s), "") << row(v).id;
  s.shadows = Shadows::off;
  s.layout = Layout::float32;
  for (const View v : {View::reflectance, View::metal, View::emission, View::occlusion, View::object_id})
    EXPECT_EQ(why_missing(v, s), "") << row(v).id;
  s.layout = Layout::objectid;
  for (const View v : {View::reflectance, View::ambient, View::exponent, View::object_id})
    EXPECT_EQ(why_missing(v, s), "") << row(v).id;
  EXPECT_EQ(stored_as(View::object_id, s), "gbuffer.object_id R32UI 4 B");
  EXPECT_EQ(stored_as(View::exponent, s), "gbuffer.shininess R32F 4 B");

  s.accumulation.targets = AccumulationTargets::one;
  s.layout = Layout::nclgl;
  for (const View v : {View::material, View::diffuse_light, View::specular_light}) EXPECT_NE(why_missing(v, s), "");
  for (const View v : {View::final, View::albedo, View::normal, View::depth, View::lights_per_pixel, View::position,
                       View::lit, View::wasted_pairs, View::reference, View::error})
    EXPECT_EQ(why_missing(v, s), "") << row(v).id;
  EXPECT_EQ(why_missing(View::material, s), facts(Layout::nclgl).roughness_missing);
  EXPECT_NE(why_missing(View::diffuse_light, s).find("accumulation.targets=split"), std::string::npos);
}

TEST(Views, StoredAsNamesTheAttachmentOfTheseSettings) {
  Settings s = preset("start").make();
  EXPECT_EQ(stored_as(View::normal, s), "gbuffer.normal RG16UI 4 B");
  EXPECT_EQ(stored_as(View::albedo, s), "gbuffer.albedo_roughness RGBA8 4 B");
  EXPECT_EQ(stored_as(View::material, s), stored_as(View::albedo, s));
  EXPECT_EQ(stored_as(View::depth, s), "gbuffer.depth D32F 4 B");
  EXPECT_EQ(stored_as(View::position, s), stored_as(View::depth, s));
  EXPECT_EQ(stored_as(View::diffuse_light, s), "light.diffuse RGBA16F 8 B");
  EXPECT_EQ(stored_as(View::final, s), stored_as(View::lit, s));
  s.normal.encoding = NormalEncoding::oct8;
  EXPECT_EQ(stored_as(View::normal, s), "gbuffer.normal RG8 2 B");
  s.accumulation.targets = AccumulationTargets::one;
  EXPECT_EQ(stored_as(View::specular_light, s), "light.sum RGBA16F 8 B");
}

TEST(Views, DepthRangeHoldsTheSceneAndEndsAtARoundNumber) {
  const Camera start = preset("start").make().camera;
  EXPECT_EQ(depth_view_range(start, kTerrain), glm::dvec2(0, 4000));  // the farthest corner is at 3443

  Camera c;
  for (const double size : {0.003, 0.9, 1.0, 1.3, 7.0, 24.0, 31.9, 99.0, 101.0, 4096.0}) {
    const double end = depth_view_range(c, {{-1, -1, -size}, {1, 1, 0}}).y;
    EXPECT_GE(end, size);
    EXPECT_LE(end, std::max(size, c.near) * 1.5) << size;
  }
  EXPECT_EQ(depth_view_range(c, {{-1, -1, -240}, {1, 1, 0}}).y, 240);  // a round number stays
  c.far = 50;
  EXPECT_EQ(depth_view_range(c, {{-1, -1, -240}, {1, 1, 0}}).y, 50);
  // Behind the camera, and a camera turned round to face it.
  EXPECT_EQ(depth_view_range(c, {{-1, -1, 10}, {1, 1, 30}}).y, c.near);
  c.orientation = orientation_from_yaw_pitch(180, 0);
  EXPECT_EQ(depth_view_range(c, {{-1, -1, 10}, {1, 1, 30}}).y, 32);
}

TEST(Legends, DepthBarHasFiveNumbersAndTheSkyApart) {
  const Legend l = legend(View::depth, preset("start").make(), kTerrain);
  EXPECT_TRUE(l.bar);
  ASSERT_EQ(l.entries.size(), 5u);
  const char* labels[] = {"0", "1000", "2000", "3000", "4000 units"};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(l.entries[i].label, labels[i]);
    EXPECT_EQ(l.entries[i].colour, glm::vec3(i * 0.25f));  // near dark, far light
  }
  ASSERT_EQ(l.apart.size(), 1u);
  EXPECT_EQ(l.apart[0].colour, kSkyColour);
}

TEST(Legends, NormalAxesAreTheirOwnCode) {
  const Legend l = legend(View::normal, preset("start").make(), kTerrain);
  EXPECT_FALSE(l.bar);
  ASSERT_EQ(l.entries.size(), 6u);
  EXPECT_EQ(l.entries[0].label, "+X");
  EXPECT_EQ(l.entries[0].colour, glm::vec3(1, 0.5f, 0.5f));
  EXPECT_EQ(l.entries[1].label, "+Y");
  EXPECT_EQ(l.entries[5].label, "-Z");
  EXPECT_EQ(l.entries[5].colour, glm::vec3(0.5f, 0.5f, 0));
}

TEST(Legends, RoughnessBarTellsExponentsOnlyWhereTheyComeFromIt) {
  Settings s = preset("start").make();
  Legend l = legend(View::material, s, kTerrain);
  EXPECT_TRUE(l.bar);
  ASSERT_EQ(l.entries.size(), 5u);
  EXPECT_EQ(l.entries.front().label, "0 (exponent 8192)");
  EXPECT_EQ(l.entries[2].label, "0.5 (30)");
  EXPECT_EQ(l.entries.back().label, "1 (1)");
  s.shading.exponent = 33;
  EXPECT_EQ(legend(View::material, s, kTerrain).entries[2].label, "0.5");
  s.layout = Layout::nclgl;
  EXPECT_TRUE(legend(View::material, s, kTerrain).entries.empty());  // a missing view has no legend
}

TEST(Views, EveryAttachmentOfEveryPresetHasAView) {
  for (const Preset& p : presets()) {
    const Settings s = p.make();
    for (const Attachment& a : attachments(s)) {
      if (a.stores == Stores::light || a.stores == Stores::light_depth)
        continue;  // a part of `lit`; the depth once more
      bool shown = false;
      for (const ViewRow& r : views()) {
        const std::optional<Attachment> of = attachment_of(r.view, s);
        shown |= of && of->name == a.name && why_missing(r.view, s).empty();
      }
      EXPECT_TRUE(shown) << p.id << ": " << a.name << " has no view";
    }
  }
}

TEST(Legends, LightCountsAreThePaletteAndTellApartWithoutHue) {
  const Legend l = legend(View::lights_per_pixel, preset("start").make(), kTerrain);
  EXPECT_FALSE(l.bar);
  ASSERT_EQ(l.entries.size(), static_cast<size_t>(kLightCountColours));
  for (int i = 0; i < kLightCountColours; ++i) {
    EXPECT_EQ(l.entries[i].colour, kLightCountPalette[i]);
    EXPECT_EQ(l.entries[i].label, std::to_string(i) + (i == 5 ? "+" : ""));
    if (i > 0) {
      // 0.05: stray light on a projector's screen.
      const double ratio = (luminance(kLightCountPalette[i]) + 0.05) / (luminance(kLightCountPalette[i - 1]) + 0.05);
      EXPECT_GT(ratio, 1.6) << i;
    }
  }
  EXPECT_LT(luminance(kLightCountPalette[0]), 0.01);
}

TEST(Legends, CountsFollowTheLargestOfThePicture) {
  const auto labels = [](double largest) {
    ViewStats stats;
    stats.max = glm::dvec3(largest);
    std::string text;
    for (const LegendEntry& e : legend(View::wasted_pairs, preset("start").make(), kTerrain, &stats).entries)
      text += e.label + " ";
    return text;
  };
  EXPECT_EQ(labels(0), "0 1 2 3 4 5+ ");
  EXPECT_EQ(labels(9), "0 1 2 3 4 5+ ");
  EXPECT_EQ(labels(10), "0 1 2 3-5 6-9 10+ ");
  EXPECT_EQ(labels(64), "0 1-2 3-6 7-18 19-49 50+ ");
  EXPECT_EQ(labels(1024), "0 1-5 6-31 32-177 178-999 1000+ ");
  EXPECT_FALSE(labels(1e30).empty()) << "a position far out: no count, but an end";
}

TEST(Legends, PositionTellsItsCycleAndPicturesNeedNone) {
  const Settings s = preset("start").make();
  const Legend l = legend(View::position, s, kTerrain);
  ASSERT_EQ(l.entries.size(), 4u);
  EXPECT_EQ(l.entries.back().label, "one colour cycle = 100 units");
  EXPECT_EQ(position_cycle({{0, 0, 0}, {1, 1, 1}}), 0.1) << "a small scene has small cycles";
  for (const View v : {View::final, View::albedo, View::diffuse_light, View::specular_light, View::lit})
    EXPECT_TRUE(legend(v, s, kTerrain).entries.empty());
}

}  // namespace
}  // namespace gbl
