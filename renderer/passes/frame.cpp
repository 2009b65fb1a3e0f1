#include "renderer/passes/frame.h"

#include <cstring>

#include "renderer/base/stopwatch.h"
#include "renderer/gbuffer/layouts.h"
#include "renderer/gl/device.h"
#include "renderer/passes/frame_block.h"
#include "renderer/passes/pass_table.h"

namespace gbl {

gl::Defines Frame::defines() const {
  gl::Defines d = gbuffer_defines(resolved);
  append_light_defines(d, resolved);
  const bool inverse_in_vertex_shader = settings.position.reconstruct == PositionReconstruct::inverse_viewproj_varying;
  d.push_back({"VARYING_INVERSE", inverse_in_vertex_shader});
  return d;
}

gl::Defines Frame::surface_defines() const {
  gl::Defines d = gbuffer_defines(resolved);
  append_surface_defines(d, settings, layout_of(settings).keeps_emission);
  d.push_back({"CLIP_PLANE", targets_.cut.behind.has_value()});
  return d;
}

gl::Defines Frame::shaded_defines() const {
  gl::Defines d = gbuffer_defines(resolved);
  append_surface_defines(d, settings, true);
  append_light_defines(d, resolved);
  d.push_back({"CLIP_PLANE", targets_.cut.behind.has_value()});
  return d;
}

std::shared_ptr<const ResolvedFrame> Renderer::resolve(const Settings& s, const GpuScene& scene) {
  return resolver_.get(s, scene.shared_scene(), gl::device().features);
}

Frame Renderer::frame_of(const Settings& s, const GpuScene& scene, Targets& targets) {
  Frame frame(resolve(s, scene), s.view, scene, targets, programs_, shapes_);
  if (!targets.cut.tessellation) targets.tessellation.update(programs_, frame.resolved, scene);
  upload_frame_block(frame);
  return frame;
}

namespace {

FrameReport report_of(const ResolvedFrame& f, const Settings& asked, const Targets& targets) {
  FrameReport report;
  report.size = asked.size;
  report.drawn = f.settings;
  report.drawn.view = asked.view;
  report.choices = f.choices;
  report.method_reason = f.method_reason;
  report.time_source = gl::time_source();
  report.gbuffer_bytes_per_pixel = f.gbuffer_bytes_per_pixel;
  report.accumulation_bytes_per_pixel = f.accumulation_bytes_per_pixel;
  report.mib = targets.frame.mib() + shadow_mib(f) + mirrors_mib(targets.mirrors) + targets.tessellation.mib();
  report.light_count = static_cast<int>(f.lights.size());
  report.light_total = f.light_total;
  return report;
}

ListReport lists_of(const ClusterTargets& t) {
  const ClusterGrid& grid = t.clusters.grid();
  return {grid.tile_px, grid.light_px, t.clusters.entry_count(), static_cast<int>(t.clusters.everywhere_count()),
          grid.looks,   t.ms};
}

// `written`: a bit for each of what passes before this one have stored.
PassTraffic traffic_of(const PassRow& pass, const ResolvedFrame& f, unsigned& written) {
  PassTraffic out{pass.timer};
  unsigned now = 0;
  for (const Attachment& a : f.attachments) {
    const unsigned bit = 1u << static_cast<unsigned>(a.stores);
    const int bytes = row(a.format).bytes;
    if (pass.reads.bits & written & bit) out.read += bytes;
    const bool begins = a.written_by == Pass::lighting && pass.draw == draw_geometry && !f.light_sum_is_begun;
    if (!(pass.writes.bits & bit) || begins) continue;
    out.written += bytes;
    now |= bit;
  }
  written |= now;
  return out;
}

}  // namespace

FrameReport Renderer::render(const Settings& asked, const GpuScene& scene, Targets& targets) {
  const std::shared_ptr<const ResolvedFrame> resolved = resolve(asked, scene);
  if (targets.frame.prepare(*resolved)) targets.canvases.forget(targets.frame.size());
  if (resolved->shadows.maps.empty()) targets.shadows = {};  // tens of megabytes that nobody reads
  targets.canvases.next_frame();
  targets.reads.drop();
  targets.timers.next_frame();
  targets.drawn = resolved;
  int calls_before = 0;
  if (resolved->tessellated.empty()) {
    targets.tessellation.update(programs_, *resolved, scene);  // lets its triangles go
  } else if (!targets.cut.tessellation) {
    const gl::PassScope scope(targets.timers, "tessellation");
    calls_before += targets.tessellation.update(programs_, *resolved, scene);
  }
  if (resolved->mirrors.empty()) {
    targets.mirrors = {};
  } else {
    const gl::PassScope scope(targets.timers, "mirrors");
    calls_before += draw_mirrored(*this, asked, *resolved, scene, targets);
  }
  // As it was resolved above: the frames in mirrors may have pushed it out of the resolver's memory.
  Frame frame(resolved, asked.view, scene, targets, programs_, shapes_);
  const Stopwatch uploading;
  upload_frame_block(frame);
  upload_lights(frame);
  const double upload_ms = uploading.ms();
  FrameReport report = report_of(*resolved, asked, targets);
  report.upload_ms = upload_ms;
  report.draw_calls = calls_before;
  unsigned written = 0;
  for (const PassRow& pass : kPasses) {
    // In a mirror only what is lit is seen, and the frame around it is timed as one.
    if (!pass.needed(*resolved) || (targets.cut.nested && pass.draw == draw_transparent)) continue;
    std::optional<gl::PassScope> scope;
    if (!targets.cut.nested) scope.emplace(targets.timers, pass.timer);
    report.draw_calls += pass.draw(frame);
    if (PassTraffic traffic = traffic_of(pass, *resolved, written); traffic.read + traffic.written > 0)
      report.traffic.push_back(std::move(traffic));
  }
  if (resolved->settings.lights.method == LightMethod::clustered && !resolved->lights.empty())
    report.lists = lists_of(targets.clusters);
  return report;
}

void Renderer::collect(Targets& targets, FrameReport& report, bool wait) {
  report.passes = targets.timers.collect(wait);
  const bool had_lit = targets.canvases.counts_lit_valid;
  if (const std::vector<float>* sums = targets.reads.counts.take(wait)) {
    double total[4] = {};
    for (size_t i = 0; i < sums->size(); ++i) total[i % 4] += (*sums)[i];
    report.pairs = PairCounts{uint64_t(total[0]), uint64_t(total[1]), {}};
    if (had_lit) report.pairs->lit = uint64_t(total[3]);
  }
}

}  // namespace gbl
