// Shadow maps: depth as each light sees it (Williams 1978, "Casting Curved Shadows on Curved Surfaces").
#include <glm/gtc/type_ptr.hpp>

#include "renderer/passes/frame_block.h"
#include "renderer/passes/objects.h"

namespace gbl {
namespace {

Format format_of(ShadowFormat f) {
  switch (f) {
    case ShadowFormat::d16: return Format::d16;
    case ShadowFormat::d24: return Format::d24;
    case ShadowFormat::d32f: break;
  }
  return Format::d32f;
}

ObjectFaces faces_of(ShadowCull c) {
  switch (c) {
    case ShadowCull::back: return ObjectFaces::kept;
    case ShadowCull::front: return ObjectFaces::back;
    case ShadowCull::none: break;
  }
  return ObjectFaces::all;
}

void make_targets(ShadowTargets& t, glm::ivec2 size, Format format) {
  if (t.depth.name && t.depth.size == size && t.depth.format == format) return;
  t.depth = gl::make_texture({.size = size, .format = format, .label = "shadow.depth"});
  t.framebuffer = gl::make_framebuffer({.depth = &t.depth, .label = "shadows"});
}

void upload_maps(Frame& frame) {
  std::vector<glm::vec4>& records = frame.targets().uploads.record_texels;
  records.clear();
  for (const ShadowMap& m : frame.resolved.shadows.maps) {
    const glm::mat4 clip(m.clip_from_relative);
    for (int k = 0; k < 4; ++k) records.push_back(clip[k]);
    records.emplace_back(glm::vec2(m.corner), m.texel, std::min(m.up_to, 1e30));
  }
  upload_records(frame.targets().shadows.records, records, "shadow_records", "shadow maps");
}

}  // namespace

double shadow_mib(const ResolvedFrame& f) {
  return double(f.shadows.size.x) * f.shadows.size.y * row(format_of(f.settings.shadow.format)).bytes / (1 << 20);
}

int draw_shadow_maps(Frame& frame) {
  const ShadowPlan& plan = frame.resolved.shadows;
  const Settings& s = frame.settings;
  ShadowTargets& t = frame.targets().shadows;
  make_targets(t, plan.size, format_of(s.shadow.format));
  upload_maps(frame);
  const std::vector<ObjectDraw> draws = prepare_objects(frame, false);
  begin_drawing(t.framebuffer, plan.size, {.depth = gl::DepthTest::less, .depth_write = true, .colour_write = false});
  const float farthest = 1;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  gl::Defines defines = frame.surface_defines();
  defines.push_back({"SHADOW_MAP", 1});
  int calls = 0;
  for (const ShadowMap& m : plan.maps) {
    glViewport(m.corner.x, m.corner.y, plan.map_texels, plan.map_texels);
    const glm::mat4 clip(m.clip_from_relative);
    const auto set = [&](const gl::Program& program) {
      glUniformMatrix4fv(program.uniform("shadow_clip_from_relative"), 1, GL_FALSE, glm::value_ptr(clip));
    };
    std::vector<ObjectDraw> seen;
    for (const ObjectDraw& d : draws)
      if (may_hide(m, s.camera.position, frame.scene.bounds(*d.batch))) seen.push_back(d);
    calls += draw_objects(frame, seen, "depth_only.frag", defines, set, Corners::shared, faces_of(s.shadow.cull));
  }
  return calls;
}

}  // namespace gbl
