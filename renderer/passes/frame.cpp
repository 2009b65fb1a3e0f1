#include "renderer/passes/frame.h"

#include <algorithm>
#include <cstring>

#include "renderer/gl/device.h"
#include "renderer/method_choice.h"
#include "renderer/passes/frame_block.h"
#include "renderer/passes/passes.h"

namespace gbl {
namespace {

LightOutput output_of(const Settings& s) {
  return s.accumulation.targets == AccumulationTargets::split ? LightOutput::split : LightOutput::sum;
}

bool has_transparent(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return m.alpha_mode == AlphaMode::blend; });
}

}  // namespace

gl::Defines Frame::defines() const {
  gl::Defines d = gbuffer_defines(settings);
  d.push_back({"LIGHT_KINDS", targets.light_kinds});
  return d;
}

// Views, counts and probes may follow a frame of other settings on the same device, so each of them uploads the
// frame's facts anew: they are a few hundred bytes.
Frame Renderer::frame_of(const Settings& s, const GpuScene& scene, Targets& targets) {
  const double aspect = double(s.size.x) / s.size.y;
  Frame frame{s, scene, targets, programs_, shapes_, aspect, clip_from_relative(s.camera, aspect)};
  if (s.lights.method == LightMethod::auto_) frame.settings.lights.method = targets.method;
  upload_frame_block(frame);
  return frame;
}

FrameReport Renderer::render(const Settings& s, const GpuScene& scene, Targets& targets) {
  std::vector<Light> lights = lights_of(s, scene.scene());
  const MethodChoice choice = choose_method(s, lights, gl::device().features);
  targets.prepare(s);
  targets.lights = std::move(lights);
  targets.method = choice.method;
  targets.counts_valid = targets.counts_lit_valid = targets.composed_valid = false;
  targets.light_kinds = std::any_of(targets.lights.begin(), targets.lights.end(), [](const Light& l) {
    return l.kind != LightKind::point || l.coefficients != glm::dvec3(0);
  });
  targets.count_read.drop();  // an answer still under way is the last frame's, not this one's
  targets.probe_read.drop();
  targets.timers.next_frame();
  const Frame frame = frame_of(s, scene, targets);
  upload_lights(frame);
  FrameReport report;
  {
    const gl::PassScope scope(targets.timers, "geometry");
    report.draw_calls += draw_geometry(frame);
  }
  {
    const gl::PassScope scope(targets.timers, "lighting");
    prepare_lighting(frame);
    report.draw_calls += draw_lighting(frame, output_of(s), targets.framebuffer(Pass::lighting));
  }
  {
    const gl::PassScope scope(targets.timers, "combine");
    report.draw_calls += draw_combine(frame);
  }
  if (has_transparent(scene.scene())) {
    const gl::PassScope scope(targets.timers, "forward");
    report.draw_calls += draw_forward(frame);
  }
  report.size = s.size;
  report.method = choice.method;
  report.method_reason = choice.reason;
  report.time_source = gl::time_source();
  report.gbuffer_bytes_per_pixel = gbuffer_bytes_per_pixel(s);
  report.accumulation_bytes_per_pixel = accumulation_bytes_per_pixel(s);
  report.mib = targets.mib();
  report.light_count = static_cast<int>(targets.lights.size());
  return report;
}

void Renderer::collect(Targets& targets, FrameReport& report, bool wait) {
  report.passes = targets.timers.collect(wait);
  const bool had_lit = targets.counts_lit_valid;
  if (const std::vector<float>* sums = targets.count_read.take(wait)) {
    double total[4] = {};
    for (size_t i = 0; i < sums->size(); ++i) total[i % 4] += (*sums)[i];
    report.pairs = PairCounts{uint64_t(total[0]), uint64_t(total[1]), {}};
    if (had_lit) report.pairs->lit = uint64_t(total[3]);
  }
}

std::optional<ProbeValues> Renderer::take_probe(Targets& targets, bool wait) {
  const std::vector<float>* values = targets.probe_read.take(wait);
  if (!values) return {};
  ProbeValues out;
  static_assert(sizeof out == PROBE_FIELDS * 4 * sizeof(float));
  std::memcpy(out.data(), values->data(), sizeof out);
  return out;
}

}  // namespace gbl
