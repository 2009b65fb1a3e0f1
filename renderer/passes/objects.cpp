#include "renderer/passes/objects.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/base/random.h"
#include "renderer/passes/frame_block.h"
#include "renderer/picture/srgb.h"
#include "renderer/scene/view_culling.h"

namespace gbl {
namespace {

const Material& material_of(const Frame& frame, const GpuScene::Batch& b) {
  return frame.scene.scene().materials[b.material];
}

double distance_to(const Frame& frame, int instance) {
  const Scene& scene = frame.scene.scene();
  const glm::dvec3 centre(scene.instances[instance].world_from_object[3]);
  return glm::distance(centre, frame.settings.camera.position);
}

// What opaque objects are sorted by. Shuffled: a number that depends on nothing but the instance.
double draw_rank(const Frame& frame, int instance) {
  switch (frame.settings.draw_order) {
    case DrawOrder::near_far: return distance_to(frame, instance);
    case DrawOrder::far_near: return -distance_to(frame, instance);
    case DrawOrder::seeded: return Pcg32(static_cast<unsigned>(instance)).in(0, 1);
  }
  return 0;
}

const glm::dmat4& world_from_object_of(const Frame& frame, int instance) {
  return frame.scene.scene().instances[static_cast<size_t>(instance)].world_from_object;
}
glm::dmat4 relative_from_object_of(const Frame& frame, int instance, const glm::dvec3& origin) {
  glm::dmat4 relative_from_object = world_from_object_of(frame, instance);
  relative_from_object[3] -= glm::dvec4(origin, 0);
  return relative_from_object;
}

// Of a box in the object's coordinates. What follows a height map is not where its mesh is.
class InView {
 public:
  InView(const Frame& frame, int instance)
      : runs_(frame.resolved.depth_runs),
        clip_from_object_(frame.resolved.clip_from_relative *
                          relative_from_object_of(frame, instance, frame.settings.camera.position)) {}
  bool operator()(const Bounds& box) const { return may_be_seen(box, clip_from_object_, runs_); }

 private:
  DepthRuns runs_;
  glm::dmat4 clip_from_object_;
};

// Made in double relative to the camera, or whatever is near, and rounded once: exact far from the world's origin.
void append_record(const Frame& frame, int instance, const glm::dvec3& origin, std::vector<glm::vec4>& out) {
  const glm::dmat4& world_from_object = world_from_object_of(frame, instance);
  const glm::dmat4 relative_from_object = relative_from_object_of(frame, instance, origin);
  const glm::mat4 clip(frame.resolved.clip_from_relative * relative_from_object);
  const glm::mat4 rows(glm::transpose(relative_from_object));
  const glm::dmat3 directions(world_from_object);
  const double determinant = glm::determinant(directions);
  const glm::mat3 normals(glm::transpose(glm::inverse(directions)));
  for (int k = 0; k < 4; ++k) out.push_back(clip[k]);
  for (int k = 0; k < 3; ++k) out.push_back(rows[k]);
  const float spare[] = {determinant < 0 ? -1.0f : 1.0f, static_cast<float>(instance + 1), 0};
  for (int k = 0; k < 3; ++k) out.emplace_back(normals[k], spare[k]);
}

// Codes as if linear: a factor is then used as the code that the sRGB curve gives it.
glm::vec3 colour_factor(const glm::vec3& linear, Colour colour) {
  if (colour == Colour::srgb) return linear;
  glm::vec3 coded;
  for (int k = 0; k < 3; ++k) coded[k] = srgb_from_linear(linear[k]);
  return coded;
}

bool plain_uvs(const Material& m) {
  for (const TextureUse* use : texture_uses(m))
    if (use->texture != kNoTexture && (use->uv_set != 0 || use->uv_transform != glm::mat3(1))) return false;
  return true;
}

// Is the line of sight followed into it?
static bool sinks(const Settings& s, const Material& m) {
  return s.height_map == HeightMap::on && s.parallax.method != ParallaxMethod::none && has_heights(m);
}

// `deep`: triangles follow the height map already.
gl::Defines material_defines(const Settings& s, const Material& m, bool deep) {
  const auto has = [](const TextureUse& use) { return use.texture != kNoTexture; };
  return {{"NORMAL_MAP", s.normal_map == NormalMap::on && has(m.normal_texture)},
          {"HAS_BASE_COLOUR_MAP", has(m.base_colour_texture)},
          {"HAS_ROUGHNESS_MAP", has(m.roughness_texture)},
          {"HAS_EMISSIVE_MAP", has(m.emissive_texture)},
          {"HAS_OCCLUSION_MAP", has(m.occlusion_texture)},
          {"ALBEDO_WHITE", s.albedo == AlbedoSource::white},
          {"ALPHA_MASK", m.alpha_mode == AlphaMode::mask},
          {"BLENDED", blends(m, s.reflections == Reflections::on)},
          {"REFRACTS", s.reflections == Reflections::on && refracts(m)},
          {"UNLIT", m.unlit},
          {"PARALLAX", !deep && sinks(s, m) ? static_cast<int>(s.parallax.method) : 0},
          {"HEIGHTS", !deep && s.height_map == HeightMap::on && has_heights(m)},
          {"SPECULAR", !reflects_as_common(m)},
          {"UV_TRANSFORMS", !plain_uvs(m)}};
}

void bind_material(const Frame& frame, const gl::Program& program, const Material& m) {
  const GpuScene& scene = frame.scene;
  const Colour colour = frame.settings.colour;
  gl::bind_texture("base_colour_map", scene.colour_texture(m.base_colour_texture.texture, colour));
  gl::bind_texture("normal_map", scene.normal_texture(m.normal_texture.texture));
  gl::bind_texture("roughness_map", scene.data_texture(m.roughness_texture.texture));
  gl::bind_texture("emissive_map", scene.colour_texture(m.emissive_texture.texture, colour));
  gl::bind_texture("occlusion_map", scene.data_texture(m.occlusion_texture.texture));
  const glm::vec4 base(colour_factor(glm::vec3(m.base_colour), colour), m.base_colour.a);
  const glm::vec4 factors(m.roughness, m.metal, m.normal_scale, m.occlusion_strength);
  glUniform4fv(program.find_uniform("base_colour"), 1, glm::value_ptr(base));
  glUniform4fv(program.find_uniform("factors"), 1, glm::value_ptr(factors));
  glUniform3fv(program.find_uniform("emissive"), 1, glm::value_ptr(m.emissive));
  glUniform1f(program.find_uniform("alpha_cutoff"), m.alpha_cutoff);
  if (frame.settings.reflections == Reflections::on && refracts(m))
    glUniform2f(program.find_uniform("transmission"), m.transmission, 1 / std::max(m.refraction_index, 1.0f));
  if (sinks(frame.settings, m)) {
    const Camera& c = frame.settings.camera;
    gl::bind_texture("height_map", scene.data_texture(m.height_texture.texture));
    glUniform2f(program.find_uniform("height"), m.height_depth, static_cast<float>(frame.settings.parallax.steps));
    const glm::vec4 sight = c.orthographic() ? glm::vec4(c.forward(), 0) : glm::vec4(0, 0, 0, 1);
    glUniform4fv(program.find_uniform("sight_from"), 1, glm::value_ptr(sight));
  }
  if (!reflects_as_common(m)) {
    gl::bind_texture("specular_map", scene.data_texture(m.specular_texture.texture));
    gl::bind_texture("specular_colour_map", scene.colour_texture(m.specular_colour_texture.texture, colour));
    const float of_index = static_cast<float>(reflectance_of_index(double(m.refraction_index)) / kCommonReflectance);
    const glm::vec4 specular(colour_factor(m.specular_colour, colour) * of_index, m.specular);
    glUniform4fv(program.find_uniform("specular"), 1, glm::value_ptr(specular));
  }
  if (plain_uvs(m)) return;
  const auto textures = texture_uses(m);
  static_assert(std::tuple_size_v<decltype(textures)> == MATERIAL_TEXTURES);
  glm::mat3 transforms[MATERIAL_TEXTURES];
  int sets[MATERIAL_TEXTURES];
  for (int k = 0; k < MATERIAL_TEXTURES; ++k) {
    transforms[k] = textures[static_cast<size_t>(k)]->uv_transform;
    sets[k] = textures[static_cast<size_t>(k)]->uv_set;
  }
  glUniformMatrix3fv(program.find_uniform("uv_transform"), MATERIAL_TEXTURES, GL_FALSE, glm::value_ptr(transforms[0]));
  glUniform1iv(program.find_uniform("uv_set"), MATERIAL_TEXTURES, sets);
}

// In parts: of a large mesh, corners without sharing take many times its memory.
void draw_numbered(const Frame& frame, const ObjectDraw& draw, const gl::Program& program) {
  const size_t triangles = frame.scene.scene().meshes[static_cast<size_t>(draw.batch->mesh)].indices.size() / 3;
  for (size_t first = 0; first < triangles; first += GpuScene::kPart) {
    const GpuScene::GpuMesh part = frame.scene.unshared_part(draw.batch->mesh, first);
    glUniform1i(program.find_uniform("first_triangle"), static_cast<GLint>(first));
    glBindVertexArray(part.vertex_array.id());
    glDrawArraysInstanced(GL_TRIANGLES, 0, part.index_count, draw.count);
    if (triangles > GpuScene::kPart) glFinish();  // a driver that lags behind would hold all parts at once
  }
}

// Opaque ones as draw-order says, nearest first by default; what is blended from the farthest on.
void sort_parts(const Frame& frame, const ObjectDraw& draw, std::vector<const MeshPart*>& parts) {
  const DrawOrder order = draw.blended ? DrawOrder::far_near : frame.settings.draw_order;
  if (order == DrawOrder::seeded) return;
  std::vector<std::pair<double, const MeshPart*>> by_distance;
  for (const MeshPart* p : parts) {
    const glm::dvec3 centre(world_from_object_of(frame, draw.object) * glm::dvec4(p->box.centre(), 1));
    const double distance = glm::distance(centre, frame.settings.camera.position);
    by_distance.emplace_back(order == DrawOrder::near_far ? distance : -distance, p);
  }
  std::stable_sort(by_distance.begin(), by_distance.end(), [](auto& a, auto& b) { return a.first < b.first; });
  std::transform(by_distance.begin(), by_distance.end(), parts.begin(), [](auto& p) { return p.second; });
}

void draw_parts_in_view(const Frame& frame, const GpuScene::GpuMesh& mesh, const ObjectDraw& draw) {
  const InView in_view(frame, draw.object);
  std::vector<const MeshPart*> parts;
  for (const MeshPart& p : mesh.parts)
    if (in_view(p.box)) parts.push_back(&p);
  sort_parts(frame, draw, parts);
  std::vector<GLsizei> counts;
  std::vector<const void*> offsets;
  for (const MeshPart* p : parts) {
    counts.push_back(static_cast<GLsizei>(p->count));
    offsets.push_back(reinterpret_cast<const void*>(size_t{p->first} * sizeof(uint32_t)));
  }
  gl::draw_runs(counts, offsets);
}

// Of one object, in corners that no two triangles share.
void draw_captured(const Tessellation::Object& o) {
  glBindVertexArray(o.vertex_array.id());
  glDrawTransformFeedback(GL_TRIANGLES, o.captured.id());
}

}  // namespace

static bool drawn_forward(const Frame& frame, const Material& m) {
  return blends(m, frame.settings.reflections == Reflections::on) &&
         !frame.resolved.mistaken(Mistake::transparent_in_gbuffer);
}

enum class Wanted { in_view, all };

// `but`: an object that is left out, from 1; 0: none.
static std::vector<ObjectDraw> prepare(Frame& frame, bool transparent, const glm::dvec3& origin, int but,
                                       Wanted wanted) {
  std::vector<glm::vec4>& records = frame.targets().uploads.record_texels;
  records.clear();
  std::vector<ObjectDraw> draws;
  int next = 0;
  const auto rank = [&](int i) { return transparent ? -distance_to(frame, i) : draw_rank(frame, i); };
  std::vector<std::pair<double, ObjectDraw>> by_rank;
  for (const GpuScene::Batch& batch : frame.scene.batches()) {
    if (drawn_forward(frame, material_of(frame, batch)) != transparent) continue;
    std::vector<int> order = batch.instances;
    std::erase(order, but - 1);
    const bool culled = wanted == Wanted::in_view && !frame.tessellation().of_mesh(frame.scene, batch.mesh);
    if (culled) std::erase_if(order, [&](int i) { return !InView(frame, i)(frame.scene.mesh_bounds(batch.mesh)); });
    const auto alone = [&](int i, size_t count) { return culled && count == 1 ? i : -1; };
    if (order.empty()) continue;
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });
    if (!transparent)
      by_rank.push_back(
          {rank(order.front()), {&batch, next, static_cast<int>(order.size()), alone(order.front(), order.size())}});
    for (const int i : order) {
      if (transparent) by_rank.push_back({rank(i), {&batch, next, 1, alone(i, 1), true}});
      append_record(frame, i, origin, records);
      ++next;
    }
  }
  std::stable_sort(by_rank.begin(), by_rank.end(), [](auto& a, auto& b) { return a.first < b.first; });
  for (const auto& [key, draw] : by_rank) draws.push_back(draw);
  if (!draws.empty()) upload_records(frame.targets().uploads.instance_data, records, "instance_data", "instances");
  return draws;
}

std::vector<ObjectDraw> prepare_objects(Frame& frame, bool transparent) {
  return prepare(frame, transparent, frame.settings.camera.position, frame.targets().cut.object, Wanted::in_view);
}
std::vector<ObjectDraw> prepare_casters(Frame& frame, const glm::dvec3& origin) {
  std::vector<ObjectDraw> draws = prepare(frame, false, origin, 0, Wanted::all);
  // Clear ones hide nothing, even where they are stored.
  std::erase_if(draws, [&](const ObjectDraw& d) {
    return material_of(frame, *d.batch).alpha_mode == AlphaMode::blend &&
           !frame.resolved.mistaken(Mistake::transparent_in_gbuffer);
  });
  return draws;
}
std::vector<ObjectDraw> prepare_object(Frame& frame, int object) {
  std::vector<glm::vec4>& records = frame.targets().uploads.record_texels;
  records.clear();
  append_record(frame, object - 1, frame.settings.camera.position, records);
  upload_records(frame.targets().uploads.instance_data, records, "instance_data", "instances");
  for (const GpuScene::Batch& batch : frame.scene.batches())
    if (std::find(batch.instances.begin(), batch.instances.end(), object - 1) != batch.instances.end())
      return {{&batch, 0, 1}};
  return {};
}

// Objects behind a mirror's plane are cut away, but not what casts their shadows.
static bool clips(const Frame& frame, const gl::Defines& defines) {
  const auto holds = [&](const char* name) {
    return std::any_of(defines.begin(), defines.end(), [&](const gl::Define& d) { return d.name == name; });
  };
  return frame.targets().cut.behind && holds("CLIP_PLANE") && !holds("SHADOW_MAP");
}
static void set_clip_plane(const Frame& frame, const gl::Program& program) {
  const Plane& p = *frame.targets().cut.behind;
  const glm::vec4 relative(p.normal, p.distance(frame.settings.camera.position));
  glUniform4fv(program.uniform("clip_plane"), 1, glm::value_ptr(relative));
}

static gl::Cull cull_of(ObjectFaces faces, bool double_sided) {
  if (double_sided || faces == ObjectFaces::all) return gl::Cull::off;
  return faces == ObjectFaces::kept ? gl::Cull::back : gl::Cull::front;
}

int draw_objects(const Frame& frame, const std::vector<ObjectDraw>& draws, const char* fragment,
                 const gl::Defines& defines, const std::function<void(const gl::Program&)>& set_uniforms,
                 Corners corners, ObjectFaces faces) {
  if (draws.empty()) return 0;
  gl::bind_texels("instance_data", frame.targets().uploads.instance_data);
  const bool clipped = clips(frame, defines);
  if (clipped) gl::clip_at_plane(true);
  for (const ObjectDraw& draw : draws) {
    const Material& material = material_of(frame, *draw.batch);
    if (faces == ObjectFaces::culled && material.double_sided) continue;
    gl::Defines all = defines;
    const Tessellation::Object* tessellated = frame.tessellation().of_mesh(frame.scene, draw.batch->mesh);
    for (gl::Define& d : material_defines(frame.settings, material, tessellated != nullptr))
      all.push_back(std::move(d));
    const gl::Program& program = frame.programs.get("object.vert", fragment, all);
    glUseProgram(program.id());
    bind_material(frame, program, material);
    if (set_uniforms) set_uniforms(program);
    if (clipped) set_clip_plane(frame, program);
    glUniform1i(program.uniform("first_instance"), draw.first);
    gl::apply_cull(cull_of(faces, material.double_sided));
    gl::apply_winding(draw.batch->mirrored ? gl::Winding::clockwise : gl::Winding::counter_clockwise);
    if (tessellated) {
      if (corners == Corners::numbered) glUniform1i(program.find_uniform("first_triangle"), 0);
      draw_captured(*tessellated);
      continue;
    }
    if (corners == Corners::numbered) {
      draw_numbered(frame, draw, program);
      continue;
    }
    const GpuScene::GpuMesh& mesh = frame.scene.mesh(draw.batch->mesh);
    mesh.bind();
    if (draw.object >= 0 && mesh.parts.size() > 1)
      draw_parts_in_view(frame, mesh, draw);
    else
      glDrawElementsInstanced(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr, draw.count);
  }
  if (clipped) gl::clip_at_plane(false);
  return static_cast<int>(draws.size());
}

}  // namespace gbl
