// A pixel's probe against what the frame stores and what else reads it.
#include <bit>
#include <set>

#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Probes : public GlTest {};

constexpr glm::ivec2 kPixels[] = {{32, 30}, {5, 5}, {63, 35}, {0, 0}};

PixelProbe probe(Stage& stage, const Settings& s, glm::ivec2 pixel) {
  stage.draw(s);
  stage.renderer.start_probe(s, stage.scene, stage.targets, pixel);
  return stage.renderer.take_probe(stage.targets, true).value();
}

// The channel as whole bits from the texture's client data, laid out as the format says.
std::array<uint32_t, 4> bits_in(const gl::Texture& t, glm::ivec2 pixel) {
  const FormatRow& f = row(t.format);
  const std::vector<uint8_t> all = stored_bytes(t);
  const bool depth_stencil_float = t.format == Format::d32fs8;
  const bool floating = f.numeric == Numeric::floating;
  const size_t channel_bytes = floating || f.numeric == Numeric::depth ? 4 : static_cast<size_t>(f.channel_bits[0]) / 8;
  const size_t texel_bytes = depth_stencil_float ? 8 : channel_bytes * static_cast<size_t>(f.channels);
  const size_t texel = size_t(t.size.y - 1 - pixel.y) * t.size.x + pixel.x;
  std::array<uint32_t, 4> out{};
  for (size_t c = 0; c < size_t(f.channels); ++c)
    std::memcpy(&out[c], &all[texel * texel_bytes + c * channel_bytes], channel_bytes);
  if (t.format == Format::d24 || t.format == Format::d24s8) out[0] >>= 8;
  if (t.format == Format::d16) out[0] >>= 16;
  return out;
}

// What an IEEE-like number without a sign holds: 5 bits of exponent above `fraction` bits.
float unsigned_float(uint32_t bits, int fraction) {
  const int exponent = static_cast<int>(bits >> fraction);
  const float mantissa = static_cast<float>(bits & ((1u << fraction) - 1)) / static_cast<float>(1 << fraction);
  return exponent == 0 ? std::ldexp(mantissa, -14) : std::ldexp(1 + mantissa, exponent - 15);
}
float half_float(uint32_t bits) { return (bits & 0x8000 ? -1.0f : 1.0f) * unsigned_float(bits & 0x7fff, 10); }

// Every format that any preset stores.
TEST_F(Probes, StoredBitsAreThoseOfTheAttachment) {
  Stage stage(yard());
  std::set<Format> seen;
  for (const Preset& p : presets()) {
    Settings s = p.make();
    const Settings base = settings_for(yard(), {64, 36});
    s.scene = base.scene, s.camera = base.camera, s.size = base.size, s.lights.count = 4;
    for (const glm::ivec2 pixel : kPixels) {
      const PixelProbe found = probe(stage, s, pixel);
      ASSERT_EQ(found.stored.size(), stage.targets.frame.attachments().size()) << p.id;
      for (const StoredTexel& t : found.stored) {
        const std::array<uint32_t, 4> expected = bits_in(*stage.targets.frame.texture(t.attachment.stores), pixel);
        seen.insert(t.attachment.format);
        const FormatRow& f = row(t.attachment.format);
        for (size_t c = 0; c < size_t(f.channels); ++c) {
          if (f.numeric != Numeric::floating || f.channel_bits[c] == 32) {
            EXPECT_EQ(t.bits[c], expected[c]) << p.id << " " << t.attachment.name << " channel " << c;
          } else {  // as floats: the client data is a float, the stored bits are fewer
            const float value =
                f.channel_bits[c] == 16 ? half_float(t.bits[c]) : unsigned_float(t.bits[c], f.channel_bits[c] - 5);
            EXPECT_EQ(value, std::bit_cast<float>(expected[c])) << p.id << " " << t.attachment.name << " channel " << c;
          }
        }
      }
    }
  }
  EXPECT_GE(seen.size(), 8u) << "the presets no longer show what this is about";
}

// Depth by hand from its bits; the count by the counter's view; the object by its place in the scene.
TEST_F(Probes, DecodedFieldsAreWhatTheBitsMean) {
  Stage stage(yard());
  Settings s = settings_for(yard(), {64, 36});
  for (const DepthFormat depth : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
    s.depth.format = depth;
    const PixelProbe p = probe(stage, s, {32, 30});
    ASSERT_TRUE(p.surface());
    EXPECT_EQ(object_name(p, yard().scene()), "ground");
    for (const StoredTexel& t : p.stored) {
      if (t.attachment.stores != Stores::depth) continue;
      const int bits = row(t.attachment.format).channel_bits[0];
      const double stored =
          bits == 32 ? double(std::bit_cast<float>(t.bits[0])) : t.bits[0] / (std::exp2(double(bits)) - 1);
      EXPECT_FLOAT_EQ(p.number(ProbeField::window_depth), float(stored));
      const double n = s.camera.near, f = s.camera.far;
      EXPECT_NEAR(p.number(ProbeField::range), n * f / (f - stored * (f - n)), 1e-4 * p.number(ProbeField::range));
    }
    EXPECT_NEAR(glm::length(p.vector(ProbeField::normal)), 1, 1e-6);
    EXPECT_NEAR(p.vector(ProbeField::position).y, 0, 0.02) << "the ground, within what 16 bits of depth can tell";
    EXPECT_GT(p.number(ProbeField::lights), 0);
  }
  const PixelProbe sky = probe(stage, s, {0, 0});
  EXPECT_FALSE(sky.surface());
  EXPECT_EQ(sky.object(), 0);
  EXPECT_EQ(object_name(sky, yard().scene()), "");
}

TEST_F(Probes, HexHasAllDigitsOfEachChannel) {
  EXPECT_EQ(hex({{.format = Format::rgba8}, {0xb4, 0x8f, 0x06, 0}}), "b4 8f 06 00");
  EXPECT_EQ(hex({{.format = Format::r11g11b10f}, {0x7ff, 1, 0x3ff}}), "7ff 001 3ff");
  EXPECT_EQ(hex({{.format = Format::d24s8}, {0xf3a1}}), "00f3a1");
}

}  // namespace
}  // namespace gbl::test
