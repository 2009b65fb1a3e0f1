#include "app/micro_bench.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/pair_arithmetic.h"
#include "renderer/options/options.h"
#include "renderer/study/rows/study_row.h"

namespace gbl {
namespace {

constexpr int kFewLights = 64, kManyLights = 192;
constexpr int kRounds = 9;

struct MicroCase {
  std::string group, what;
  Settings settings;
  bool has_arithmetic = true;  // of its own: how a light is read is not in it
};

struct ReadBy {
  LightMethod method;
  const char* how;
};
constexpr ReadBy kReadBy[] = {
    {LightMethod::fullscreen, "one after the other"},
    {LightMethod::fullscreen_radius, "… and tested before they are shaded"},
    {LightMethod::clustered, "by a cluster's list"},
    {LightMethod::tiled, "by a tile's bits"},
    {LightMethod::forward_prepass, "while surfaces are drawn"},
    {LightMethod::volumes_instanced, "by a fragment of its own"},
};

std::vector<MicroCase> cases_of(Settings s) {
  s.lights.method = LightMethod::fullscreen;
  s.shading.model = ShadingModel::blinn_phong;
  s.attenuation = Attenuation::linear;
  s.lights.cull = LightCull::front, s.lights.volume.clip = VolumeClip::none;  // sound, whatever is behind the far plane
  std::vector<MicroCase> out;
  const auto add = [&](const char* group, std::string what, auto set) {
    out.push_back({group, std::move(what), s});
    set(out.back().settings);
  };
  for (const ValueRow& r : rows<ShadingModel>())
    add("shading.model", r.id, [&](Settings& of) { of.shading.model = static_cast<ShadingModel>(r.value); });
  for (const ValueRow& r : rows<Attenuation>())
    add("attenuation", r.id, [&](Settings& of) { of.attenuation = static_cast<Attenuation>(r.value); });
  for (const ReadBy& by : kReadBy)
    add("lights.method", fmt::format("{} ({})", row(by.method).id, by.how),
        [&](Settings& of) { of.lights.method = by.method; }),
        out.back().has_arithmetic = false;
  return out;
}

double frame_ms(Renderer& renderer, Settings s, int lights, const GpuScene& scene, Targets& targets) {
  s.lights.count = lights;
  FrameReport report = renderer.render(s, scene, targets);
  renderer.collect(targets, report, true);
  double sum = 0;
  for (const PassTime& p : report.passes) sum += p.ms.value_or(0);
  return sum;
}

// Few and many in turn, so that a machine that slows down slows both.
double ns_per_pair(Renderer& renderer, const Settings& s, const GpuScene& scene) {
  Targets targets;
  std::vector<double> few, many;
  for (int round = -1; round < kRounds; ++round) {
    const double a = frame_ms(renderer, s, kFewLights, scene, targets);
    const double b = frame_ms(renderer, s, kManyLights, scene, targets);
    if (round >= 0) few.push_back(a), many.push_back(b);  // the first compiles programs
  }
  const double pairs = double(s.size.x) * s.size.y * (kManyLights - kFewLights);
  return (spread_of(many).median - spread_of(few).median) * 1e6 / pairs;
}

}  // namespace

std::vector<MicroRow> run_micro_bench(Renderer& renderer, const GpuScene& scene, const Settings& s,
                                      const DeviceLimits& limits) {
  std::vector<MicroRow> out;
  for (const MicroCase& c : cases_of(s)) {
    if (!validate(c.settings, limits).empty()) continue;
    const int blocks = std::max(1, s.size.x * s.size.y / 8);
    MicroRow row{c.group, c.what, ns_per_pair(renderer, c.settings, scene), {}};
    if (c.has_arithmetic)
      row.arithmetic_ns = arithmetic_ns_per_pair(c.settings.shading.model, c.settings.attenuation, kManyLights, blocks);
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace gbl
