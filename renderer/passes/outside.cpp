#include "renderer/passes/outside.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/options/options.h"
#include "renderer/passes/volumes.h"

namespace gbl {
namespace {

constexpr int kMostPoints = 150000;

// From what is relative to the frame's camera to the clip space outside.
glm::mat4 outside_clip(const Frame& frame, const OutsideView& v) {
  const double aspect = double(v.size.x) / v.size.y;
  const glm::dvec3 moved = frame.settings.camera.position - v.from.position;
  return glm::mat4(clip_from_relative(v.from, aspect) * glm::translate(glm::dmat4(1), moved));
}

void use(const gl::Program& program, const glm::mat4& clip) {
  glUseProgram(program.id());
  glUniformMatrix4fv(program.uniform("outside_clip"), 1, GL_FALSE, glm::value_ptr(clip));
}

// The corners of a plane across the view, from the camera: left to right below, right to left above.
std::array<glm::dvec3, 4> plane_at(const Frame& frame, double range) {
  const Camera& c = frame.settings.camera;
  const ViewRays rays = view_rays(c, frame.resolved.aspect);
  std::array<glm::dvec3, 4> out;
  constexpr glm::dvec2 kCorners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (size_t i = 0; i < 4; ++i) {
    const glm::dvec3 across = kCorners[i].x * rays.right + kCorners[i].y * rays.up;
    out[i] = c.orthographic() ? range * rays.forward + across : range * (rays.forward + across);
  }
  return out;
}

// No farther than the scene: a far plane beyond it says nothing.
double shown_far(const Frame& frame) {
  const Camera& c = frame.settings.camera;
  const Bounds& b = frame.scene.scene().bounds;
  double farthest = c.near;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y, corner & 4 ? b.max.z : b.min.z);
    farthest = std::max(farthest, glm::dot(p - c.position, c.forward()));
  }
  return std::min(farthest, c.far);
}

void draw_between(const gl::Program& program, std::span<const glm::dvec3> corners, GLenum how, glm::vec4 colour) {
  std::array<glm::vec3, 24> points{};
  for (size_t i = 0; i < corners.size(); ++i) points[i] = corners[i];
  glUniform3fv(program.uniform("corners"), static_cast<GLsizei>(points.size()), glm::value_ptr(points[0]));
  glUniform4fv(program.uniform("line_colour"), 1, glm::value_ptr(colour));
  glDrawArrays(how, 0, static_cast<GLsizei>(corners.size()));
}

void draw_frustum(const Frame& frame, const glm::mat4& clip, const gl::VertexArray& empty) {
  const gl::Program& program = frame.programs.get("outside_lines.vert", "outside_lines.frag", {});
  use(program, clip);
  glBindVertexArray(empty.id());
  const auto near = plane_at(frame, frame.settings.camera.near), far = plane_at(frame, shown_far(frame));
  const auto apex = plane_at(frame, 0);
  std::vector<glm::dvec3> lines;
  for (size_t i = 0; i < 4; ++i) {
    const size_t next = (i + 1) % 4;
    for (const glm::dvec3& p : {apex[i], far[i], near[i], near[next], far[i], far[next]}) lines.push_back(p);
  }
  draw_between(program, lines, GL_LINES, {kFrustumColour, 0.9f});
  draw_between(program, near, GL_TRIANGLE_FAN, {kNearPlaneColour, 0.5f});
}

void draw_points(const Frame& frame, const OutsideView& v, const glm::mat4& clip, const gl::Texture& positions,
                 const gl::Texture& colours, const gl::VertexArray& empty) {
  int stride = 1;
  const auto count = [&] { return (positions.size + stride - 1) / stride; };
  while (count().x * count().y > kMostPoints) ++stride;
  gl::bind_texture("positions", positions);
  gl::bind_texture("point_colours", colours);
  const gl::Program& program = frame.programs.get("outside_points.vert", "outside_points.frag", {});
  use(program, clip);
  glUniform1i(program.uniform("stride"), stride);
  glUniform1f(program.uniform("point_size"), std::max(2.0f, static_cast<float>(v.size.x) / 320));
  glBindVertexArray(empty.id());
  glDrawArrays(GL_POINTS, 0, count().x * count().y);
}

glm::ivec2 kept_faces(const Frame& frame, const Light& l, double scale) {
  const Settings& s = frame.settings;
  if (!in_use(option("lights.cull"), s)) return {1, 1};
  const double distance = glm::distance(l.position, s.camera.position);
  const Faces drawn = faces_to_draw(cull_rule(frame), distance, l.range, volume_reach(l, scale, 0));
  return {drawn != Faces::back, drawn != Faces::front};
}

void draw_light(const Frame& frame, const glm::mat4& clip) {
  const std::vector<Light>& lights = frame.lights();
  if (lights.empty()) return;
  const size_t picked = std::min(static_cast<size_t>(frame.view.pick), lights.size() - 1);
  const Light& light = lights[picked];
  const VolumeShape shape = volume_shape(light);
  if (shape == VolumeShape::screen) return;  // it has no end
  const Settings& s = frame.settings;
  const GpuVolume& mesh = frame.shapes.volume(shape, s.lights.volume.level);
  const glm::ivec2 faces = kept_faces(frame, light, volume_scale(s.lights.volume.fit, s.lights.volume.level, shape));
  bind_lights(frame);
  for (const bool wire : {true, false}) {
    gl::Defines defines = frame.defines();
    defines.push_back({"SHAPE", static_cast<int>(shape)});
    defines.push_back({"AS_WIRE", wire});
    const gl::Program& program = frame.programs.get("outside_volume.vert", "outside_volume.frag", defines);
    use(program, clip);
    set_mesh_uniforms(program, s, shape, 0);
    glUniform1i(program.uniform("light_index"), static_cast<GLint>(picked));
    glUniform2i(program.find_uniform("kept_faces"), faces.x, faces.y);
    glUniform1i(program.find_uniform("cut"), s.lights.volume.clip == VolumeClip::planes);
    glBindVertexArray(wire ? mesh.wire.id() : mesh.solid.id());
    glDrawElements(wire ? GL_LINES : GL_TRIANGLES, wire ? mesh.edge_indices : mesh.triangle_indices, GL_UNSIGNED_INT,
                   nullptr);
  }
}

}  // namespace

void Renderer::draw_outside(const OutsideView& v, View colours, const Settings& s, const GpuScene& scene,
                            Targets& targets, const Canvas& into) {
  Frame frame = frame_of(s, scene, targets);
  const Canvas positions = make_canvas({.size = s.size, .format = Format::rgba32f, .label = "outside.positions"});
  begin_drawing(positions.framebuffer, s.size, {});
  bind_gbuffer(frame);
  glUseProgram(programs_.get("fullscreen.vert", "outside_positions.frag", frame.defines()).id());
  shapes_.draw_fullscreen();

  const glm::mat4 clip = outside_clip(frame, v);
  const gl::VertexArray empty = gl::VertexArray::make();
  begin_drawing(into.framebuffer, v.size, {.depth = gl::DepthTest::less, .depth_write = true});
  constexpr float kEmpty[4] = {0.05f, 0.06f, 0.08f, 1}, kFar = 1;
  glClearBufferfv(GL_COLOR, 0, kEmpty);
  glClearBufferfv(GL_DEPTH, 0, &kFar);
  gl::let_shaders_size_points(true);
  if (const Canvas* picture = targets.canvases.drawn_view(colours))
    draw_points(frame, v, clip, positions.texture, picture->texture, empty);
  gl::let_shaders_size_points(false);
  gl::change({.depth = gl::DepthTest::less_equal, .blend = gl::Blend::alpha});
  draw_light(frame, clip);
  draw_frustum(frame, clip, empty);
}

}  // namespace gbl
