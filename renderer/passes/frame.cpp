#include "renderer/passes/frame.h"

#include <algorithm>
#include <cstring>

#include "renderer/frame/frame_lights.h"
#include "renderer/frame/method_choice.h"
#include "renderer/frame/resolve.h"
#include "renderer/gbuffer/layouts.h"
#include "renderer/gl/device.h"
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

DepthRuns Frame::depth_runs() const {
  return settings.depth.format == DepthFormat::d32f_reversed ? DepthRuns::reversed : DepthRuns::standard;
}

bool Frame::split() const { return targets.texture(Stores::diffuse_light) != nullptr; }

bool Frame::mistaken(Mistake m) const { return settings.mistakes.count(m) > 0; }

gl::Defines Frame::defines() const {
  gl::Defines d = gbuffer_defines(settings);
  append_light_defines(d, settings, targets.light_kinds);
  const bool inverse_in_vertex_shader = settings.position.reconstruct == PositionReconstruct::inverse_viewproj_varying;
  d.push_back({"VARYING_INVERSE", inverse_in_vertex_shader});
  return d;
}

gl::Defines Frame::surface_defines() const {
  gl::Defines d = gbuffer_defines(settings);
  append_surface_defines(d, settings, facts(settings.layout).keeps_emission);
  return d;
}

gl::Defines Frame::shaded_defines() const {
  gl::Defines d = gbuffer_defines(settings);
  append_surface_defines(d, settings, true);
  append_light_defines(d, settings, targets.light_kinds);
  return d;
}

// Views, counts and probes may follow a frame of other settings on the same device, so each of them uploads the
// frame's facts anew: they are a few hundred bytes.
Frame Renderer::frame_of(const Settings& s, const GpuScene& scene, Targets& targets) {
  const double aspect = double(s.size.x) / s.size.y;
  targets.drawn = resolve(s, scene.scene()).settings;
  if (s.lights.method == LightMethod::auto_) targets.drawn.lights.method = targets.method;
  Frame frame{targets.drawn,
              scene,
              targets,
              programs_,
              shapes_,
              aspect,
              clip_from_relative(s.camera, aspect, DepthRuns::standard)};
  frame.clip_from_relative = clip_from_relative(s.camera, aspect, frame.depth_runs());
  upload_frame_block(frame);
  return frame;
}

FrameReport Renderer::render(const Settings& asked, const GpuScene& scene, Targets& targets) {
  Resolved resolved = resolve(asked, scene.scene());
  std::vector<Light> lights = lights_of(asked, scene.scene());
  const MethodChoice choice = choose_method(resolved.settings, lights, gl::device().features);
  resolved.settings.lights.method = choice.method;
  const Settings& s = resolved.settings;
  targets.prepare(s);
  targets.lights = std::move(lights);
  targets.method = choice.method;
  targets.counts_valid = targets.counts_lit_valid = targets.composed_valid = targets.ids_valid = false;
  targets.light_kinds = std::any_of(targets.lights.begin(), targets.lights.end(), [](const Light& l) {
    return l.kind != LightKind::point || l.coefficients != glm::dvec3(0);
  });
  targets.count_read.drop();  // an answer still under way is the last frame's, not this one's
  targets.probe_read.drop();
  targets.error_read.drop();
  targets.timers.next_frame();
  const Frame frame = frame_of(s, scene, targets);
  upload_lights(frame);
  FrameReport report;
  const auto pass = [&](const char* name, auto draw) {
    const gl::PassScope scope(targets.timers, name);
    report.draw_calls += draw();
  };
  const gl::Framebuffer& lit = targets.framebuffer(Pass::combine);
  const Shading shading = shading_of(s.lights.method);
  if (shading == Shading::forward) {
    pass("forward", [&] { return draw_background(frame, lit) + draw_forward(frame, LightOutput::sum, lit); });
  } else {
    pass("geometry", [&] { return draw_geometry(frame); });
    pass("lighting", [&] {
      prepare_lighting(frame);  // building lists is part of what a method costs
      return draw_lighting(frame, output_of(s), targets.framebuffer(Pass::lighting));
    });
    if (shading == Shading::deferred)
      pass("combine", [&] { return draw_combine(frame); });
    else
      pass("combine", [&] { return draw_materials_over_light(frame); });
  }
  if (s.antialias == Antialias::edge_blur) pass("antialias", [&] { return draw_edge_blur(frame); });
  if (has_transparent(scene.scene()) || s.lights.markers == LightMarkers::on)
    pass("transparent", [&] { return draw_transparent(frame); });
  report.size = s.size;
  report.drawn = s;
  report.choices = std::move(resolved.notes);
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
