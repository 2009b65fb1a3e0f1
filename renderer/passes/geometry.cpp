// Objects into the G-buffer, nearest first.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/passes/passes.h"

namespace gbl {
namespace {

// Codes as if linear: a factor is then used as the code that the sRGB curve gives it.
glm::vec3 base_colour_of(const Material& m, Colour colour) {
  if (colour == Colour::srgb) return glm::vec3(m.base_colour);
  glm::vec3 coded;
  for (int k = 0; k < 3; ++k) {
    const float c = m.base_colour[k];
    coded[k] = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
  }
  return coded;
}

void bind_material(const Frame& frame, const gl::Program& program, const Material& m) {
  gl::bind_texture(kBaseColourUnit, frame.scene.colour_texture(m.base_colour_texture.texture, frame.settings.colour));
  gl::bind_texture(kNormalMapUnit, frame.scene.normal_texture(m.normal_texture.texture));
  gl::bind_texture(kRoughnessUnit, frame.scene.data_texture(m.roughness_texture.texture));
  glUniform3fv(program.uniform("base_colour"), 1, glm::value_ptr(base_colour_of(m, frame.settings.colour)));
  glUniform1f(program.uniform("roughness"), m.roughness);
}

// Made in double relative to the camera and rounded once: exact far from the world's origin.
void set_transform(const Frame& frame, const gl::Program& program, const glm::dmat4& world_from_object) {
  glm::dmat4 relative_from_object = world_from_object;
  relative_from_object[3] -= glm::dvec4(frame.settings.camera.position, 0);
  const glm::mat4 clip(frame.clip_from_relative * relative_from_object);
  const glm::dmat3 directions(world_from_object);
  const glm::mat3 world(directions), normals(glm::transpose(glm::inverse(directions)));
  glUniformMatrix4fv(program.uniform("clip_from_object"), 1, GL_FALSE, glm::value_ptr(clip));
  glUniformMatrix3fv(program.uniform("world_from_object"), 1, GL_FALSE, glm::value_ptr(world));
  glUniformMatrix3fv(program.uniform("world_from_object_normal"), 1, GL_FALSE, glm::value_ptr(normals));
}

std::vector<const Instance*> near_to_far(const Scene& scene, const glm::dvec3& eye) {
  std::vector<const Instance*> order;
  for (const Instance& i : scene.instances) order.push_back(&i);
  const auto distance = [&](const Instance* i) { return glm::distance(glm::dvec3(i->world_from_object[3]), eye); };
  std::stable_sort(order.begin(), order.end(), [&](auto* a, auto* b) { return distance(a) < distance(b); });
  return order;
}

gl::Defines geometry_defines(const Settings& s) {
  gl::Defines d = gbuffer_defines(s);
  d.push_back({"NORMAL_MAP", s.normal_map == NormalMap::on});
  d.push_back({"ALBEDO_WHITE", s.albedo == AlbedoSource::white});
  return d;
}

void clear_gbuffer(const Targets& targets) {
  int buffer = 0;
  for (const Attachment& a : targets.attachments()) {
    if (a.written_by != Pass::geometry) continue;
    constexpr float kZero[4] = {}, kFarthest = 1;
    constexpr GLuint kZeroCodes[4] = {};
    switch (row(a.format).numeric) {
      case Numeric::depth: glClearBufferfv(GL_DEPTH, 0, &kFarthest); break;
      case Numeric::uint: glClearBufferuiv(GL_COLOR, buffer++, kZeroCodes); break;
      default: glClearBufferfv(GL_COLOR, buffer++, kZero); break;
    }
  }
}

}  // namespace

int draw_geometry(const Frame& frame) {
  const gl::Program& program = frame.programs.get("geometry.vert", "geometry.frag", geometry_defines(frame.settings));
  begin_drawing(frame.targets.framebuffer(Pass::geometry), frame.settings.size,
                {.depth = gl::DepthTest::less, .depth_write = true, .cull = gl::Cull::back});
  clear_gbuffer(frame.targets);
  glUseProgram(program.id());
  const Scene& scene = frame.scene.scene();
  for (const Instance* instance : near_to_far(scene, frame.settings.camera.position)) {
    const GpuScene::GpuMesh& mesh = frame.scene.mesh(instance->mesh);
    bind_material(frame, program, scene.materials[instance->material]);
    set_transform(frame, program, instance->world_from_object);
    glBindVertexArray(mesh.vertex_array.id());
    glDrawElements(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr);
  }
  return static_cast<int>(scene.instances.size());
}

}  // namespace gbl
