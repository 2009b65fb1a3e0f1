// Fields of attachments: they cover every bit once, and lie where the shaders put them.
#include "renderer/frame/stored_fields.h"

#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>
#include <set>

#include "renderer/frame/attachments.h"
#include "renderer/options/options.h"

namespace gbl {
namespace {

// The options that decide what is stored, and how.
constexpr const char* kDecide[] = {"layout",       "normal.encoding", "position.source",
                                   "depth.format", "lights.method",   "accumulation.format"};

void for_each_attachment(const std::function<void(const Settings&, const Attachment&)>& check) {
  std::function<void(Settings, size_t)> choose = [&](Settings s, size_t i) {
    if (i < std::size(kDecide)) {
      const Option& o = option(kDecide[i]);
      for (const ValueRow& r : o.values) {
        o.set(s, r.id, o);
        if (s.layout != Layout::auto_) choose(s, i + 1);
      }
      return;
    }
    for (const Attachment& a : attachments(s)) check(s, a);
  };
  Settings s;
  s.accumulation.targets = AccumulationTargets::split;
  choose(s, 0);
}

// How often each bit is named: those of the words, then those of no channel.
std::vector<int> times_named(const std::vector<StoredField>& fields) {
  std::vector<int> times(5 * 32, 0);
  for (const StoredField& f : fields)
    for (const BitRuns& code : f.components) {
      int holds = 0;
      for (const BitRun& r : code) {
        EXPECT_EQ(r.holds, holds) << f.name << ": a part of the code is missing";
        holds += r.bits;
        for (int b = 0; b < r.bits; ++b) ++times[static_cast<size_t>(r.channel * 32 + r.first + b)];
      }
    }
  return times;
}

TEST(StoredFields, CoverEveryBitOfEveryAttachmentOnce) {
  std::set<std::string> seen;
  for_each_attachment([&](const Settings& s, const Attachment& a) {
    const FormatRow& format = row(a.format);
    for (const bool shines : {false, true}) {
      const std::vector<StoredField> fields = stored_fields(s, a, shines);
      std::string key = fmt::format("{} {}", a.name, format.label);
      for (const StoredField& f : fields) key += f.name + fmt::format("{}", f.components.size());
      if (!seen.insert(key).second) continue;
      const std::vector<int> times = times_named(fields);
      int bits = 0;
      for (size_t channel = 0; channel < 5; ++channel) {
        const bool stencil = format.stencil && channel == 1;
        const int within = channel == kPadding                              ? 32
                           : channel < static_cast<size_t>(format.channels) ? format.channel_bits[channel]
                           : stencil                                        ? 8
                                                                            : 0;
        for (int b = 0; b < 32; ++b) {
          const int n = times[channel * 32 + static_cast<size_t>(b)];
          bits += n;
          if (channel != kPadding) {
            EXPECT_EQ(n, b < within ? 1 : 0) << key << ": channel " << channel << " bit " << b;
          }
        }
      }
      EXPECT_EQ(bits, format.bytes * 8) << key;
      for (const StoredField& f : fields) EXPECT_NE(f.name, "") << key;
    }
  });
  EXPECT_GT(seen.size(), 60u);
}

std::string described(const Settings& s, const char* name, bool shines = false) {
  std::string text;
  for (const Attachment& a : attachments(s)) {
    if (std::string_view(a.name) != name) continue;
    for (const StoredField& f : stored_fields(s, a, shines)) {
      text += text.empty() ? f.name : "; " + f.name;
      for (const BitRuns& code : f.components)
        for (const BitRun& r : code) text += fmt::format(" {}:{}+{}", r.channel, r.first, r.bits);
    }
  }
  return text;
}

TEST(StoredFields, WordsLieAsTheShadersPackThem) {
  Settings s;
  s.layout = Layout::compact_metal;
  s.normal.encoding = NormalEncoding::oct12;
  EXPECT_EQ(described(s, "gbuffer.material"),
            "normal 0:0+12 0:12+12; roughness 1:26+6 0:28+4; base colour 1:0+9 1:9+9 1:18+8; unused 0:24+4");
  EXPECT_EQ(described(s, "gbuffer.reflectance"), "metal 0:0+10; occlusion 0:10+10; shines 0:31+1; unused 0:20+11");
  EXPECT_EQ(described(s, "gbuffer.reflectance", true),
            "emission 0:0+8 0:8+8 0:16+8; metal 0:24+3; occlusion 0:27+4; shines 0:31+1");
  s.normal.encoding = NormalEncoding::oct16;
  EXPECT_EQ(described(s, "gbuffer.material"), "roughness 1:26+6 0:28+4; base colour 1:0+9 1:9+9 1:18+8; unused 0:0+28");
  EXPECT_EQ(described(s, "gbuffer.normal"), "normal 0:0+16 1:0+16");
  s.layout = Layout::exact;
  EXPECT_EQ(described(s, "gbuffer.material"),
            "base colour 0:0+10 0:10+10 0:20+10; roughness 0:30+2 1:0+12; metal 1:12+10; occlusion 1:22+10");
}

TEST(StoredFields, SayHowNumbersAreMeant) {
  Settings s;
  s.layout = Layout::viewspace;
  s.position.source = PositionSource::view_scaled;
  const auto field = [&](const char* of, const char* name) {
    for (const Attachment& a : attachments(s))
      for (const StoredField& f : stored_fields(s, a))
        if (std::string_view(a.name) == of && f.name == name) return f;
    ADD_FAILURE() << "no " << name;
    return StoredField{};
  };
  EXPECT_TRUE(field("gbuffer.diffuse", "diffuse colour").srgb);
  EXPECT_FALSE(field("gbuffer.specular", "specular colour").srgb);
  EXPECT_EQ(field("gbuffer.specular", "exponent").scale, 256);
  EXPECT_EQ(field("gbuffer.position", "position in the view").scale, 1e6);
  EXPECT_EQ(field("gbuffer.position", "position in the view").offset, -5e5);
  s.layout = Layout::exact_emission;
  s.exposure = 4;
  EXPECT_EQ(field("gbuffer.emission", "emission").scale, 0.25);
  const Attachment numbers = {"gbuffer.emission", Pass::geometry, Stores::emission, Format::rgba8,
                              "rgb: emission, sRGB-coded as displayed; a: 1"};  // as a layout file may have it
  EXPECT_EQ(stored_fields(s, numbers)[0].scale, 0.25);
}

}  // namespace
}  // namespace gbl
