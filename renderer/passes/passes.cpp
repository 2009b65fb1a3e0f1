#include "renderer/passes/passes.h"

#include <algorithm>

#include "renderer/gl/pass_state.h"
#include "renderer/inspect/views.h"
#include "renderer/light/light_bounds.h"
#include "renderer/passes/frame_block.h"

namespace gbl {

glm::vec3 Frame::background() const {
  switch (settings.background.fill) {
    case BackgroundFill::black: return glm::vec3(0);
    case BackgroundFill::grey: return glm::vec3(0.2f);
    case BackgroundFill::colour: return glm::vec3(settings.background.colour);
    case BackgroundFill::sky: break;  // a function of direction, in the shader
  }
  return glm::vec3(0);
}

namespace {

void bind_if_stored(const Frame& frame, Stores what, const char* sampler) {
  if (const gl::Texture* t = frame.targets().frame.texture(what)) gl::bind_texture(sampler, *t);
}

// A light's bounds on screen and half a pixel more, so that every pixel that they touch is drawn.
glm::vec4 drawn_bounds(const Frame& frame, const Light& light) {
  const ScreenBounds b = screen_bounds(frame.settings.camera, frame.resolved.aspect, light);
  if (b.empty()) return glm::vec4(2);  // no area, and beside the screen
  const glm::dvec2 half_pixel = 1.0 / glm::dvec2(frame.settings.size);
  return {b.from - half_pixel, b.to + half_pixel};
}

// The same question where depth runs the other way.
gl::DepthTest mirrored(gl::DepthTest test) {
  switch (test) {
    case gl::DepthTest::less: return gl::DepthTest::greater;
    case gl::DepthTest::less_equal: return gl::DepthTest::greater_equal;
    case gl::DepthTest::greater: return gl::DepthTest::less;
    case gl::DepthTest::greater_equal: return gl::DepthTest::less_equal;
    case gl::DepthTest::off:
    case gl::DepthTest::equal: break;
  }
  return test;
}

}  // namespace

void begin_drawing(const gl::Framebuffer& framebuffer, glm::ivec2 size, const gl::PassState& state) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glViewport(0, 0, size.x, size.y);
  gl::apply(state);
}

gl::PassState depth_tested(const Frame& frame, gl::DepthTest test, gl::PassState state) {
  const bool reversed = frame.resolved.depth_runs == DepthRuns::reversed;
  state.depth = reversed ? mirrored(test) : test;
  state.zero_to_one = reversed;
  return state;
}

void clear_depth(const Frame& frame) {
  const float farthest = frame.resolved.depth_runs == DepthRuns::reversed ? 0.0f : 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  constexpr GLint kUnmarked = 0;
  if (row(frame.targets().frame.texture(Stores::depth)->format).stencil) glClearBufferiv(GL_STENCIL, 0, &kUnmarked);
}

gl::Stencil light_stencil(const Frame& frame) {
  const Settings& s = frame.settings;
  const bool bits_are_free = s.lights.method != LightMethod::volumes_stencil;
  return s.background.skip == BackgroundSkip::stencil && bits_are_free ? gl::Stencil::only_surfaces : gl::Stencil::off;
}

void bind_gbuffer(const Frame& frame) {
  bind_if_stored(frame, Stores::material, "gbuffer_material");
  bind_if_stored(frame, Stores::normal, "gbuffer_normal");
  bind_if_stored(frame, Stores::depth, "gbuffer_depth");
  bind_if_stored(frame, Stores::reflectance, "gbuffer_reflectance");
  bind_if_stored(frame, Stores::emission, "gbuffer_emission");
  bind_if_stored(frame, Stores::ambient, "gbuffer_ambient");
  bind_if_stored(frame, Stores::shininess, "gbuffer_shininess");
  bind_if_stored(frame, Stores::position, "gbuffer_position");
  bind_if_stored(frame, Stores::id, "gbuffer_id");
}

void bind_lights(const Frame& frame) {
  gl::bind_texels("light_data", frame.targets().uploads.light_data);
  gl::bind_texels("light_traits", frame.targets().uploads.light_traits);
  if (frame.resolved.shadows.maps.empty()) return;
  gl::bind_texture("shadow_depth", frame.targets().shadows.depth);
  gl::bind_texels("shadow_records", frame.targets().shadows.records);
}

void bind_light_sums(const Frame& frame) {
  bind_if_stored(frame, Stores::light, "light_sum");
  bind_if_stored(frame, Stores::diffuse_light, "light_diffuse");
  bind_if_stored(frame, Stores::specular_light, "light_specular");
}

void upload_frame_block(Frame& frame) {
  const Settings& s = frame.settings;
  const Camera& c = s.camera;
  const ViewRays rays = view_rays(c, frame.resolved.aspect);
  shared::FrameBlock block{};
  block.clip_from_relative = glm::mat4(frame.resolved.clip_from_relative);
  block.view_from_world = glm::mat4(glm::mat4_cast(glm::conjugate(c.orientation)));
  // Float from here on, as the source's shader computes it: its noise is the pitfall.
  const glm::mat4 clip_from_world = glm::mat4(clip_from_view(c, frame.resolved.aspect, frame.resolved.depth_runs)) *
                                    block.view_from_world *
                                    glm::mat4(glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0),
                                              glm::vec4(-glm::vec3(c.position), 1));
  block.world_from_clip = glm::inverse(clip_from_world);
  block.clip_from_world = clip_from_world;
  block.ray_forward = glm::vec4(rays.forward, c.orthographic() ? 1 : 0);
  block.ray_right = glm::vec4(rays.right, 0);
  block.ray_up = glm::vec4(rays.up, 0);
  block.camera_position = glm::vec4(c.position, 0);
  block.planes = glm::vec4(c.near, c.far, c.near * c.far, c.far - c.near);
  block.viewport = glm::vec4(s.size, 1.0 / s.size.x, 1.0 / s.size.y);
  block.background = glm::vec4(frame.background(), 0);
  block.shading = glm::vec4(s.shading.exponent, s.shading.specular, s.ambient, s.exposure);
  block.light_scale = {frame.resolved.light_sum_scale, 1 / frame.resolved.light_sum_scale, 0, 0};
  const Bounds& bounds = frame.scene.scene().bounds;
  block.position_cycle = glm::vec4(position_cycle(bounds), 0, 0, 0);
  block.shadow_bias = glm::vec4(s.shadow.bias, s.shadow.slope_bias, s.shadow.normal_offset, 0);
  block.lights = glm::ivec4(frame.light_count(), 0, 0, 0);
  if (!frame.targets().uploads.frame_block) frame.targets().uploads.frame_block = gl::Buffer::make();
  gl::write_uniform_block(frame.targets().uploads.frame_block, 0, &block, sizeof block);
}

static_assert(static_cast<int>(VolumeShape::sphere) == VOLUME_SPHERE &&
              static_cast<int>(VolumeShape::cone) == VOLUME_CONE &&
              static_cast<int>(VolumeShape::screen) == VOLUME_SCREEN);

// After a texel that says how many texels hold plain lights, and how many are filled in all: plain lights, then the special ones,
// four to a texel, filled up with dark ones.
static void append_light_order(const Frame& frame, std::vector<glm::vec4>& traits) {
  const std::vector<uint32_t>& special = frame.resolved.special_lights;
  if (special.empty()) return;
  const auto dark = static_cast<float>(frame.lights().size());
  std::vector<float> order;
  const auto fill_up = [&] { order.resize((order.size() + 3) / 4 * 4, dark); };
  for (uint32_t i = 0; i < frame.lights().size(); ++i)
    if (!std::binary_search(special.begin(), special.end(), i)) order.push_back(static_cast<float>(i));
  fill_up();
  const auto plain_fours = static_cast<float>(order.size() / 4);
  order.insert(order.end(), special.begin(), special.end());
  fill_up();
  traits.emplace_back(plain_fours, static_cast<float>(order.size() / 4), 0, 0);
  for (size_t i = 0; i < order.size(); i += 4) traits.emplace_back(order[i], order[i + 1], order[i + 2], order[i + 3]);
}

void upload_lights(Frame& frame) {
  const std::vector<int>& first_maps = frame.resolved.shadows.first_map;
  std::vector<glm::vec4>&data = frame.targets().uploads.record_texels, traits;
  data.clear();
  size_t next = 0;
  for (const Light& l : frame.lights()) {
    data.emplace_back(l.position - frame.settings.camera.position, l.range);
    data.emplace_back(l.colour * frame.resolved.light_sum_scale, l.profile_range);
    const int first_map = first_maps.empty() ? -1 : first_maps[next++];
    traits.emplace_back(static_cast<int>(l.kind), static_cast<int>(volume_shape(l)), first_map, 0);
    traits.emplace_back(l.direction, l.inner_cos);
    traits.emplace_back(l.outer_cos, l.coefficients);
  }
  data.resize(data.size() + LIGHT_TEXELS * DARK_LIGHTS, glm::vec4(0));
  for (int i = 0; i < DARK_LIGHTS; ++i)
    traits.insert(traits.end(), {{LIGHT_POINT, VOLUME_SPHERE, -1, 0}, glm::vec4(0), glm::vec4(0)});
  if (frame.settings.lights.method == LightMethod::quads)
    for (const Light& l : frame.lights()) data.push_back(drawn_bounds(frame, l));
  append_light_order(frame, traits);
  upload_records(frame.targets().uploads.light_data, data, "light_data", "lights");
  upload_records(frame.targets().uploads.light_traits, traits, "light_traits", "lights' traits");
}

void upload_records(gl::TexelBuffer& table, const std::vector<glm::vec4>& texels, const char* sampler,
                    const char* label) {
  gl::write_texels(table, Format::rgba32f, texels.data(), texels.size(), label);
  gl::bind_texels(sampler, table);
}

namespace {

int draw_combined(const Frame& frame, const gl::Framebuffer& into, bool background_only) {
  gl::Defines defines = frame.defines();
  defines.push_back({"SKY", frame.settings.background.fill == BackgroundFill::sky});
  defines.push_back({"SPLIT", frame.resolved.split});
  defines.push_back({"BACKGROUND_ONLY", background_only});
  const gl::Program& program = frame.programs.get("fullscreen.vert", "combine.frag", defines);
  begin_drawing(into, frame.settings.size, {});
  bind_gbuffer(frame);
  bind_light_sums(frame);
  glUseProgram(program.id());
  frame.shapes.draw_fullscreen();
  return 1;
}

}  // namespace

int draw_combine(Frame& frame) { return draw_combined(frame, frame.framebuffer(Pass::combine), false); }
int draw_background(const Frame& frame, const gl::Framebuffer& into) { return draw_combined(frame, into, true); }

}  // namespace gbl
