#pragma once
// What the presets `compact` and `exact` promise, over scenes and cameras.
#include <fmt/format.h>

#include "app/bench.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/options.h"
#include "renderer/study/seeded_camera.h"
#include "tests/gl_fixture.h"

namespace gbl::test {

constexpr double kOneCode = 1 / 255.0, kHalfCode = 0.5 / 255;

// The preset's way of drawing in this scene, under the light that the promise is about: 64 generated lights, GGX.
inline Settings promised(const char* preset_id, const std::string& name, const Scene& scene, int camera) {
  const Settings method = preset(preset_id).make();
  Settings s;
  apply_scene(s, name, scene);
  for (const Option& o : options())
    if (o.group == Group::method) o.set(s, o.get(method), o);
  s.camera = seeded_camera(scene, s.camera, camera);
  s.size = {640, 360};
  s.lights.source = LightSource::generated;
  s.lights.count = 64, s.lights.seed = 1;
  s.shading.model = ShadingModel::ggx;
  s.shading.exponent = kExponentFromRoughness;
  s.attenuation = Attenuation::windowed;
  s.range.kind = RangeKind::source;
  s.colour = Colour::srgb;
  s.shadows = Shadows::off;  // the promise is about what is stored, not about what a shadow map knows
  s.view = {};
  return s;
}

// A picture in which `exact` is known to be beyond half a code, and why.
struct KnownExcess {
  const char* scene;  // the name's end
  int camera;
  size_t pixels;
  double worst_codes;
  const char* why;
};

class Accuracy : public GlTest {
 protected:
  void expect_promises(const std::string& name, int cameras, std::span<const KnownExcess> known = {}) {
    const auto scene = std::make_shared<const GpuScene>(open_scene(name));
    Bench bench(renderer_, cost_, {}, 1);
    for (int camera = 0; camera < cameras; ++camera)
      for (const char* id : {"compact", "exact"}) {
        const Settings s = promised(id, name, scene->scene(), camera);
        bench.start(s, scene, {.times = false});
        bench.step(true);
        const bool compact = std::string_view(id) == "compact";
        const BoundCheck b = bench.bound(compact ? kOneCode : kHalfCode);
        const std::string what =
            fmt::format("{} camera {} {} ({} B): {} of {} over, {} excused, worst {:.2f} codes at {},{}", name, camera,
                        id, bench.report().gbuffer_bytes_per_pixel, b.over, b.compared, b.excused, 255 * b.worst,
                        b.worst_pixel.x, b.worst_pixel.y);
        if (getenv("GBL_PRINT")) fmt::print("{}\n", what);
        EXPECT_GT(b.compared, 1000u) << what;
        EXPECT_LE(b.excused, b.compared / 1000) << what << ": a bound that excuses many says nothing";
        if (compact)
          EXPECT_LE(b.share_over(), 0.001) << what;
        else
          expect_exact(b, excess_of(name, camera, known), what);
        EXPECT_LE(bench.report().gbuffer_bytes_per_pixel, compact ? 16 : 20) << what;
      }
  }

 private:
  static KnownExcess excess_of(const std::string& name, int camera, std::span<const KnownExcess> known) {
    for (const KnownExcess& k : known)
      if (k.camera == camera && name.ends_with(k.scene)) return k;
    return {"", 0, 0, 0.5, ""};
  }
  static void expect_exact(const BoundCheck& b, const KnownExcess& excess, const std::string& what) {
    EXPECT_LE(b.over, excess.pixels) << what << excess.why;
    EXPECT_LE(255 * b.worst, excess.worst_codes) << what << excess.why;
  }

  Renderer renderer_;
  FrameCost cost_{true};
};

}  // namespace gbl::test
