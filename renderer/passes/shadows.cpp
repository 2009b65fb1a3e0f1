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
  t.held.clear();
}

void upload_maps(Frame& frame) {
  std::vector<glm::vec4>& records = frame.targets().uploads.record_texels;
  records.clear();
  for (const ShadowMap& m : frame.resolved.shadows.maps) {
    const glm::mat4 clip(clip_from_relative(frame.resolved.shadows, m, frame.settings.camera.position));
    for (int k = 0; k < 4; ++k) records.push_back(clip[k]);
    records.emplace_back(glm::vec2(m.corner), m.texel, std::min(m.up_to, 1e30));
  }
  upload_records(frame.targets().shadows.records, records, "shadow_records", "shadow maps");
}

}  // namespace

double shadow_mib(const ResolvedFrame& f) {
  return double(f.shadows.size.x) * f.shadows.size.y * row(format_of(f.settings.shadow.format)).bytes / (1 << 20);
}

namespace {

// Settings without those that a map's tile does not depend on beyond its matrix: what changes while people look around.
Settings maps_settings(Settings s) {
  s.camera = {}, s.time_s = 0, s.lights = {}, s.exposure = 1;
  return s;
}

// Of the plan's maps, those whose tiles hold something else.
std::vector<ShadowMap> maps_to_draw(const Frame& frame, const ShadowTargets& t) {
  const ShadowPlan& plan = frame.resolved.shadows;
  const bool all = frame.settings.shadow.update == ShadowUpdate::each_frame ||
                   t.tessellation != frame.tessellation().made() || t.reloads != frame.programs.reloads() ||
                   t.scene.lock() != frame.scene.shared_scene() || t.drawn_as != maps_settings(frame.settings);
  std::vector<ShadowMap> out;
  for (size_t k = 0; k < plan.maps.size(); ++k) {
    const ShadowMap& m = plan.maps[k];
    const bool holds =
        k < t.held.size() && t.held[k].corner == m.corner && t.held[k].clip_from_anchored == m.clip_from_anchored;
    if (all || !holds) out.push_back(m);
  }
  return out;
}

int draw_map(const Frame& frame, const ShadowMap& m, const std::vector<ObjectDraw>& casters,
             const gl::Defines& defines) {
  const ShadowPlan& plan = frame.resolved.shadows;
  glViewport(m.corner.x, m.corner.y, plan.map_texels, plan.map_texels);
  glScissor(m.corner.x, m.corner.y, plan.map_texels, plan.map_texels);
  const float farthest = 1;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  if (!is_finite(m.clip_from_anchored)) return 0;
  const glm::mat4 clip(m.clip_from_anchored);
  // Where all lines of sight meet: at the light, or nowhere.
  const glm::dvec4 eye = glm::inverse(m.clip_from_anchored) * glm::dvec4(0, 0, 1, 0);
  const bool parallel = std::abs(eye.w) < 1e-9 * glm::length(glm::dvec3(eye));
  const glm::vec4 sight(parallel ? glm::dvec4(glm::normalize(glm::dvec3(eye)), 0) : eye / eye.w);
  const auto set = [&](const gl::Program& program) {
    glUniformMatrix4fv(program.uniform("shadow_clip_from_anchored"), 1, GL_FALSE, glm::value_ptr(clip));
    glUniform4fv(program.find_uniform("sight_from"), 1, glm::value_ptr(sight));
  };
  std::vector<ObjectDraw> seen;
  for (const ObjectDraw& d : casters)
    if (may_hide(m, plan.anchor, frame.scene.bounds(*d.batch))) seen.push_back(d);
  const ObjectFaces faces = faces_of(frame.settings.shadow.cull);
  return draw_objects(frame, seen, "depth_only.frag", defines, set, Corners::shared, faces);
}

}  // namespace

int draw_shadow_maps(Frame& frame) {
  const ShadowPlan& plan = frame.resolved.shadows;
  ShadowTargets& t = frame.targets().shadows;
  make_targets(t, plan.size, format_of(frame.settings.shadow.format));
  upload_maps(frame);
  const std::vector<ShadowMap> maps = maps_to_draw(frame, t);
  if (maps.empty()) return 0;
  const std::vector<ObjectDraw> casters = prepare_casters(frame, plan.anchor);
  begin_drawing(t.framebuffer, plan.size, {.depth = gl::DepthTest::less, .depth_write = true, .colour_write = false});
  gl::Defines defines = frame.surface_defines();
  defines.push_back({"SHADOW_MAP", 1});
  defines.push_back({"SHADOW_SOLID", frame.resolved.mistaken(Mistake::shadow_leaves_solid)});
  glEnable(GL_SCISSOR_TEST);
  int calls = 0;
  for (const ShadowMap& m : maps) calls += draw_map(frame, m, casters, defines);
  glDisable(GL_SCISSOR_TEST);
  t.scene = frame.scene.shared_scene(), t.drawn_as = maps_settings(frame.settings), t.held = plan.maps;
  t.tessellation = frame.tessellation().made(), t.reloads = frame.programs.reloads();
  return calls;
}

}  // namespace gbl
