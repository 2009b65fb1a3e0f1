// What mirrors show, and how it comes onto them: an ordinary frame from another camera for each flat mirror, six square ones
// for any other, added where the mirror is seen. (Tutorial 9, steps 34-43, where all share one G-buffer and the object that
// reflects is left out.)
#include <glm/gtc/type_ptr.hpp>

#include "renderer/light/shadow_maps.h"
#include "renderer/passes/objects.h"

namespace gbl {
namespace {

int side_texels(const Settings& s) { return 64 << static_cast<int>(s.reflect.size); }

// A frame that is seen in a mirror: what it reflects of lights, and nothing over it.
Settings in_a_mirror(Settings s, const Camera& camera) {
  s.reflections = Reflections::off;
  s.lights.markers = LightMarkers::off;
  s.camera = camera;
  s.view = {};
  return s;
}

void copy_lit(const Targets& from, const gl::Framebuffer& to, glm::ivec2 corner) {
  const glm::ivec2 size = from.frame.size();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.frame.framebuffer(Pass::combine).id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.id());
  glDisable(GL_SCISSOR_TEST);
  glColorMask(true, true, true, true);
  glBlitFramebuffer(0, 0, size.x, size.y, corner.x, corner.y, corner.x + size.x, corner.y + size.y, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
}

void fit(Canvas& canvas, const gl::TextureDesc& desc) {
  const gl::Texture& t = canvas.texture;
  if (!t.name || t.size != desc.size || t.format != desc.format) canvas = make_canvas(desc);
}

Targets& nested(std::unique_ptr<Targets>& targets, const Cut& cut) {
  if (!targets) targets = std::make_unique<Targets>();
  targets->cut = cut;
  return *targets;
}

int draw_flat(Renderer& renderer, const Settings& s, const GpuScene& scene, const Mirror& m, Targets& around,
              Canvas& into) {
  MirrorTargets& t = around.mirrors;
  Cut cut{.nested = true, .object = m.object, .behind = m.plane, .tessellation = &around.tessellation};
  if (s.mistakes.count(Mistake::mirror_without_clip_plane) > 0) cut.behind.reset();
  Targets& frame = nested(t.flat_frame, cut);
  const FrameReport report = renderer.render(in_a_mirror(s, mirrored(s.camera, m.plane)), scene, frame);
  fit(into, {.size = s.size, .format = frame.frame.texture(Stores::lit)->format, .label = "mirror"});
  copy_lit(frame, into.framebuffer, {0, 0});
  return report.draw_calls;
}

int draw_sides(Renderer& renderer, const Settings& s, const ResolvedFrame& f, const GpuScene& scene, Targets& around) {
  MirrorTargets& t = around.mirrors;
  const int texels = side_texels(s);
  std::vector<const Mirror*> mirrors;
  for (const Mirror& m : f.mirrors)
    if (!m.flat) mirrors.push_back(&m);
  std::vector<Settings> wanted;
  for (const Mirror* m : mirrors) {
    wanted.push_back(in_a_mirror(s, side_camera(*m, 0, texels, s.camera)));
    wanted.back().size = glm::ivec2(texels);
    wanted.back().time_s = 0;
  }
  // They depend neither on where the camera is nor on the time, but on where the lights are then.
  if (wanted == t.held && t.tessellation == around.tessellation.made() && t.reloads == renderer.reloads() &&
      f.lights == t.lights && t.scene.lock() == scene.shared_scene())
    return 0;
  t.held.clear();
  int calls = 0;
  for (size_t k = 0; k < mirrors.size(); ++k) {
    Targets& frame =
        nested(t.side_frame, {.nested = true, .object = mirrors[k]->object, .tessellation = &around.tessellation});
    for (int side = 0; side < kCubeFaces; ++side) {
      Settings one = wanted[k];
      one.time_s = s.time_s;
      one.camera = side_camera(*mirrors[k], side, texels, s.camera);
      calls += renderer.render(one, scene, frame).draw_calls;
      const gl::Texture& lit = *frame.frame.texture(Stores::lit);
      if (side == 0 && k == 0)
        fit(t.sides, {.size = {kCubeFaces * texels, static_cast<int>(mirrors.size()) * texels},
                      .format = lit.format,
                      .linear_filter = true,
                      .label = "mirror.sides"});
      copy_lit(frame, t.sides.framebuffer, {side * texels, static_cast<int>(k) * texels});
    }
  }
  t.held = wanted, t.lights = f.lights, t.tessellation = around.tessellation.made(), t.reloads = renderer.reloads(),
  t.scene = scene.shared_scene();
  return calls;
}

}  // namespace

int draw_mirrored(Renderer& renderer, const Settings& s, const ResolvedFrame& f, const GpuScene& scene,
                  Targets& around) {
  MirrorTargets& t = around.mirrors;
  size_t next = 0;
  int calls = 0;
  for (const Mirror& m : f.mirrors) {
    if (!m.flat) continue;
    if (next == t.flat.size()) t.flat.emplace_back();
    calls += draw_flat(renderer, s, scene, m, around, t.flat[next++]);
  }
  t.flat.resize(next);
  return calls + draw_sides(renderer, s, f, scene, around);
}

double mirrors_mib(const MirrorTargets& t) {
  double sum = t.sides.texture.name ? gl::mib_of(t.sides.texture) : 0;
  for (const Canvas& c : t.flat) sum += gl::mib_of(c.texture);
  for (const auto* frame : {t.flat_frame.get(), t.side_frame.get()})
    if (frame) sum += frame->frame.mib() + (frame->shadows.depth.name ? gl::mib_of(frame->shadows.depth) : 0);
  return sum;
}

int draw_reflections(Frame& frame) {
  MirrorTargets& t = frame.targets().mirrors;
  const gl::Texture &lit = frame.texture(Stores::lit), &depth = frame.texture(Stores::depth);
  t.onto_lit = gl::make_framebuffer({.colours = {&lit}, .depth = &depth, .label = "reflections"});
  bind_lights(frame);
  glm::mat3 sides[kCubeFaces];
  for (int k = 0; k < kCubeFaces; ++k) sides[k] = glm::mat3(view_of_cube_face(k));
  const int texels = side_texels(frame.settings);
  size_t next_flat = 0;
  int row = 0, calls = 0;
  for (const Mirror& m : frame.resolved.mirrors) {
    const std::vector<ObjectDraw> draw = prepare_object(frame, m.object);
    begin_drawing(t.onto_lit, frame.settings.size,
                  depth_tested(frame, gl::DepthTest::equal, {.blend = gl::Blend::add_colour}));
    gl::bind_texture("mirrored", m.flat ? t.flat[next_flat++].texture : t.sides.texture);
    gl::Defines defines = frame.shaded_defines();
    const bool box = !m.flat && frame.settings.reflect.parallax == ReflectParallax::box;
    defines.push_back({"MIRROR_FLAT", m.flat});
    defines.push_back({"MIRROR_BOX", box});
    const glm::vec4 place(0, m.flat ? 0 : texels * row++, texels, 1 / side_tangent(texels));
    calls += draw_objects(frame, draw, "reflection.frag", defines, [&](const gl::Program& program) {
      if (m.flat) return;
      glUniformMatrix3fv(program.uniform("side_from_world"), kCubeFaces, GL_FALSE, glm::value_ptr(sides[0]));
      glUniform4fv(program.uniform("side_place"), 1, glm::value_ptr(place));
      if (!box) return;
      const auto set = [&](const char* name, const glm::dvec3& world) {
        glUniform3fv(program.uniform(name), 1, glm::value_ptr(glm::vec3(world - frame.settings.camera.position)));
      };
      const Bounds& bounds = frame.scene.scene().bounds;
      set("box_low", bounds.min), set("box_high", bounds.max), set("side_centre", m.centre);
    });
  }
  return calls;
}

}  // namespace gbl
