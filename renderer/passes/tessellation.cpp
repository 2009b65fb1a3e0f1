#include "renderer/passes/tessellation.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/gl/texture_units.h"

namespace gbl {
namespace {

static_assert(sizeof(Vertex) == 18 * sizeof(float),
              "what is captured is an array of Vertex: kCaptured in programs.cpp");

// What the triangles depend on.
Settings key_of(const Settings& s) {
  Settings key;
  key.tessellation = s.tessellation;
  if (s.mistakes.count(Mistake::tessellation_unequal_edges) > 0) key.mistakes = {Mistake::tessellation_unequal_edges};
  if (s.tessellation.mode != TessellationMode::by_distance) return key;
  key.camera.position = s.camera.position, key.camera.orthographic_height = s.camera.orthographic_height;
  return key;
}

size_t most_corners(const Mesh& mesh, int level) {
  return mesh.indices.size() * static_cast<size_t>(tessellated_triangles(level));
}

// Mesa's llvmpipe (22.3) loses what one draw makes beyond 65535 corners.
GLsizei patches_at_once(int level) {
  return static_cast<GLsizei>(std::max(1LL, 65535 / (3 * tessellated_triangles(level))));
}

}  // namespace

Tessellation::Object Tessellation::capture(ProgramCache& programs, const ResolvedFrame& f, const GpuScene& gpu,
                                           int instance) const {
  const Scene& scene = gpu.scene();
  const Settings& s = f.settings;
  const gbl::Instance& in = scene.instances[static_cast<size_t>(instance)];
  const Material& m = scene.materials[static_cast<size_t>(in.material)];
  const Mesh& mesh = scene.meshes[static_cast<size_t>(in.mesh)];
  Object out{instance};
  const std::string label = in.name + ", tessellated";
  out.corners =
      gl::make_buffer(GL_ARRAY_BUFFER, nullptr, most_corners(mesh, s.tessellation.level) * sizeof(Vertex), label);
  out.vertex_array = vertex_array_of(out.corners, nullptr);
  out.captured = gl::Object<gl::Kind::transform_feedback>::make();
  out.written = gl::Object<gl::Kind::query>::make();

  const gl::Program& program = programs.get_tessellation(
      "tessellate", {{"BY_DISTANCE", s.tessellation.mode == TessellationMode::by_distance},
                     {"MISTAKE_TESSELLATION_UNEQUAL_EDGES", f.mistaken(Mistake::tessellation_unequal_edges)}});
  glm::dmat4 relative = in.world_from_object;
  relative[3] -= glm::dvec4(s.camera.position, 0);
  const glm::dmat3 directions(in.world_from_object);
  const glm::mat4 relative_from_object(relative);
  const glm::mat3 normals(glm::transpose(glm::inverse(directions))), object_from_world(glm::inverse(directions));
  glUseProgram(program.id());
  gl::bind_texture("height_map", gpu.data_texture(m.height_texture.texture));
  glUniform1f(program.uniform("level"), static_cast<float>(s.tessellation.level));
  glUniform1f(program.uniform("height_depth"), m.height_depth);
  glUniform1f(program.find_uniform("picture_height"), static_cast<float>(s.camera.orthographic_height));
  glUniformMatrix4fv(program.find_uniform("relative_from_object"), 1, GL_FALSE, glm::value_ptr(relative_from_object));
  glUniformMatrix3fv(program.uniform("normals"), 1, GL_FALSE, glm::value_ptr(normals));
  glUniformMatrix3fv(program.uniform("object_from_world"), 1, GL_FALSE, glm::value_ptr(object_from_world));

  const GpuScene::GpuMesh& patches = gpu.mesh(in.mesh);
  patches.bind();
  glPatchParameteri(GL_PATCH_VERTICES, 3);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, out.captured.id());
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, out.corners.id());
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, out.written.id());
  glBeginTransformFeedback(GL_TRIANGLES);
  const GLsizei at_once = patches_at_once(s.tessellation.level);
  for (GLsizei first = 0; first < patches.index_count; first += 3 * at_once)
    glDrawElements(GL_PATCHES, std::min(3 * at_once, patches.index_count - first), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(sizeof(uint32_t) * static_cast<size_t>(first)));
  glEndTransformFeedback();
  glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  glDisable(GL_RASTERIZER_DISCARD);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  return out;
}

int Tessellation::update(ProgramCache& programs, const ResolvedFrame& f, const GpuScene& gpu) {
  if (f.tessellated.empty()) {
    if (!objects_.empty()) ++made_;
    objects_.clear();
    return 0;
  }
  Settings key = key_of(f.settings);
  const bool same =
      !objects_.empty() && scene_.lock() == gpu.shared_scene() && settings_ == key && reloads_ == programs.reloads();
  if (same) return 0;
  if (!framebuffer_) {
    pixel_ = gl::make_texture({.size = {1, 1}, .format = Format::rgba8, .label = "tessellation"});
    framebuffer_ = gl::make_framebuffer({.colours = {&pixel_}, .label = "tessellation"});
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  objects_.clear();  // before others are made: both would not always find room
  std::vector<Object> made;
  for (const int i : f.tessellated) made.push_back(capture(programs, f, gpu, i));
  objects_ = std::move(made), scene_ = gpu.shared_scene(), settings_ = std::move(key), reloads_ = programs.reloads();
  ++made_;
  return static_cast<int>(objects_.size());
}

const Tessellation::Object* Tessellation::of_mesh(const GpuScene& gpu, int mesh) const {
  const auto found = std::find_if(objects_.begin(), objects_.end(), [&](const Object& o) {
    return gpu.scene().instances[static_cast<size_t>(o.instance)].mesh == mesh;
  });
  return found == objects_.end() ? nullptr : &*found;
}

double Tessellation::mib() const {
  double bytes = 0;
  const std::shared_ptr<const Scene> scene = scene_.lock();
  for (const Object& o : objects_)
    if (scene) {
      const auto mesh = static_cast<size_t>(scene->instances[static_cast<size_t>(o.instance)].mesh);
      bytes += double(most_corners(scene->meshes[mesh], settings_.tessellation.level) * sizeof(Vertex));
    }
  return bytes / (1 << 20);
}

std::shared_ptr<const Scene> Tessellation::drawn(const GpuScene& gpu) const {
  if (objects_.empty()) return gpu.shared_scene();
  auto out = std::make_shared<Scene>(gpu.scene());
  for (const Object& o : objects_) {
    GLuint triangles = 0;
    glGetQueryObjectuiv(o.written.id(), GL_QUERY_RESULT, &triangles);
    gbl::Instance& in = out->instances[static_cast<size_t>(o.instance)];
    Mesh& mesh = out->meshes[static_cast<size_t>(in.mesh)];
    mesh.vertices.resize(3 * size_t(triangles));
    mesh.indices.resize(mesh.vertices.size());
    for (uint32_t k = 0; k < mesh.indices.size(); ++k) mesh.indices[k] = k;
    glBindBuffer(GL_ARRAY_BUFFER, o.corners.id());
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
                       mesh.vertices.data());
    Material flat = out->materials[static_cast<size_t>(in.material)];
    flat.height_texture = {}, flat.height_depth = 0;
    in.material = static_cast<int>(out->materials.size());
    out->materials.push_back(std::move(flat));
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return out;
}

}  // namespace gbl
