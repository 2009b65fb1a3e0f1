#include "renderer/frame/attachments.h"

#include <algorithm>
#include <functional>
#include <set>

#include "renderer/gbuffer/layouts.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "renderer/options/options.h"
#include "renderer/options/presets.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

// The options that decide what is stored.
constexpr const char* kDecide[] = {"layout",
                                   "normal.encoding",
                                   "depth.format",
                                   "lights.method",
                                   "lights.volume.depth",
                                   "accumulation.format",
                                   "accumulation.targets"};

void for_each_combination(const std::function<void(const Settings&)>& check) {
  std::function<void(Settings, size_t)> choose = [&](Settings s, size_t i) {
    if (i == std::size(kDecide)) return check(s);
    const Option& o = option(kDecide[i]);
    for (const ValueRow& r : o.values) {
      o.set(s, r.id, o);
      if (s.layout != Layout::auto_) choose(s, i + 1);  // that one is resolved first
    }
  };
  choose(Settings{}, 0);
}

Format format_of(Stores what, const Settings& s) { return find(attachments(s), what)->format; }

TEST(GbufferLayout, PresetsCostTheirBytes) {
  EXPECT_EQ(gbuffer_bytes_per_pixel(preset("start").make()), 12);  // RGBA8 + RG16UI + D32F
  const std::pair<const char*, int> kSources[] = {{"nclgl", 12},       {"stereo", 20},   {"learnopengl-a", 24},
                                                  {"learnopengl", 24}, {"objectid", 56}, {"viewspace", 36}};
  for (const auto& [id, bytes] : kSources) EXPECT_EQ(gbuffer_bytes_per_pixel(preset(id).make()), bytes) << id;
  EXPECT_EQ(accumulation_bytes_per_pixel(preset("start").make()), 16);  // two RGBA16F
  Settings least = preset("start").make();
  least.normal.encoding = NormalEncoding::oct8;
  least.depth.format = DepthFormat::d16;
  least.accumulation = {AccumulationFormat::rgba8, AccumulationTargets::one};
  EXPECT_EQ(gbuffer_bytes_per_pixel(least), 8);
  EXPECT_EQ(accumulation_bytes_per_pixel(least), 4);
}

// A compact layout has room for the normal beside the material: no attachment of its own, unless the code is too long.
TEST(GbufferLayout, CompactLayoutsHoldShortNormalsInTheMaterial) {
  for (const Layout layout : {Layout::compact, Layout::compact_metal}) {
    Settings s;
    s.layout = layout;
    s.normal.encoding = NormalEncoding::oct14;
    EXPECT_TRUE(normal_in_material(s));
    EXPECT_EQ(find(attachments(s), Stores::normal), nullptr);
    const int bytes = gbuffer_bytes_per_pixel(s);
    s.normal.encoding = NormalEncoding::oct16;
    EXPECT_FALSE(normal_in_material(s));
    EXPECT_NE(find(attachments(s), Stores::normal), nullptr);
    EXPECT_GT(gbuffer_bytes_per_pixel(s), bytes);
  }
}

TEST(GbufferLayout, EachChoiceHasItsFormat) {
  for (const ValueRow& r : rows<NormalEncoding>()) {
    Settings s;
    s.normal.encoding = static_cast<NormalEncoding>(r.value);
    EXPECT_EQ(format_of(Stores::normal, s), row_of(s.normal.encoding).format) << r.id;
  }
  // The formats that the sources and the first screen are counted with.
  EXPECT_EQ(row_of(NormalEncoding::oct16).format, Format::rg16ui);
  EXPECT_EQ(row_of(NormalEncoding::oct8).format, Format::rg8);
  EXPECT_EQ(row_of(NormalEncoding::xyz8).format, Format::rgba8);
  EXPECT_EQ(row_of(NormalEncoding::stereo16f).format, Format::rg16f);
  EXPECT_EQ(row_of(NormalEncoding::oct14).format, Format::r32ui);
  EXPECT_EQ(row_of(NormalEncoding::xyz16f).format, Format::rgba16f);
  EXPECT_EQ(row_of(NormalEncoding::xyz32f).format, Format::rgba32f);
  const auto of_depth = [](DepthFormat f) {
    Settings s;
    s.depth.format = f;
    return format_of(Stores::depth, s);
  };
  EXPECT_EQ(of_depth(DepthFormat::d16), Format::d16);
  EXPECT_EQ(of_depth(DepthFormat::d24), Format::d24);
  EXPECT_EQ(of_depth(DepthFormat::d32f), Format::d32f);
  const auto of_light = [](AccumulationFormat f) {
    Settings s;
    s.accumulation = {f, AccumulationTargets::one};
    return format_of(Stores::light, s);
  };
  EXPECT_EQ(of_light(AccumulationFormat::rgba8), Format::rgba8);
  EXPECT_EQ(of_light(AccumulationFormat::r11g11b10f), Format::r11g11b10f);
  EXPECT_EQ(of_light(AccumulationFormat::rgba16f), Format::rgba16f);
  EXPECT_EQ(of_light(AccumulationFormat::rgba32f), Format::rgba32f);
}

TEST(GbufferLayout, EveryCombinationStoresEachThingOnceUnderItsOwnName) {
  size_t combinations = 0;
  for_each_combination([&](const Settings& s) {
    ++combinations;
    if (shading_of(s.lights.method) != Shading::deferred) return;  // the next test's
    const std::vector<Attachment> all = attachments(s);
    std::set<std::string> names;
    std::set<Stores> stored;
    for (const Attachment& a : all) {
      EXPECT_TRUE(names.insert(a.name).second) << a.name;
      EXPECT_TRUE(stored.insert(a.stores).second) << a.name;
      EXPECT_STRNE(a.contents, "") << a.name;
      EXPECT_EQ(find(all, a.stores), &a);
      const bool depth = a.stores == Stores::depth || a.stores == Stores::light_depth;
      EXPECT_EQ(row(a.format).numeric == Numeric::depth, depth) << a.name;
    }
    const bool split = s.accumulation.targets == AccumulationTargets::split;
    EXPECT_TRUE(stored.count(Stores::material) && stored.count(Stores::depth));
    EXPECT_NE(stored.count(Stores::normal) == 1, normal_in_material(s));
    EXPECT_TRUE(stored.count(Stores::lit));
    EXPECT_EQ(stored.count(Stores::light), split || folds_light(s) ? 0u : 1u);
    EXPECT_EQ(stored.count(Stores::diffuse_light), split ? 1u : 0u);
    EXPECT_EQ(stored.count(Stores::specular_light), split ? 1u : 0u);
    EXPECT_EQ(find(all, split ? Stores::light : Stores::diffuse_light), nullptr);
  });
  size_t expected = 1;
  for (const char* path : kDecide) expected *= option(path).values.size() - (path == std::string("layout"));
  EXPECT_EQ(combinations, expected);
}

// Folded, light is kept in the format of sums, but for radiance that half floats cannot hold: no sum is scaled then.
TEST(GbufferLayout, FoldedLightIsKeptInTheFormatOfSumsWhereItFits) {
  Settings s = preset("compact").make();
  s.lights.method = LightMethod::clustered;
  const auto lit = [&] { return find(attachments(s), Stores::lit)->format; };
  EXPECT_EQ(lit(), Format::rgba16f);
  s.exposure = 1e-5;
  EXPECT_EQ(lit(), Format::rgba32f);
  s.exposure = 1, s.accumulation.format = AccumulationFormat::r11g11b10f;
  EXPECT_EQ(lit(), Format::r11g11b10f);
  s.accumulation.targets = AccumulationTargets::split;
  EXPECT_EQ(lit(), Format::rgba32f);
}

// The stencil method's marks lie beside the depth, in the G-buffer too: a depth is copied between equal formats alone.
TEST(GbufferLayout, StencilComesWithItsMethodAndACopyOfTheDepthWithAnyDepthTest) {
  Settings s = preset("start").make();
  EXPECT_EQ(find(attachments(s), Stores::light_depth), nullptr);
  s.lights.volume.depth = VolumeDepth::greater_equal;
  EXPECT_FALSE(needs_stencil(s));
  EXPECT_EQ(format_of(Stores::light_depth, s), Format::d32f);
  EXPECT_EQ(accumulation_bytes_per_pixel(s), 20);  // two RGBA16F and the copy
  s.lights.method = LightMethod::fullscreen;
  EXPECT_EQ(find(attachments(s), Stores::light_depth), nullptr);
  s.lights.method = LightMethod::volumes_stencil;
  EXPECT_TRUE(needs_stencil(s));
  EXPECT_EQ(format_of(Stores::depth, s), Format::d32fs8);
  EXPECT_EQ(gbuffer_bytes_per_pixel(s), 16);  // D32F and 8 bits of stencil are padded to 8 B
  EXPECT_EQ(accumulation_bytes_per_pixel(s), 24);
  s.depth.format = DepthFormat::d24;
  EXPECT_EQ(format_of(Stores::depth, s), Format::d24s8);
  EXPECT_EQ(gbuffer_bytes_per_pixel(s), 12);
  for_each_combination([](const Settings& any) {
    const std::vector<Attachment> all = attachments(any);
    const Attachment* copy = find(all, Stores::light_depth);
    EXPECT_EQ(copy != nullptr, lighting_tests_depth(any));
    if (copy) {
      EXPECT_EQ(copy->format, find(all, Stores::depth)->format);
    }
    const bool has_room = any.depth.format != DepthFormat::d16;
    EXPECT_EQ(row(find(all, Stores::depth)->format).stencil, needs_stencil(any) && has_room);
  });
}

TEST(GbufferLayout, ForwardShadingStoresDepthAloneAndDeferredLightingWhatLightNeeds) {
  Settings s;
  s.layout = Layout::objectid;
  s.position.source = PositionSource::world32f;
  for (const LightMethod m : {LightMethod::forward, LightMethod::forward_prepass, LightMethod::forward_multipass}) {
    s.lights.method = m;
    EXPECT_EQ(attachments(s).size(), 2u) << "depth and lit";
    EXPECT_EQ(gbuffer_bytes_per_pixel(s), 4);
    EXPECT_EQ(accumulation_bytes_per_pixel(s), 0);
  }
  s.lights.method = LightMethod::prepass;
  s.position.source = PositionSource::depth;
  EXPECT_EQ(gbuffer_bytes_per_pixel(s), 12) << "gloss, normal, depth";
}

TEST(GbufferLayout, BytesAreTheSumOfTheRowsPassByPass) {
  for_each_combination([](const Settings& s) {
    int geometry = 0, lighting = 0, drawn = 0;
    Pass last = Pass::geometry;
    for (const Attachment& a : attachments(s)) {
      EXPECT_GE(a.written_by, last) << a.name;  // in the order of the passes
      last = a.written_by;
      geometry += a.written_by == Pass::geometry ? row(a.format).bytes : 0;
      lighting += a.written_by == Pass::lighting ? row(a.format).bytes : 0;
      drawn += a.written_by == Pass::geometry && row(a.format).numeric != Numeric::depth;
    }
    EXPECT_EQ(gbuffer_bytes_per_pixel(s), geometry);
    EXPECT_EQ(accumulation_bytes_per_pixel(s), lighting);
    // OpenGL ES 3.0 promises four draw buffers: only the source that stores most wants more.
    EXPECT_LE(drawn, s.layout == Layout::objectid ? 6 : 4) << row(s.layout).id;
  });
}

TEST(GbufferLayout, DepthComesLastOfTheGeometryPass) {
  for_each_combination([](const Settings& s) {
    const std::vector<Attachment> all = attachments(s);
    for (size_t i = 0; i + 1 < all.size(); ++i)
      EXPECT_TRUE(all[i].stores != Stores::depth || all[i + 1].written_by != Pass::geometry);
  });
}

TEST(GbufferLayout, FactsOfALayoutAgreeWithItsAttachment) {
  for (const ValueRow& r : rows<Layout>()) {
    Settings s;
    s.layout = static_cast<Layout>(r.value);
    if (s.layout == Layout::auto_) continue;
    const LayoutRow& known = facts(s.layout);
    std::string contents;
    for (const Attachment& a : attachments(s)) contents += a.written_by == Pass::geometry ? a.contents : "";
    EXPECT_EQ(known.stores_roughness(), contains(contents, "roughness") || contains(contents, "exponent")) << r.id;
    EXPECT_EQ(known.words, contains(contents, "9 9 8") || contains(contents, "10 10 10")) << r.id;
    EXPECT_EQ(known.keeps_emission, contains(contents, "emission") || contains(contents, "radiance")) << r.id;
    EXPECT_EQ(known.floats, !contains(contents, "sRGB-coded")) << r.id;
  }
}

TEST(Formats, BytesAndChannelsAreThoseOfTheName) {
  std::set<std::string> labels;
  for (const FormatRow& f : kFormats) {
    EXPECT_TRUE(labels.insert(f.label).second) << f.label;
    const std::string name = f.label;
    int bits = 0;  // every number in the name is one channel's bits, or all channels'
    if (name == "R11G11B10F")
      bits = 32;
    else if (f.numeric == Numeric::depth)
      bits = name == "D16" ? 16 : name == "D32FS8" ? 64 : 32;  // D24 is padded to 32, D32FS8 to 64
    else
      bits = f.channels * std::stoi(name.substr(name.find_first_of("0123456789")));
    EXPECT_EQ(f.bytes * 8, bits) << name;
    if (f.numeric != Numeric::depth && name != "R11G11B10F") {
      EXPECT_EQ(f.channels, static_cast<int>(name.find_first_of("0123456789"))) << name;
    }
  }
}

}  // namespace
}  // namespace gbl
