#include "renderer/gl/device.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/pass_state.h"
#include "renderer/gl/program.h"
#include "renderer/gl/texel_buffer.h"
#include "renderer/gl/texture.h"

namespace gbl::gl {
namespace {

Device g_device;

std::string text(GLenum name) {
  const auto* t = reinterpret_cast<const char*>(glGetString(name));
  return t ? t : "";
}

bool is_software(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
    if (renderer.find(name) != std::string::npos) return true;
  return false;
}

// Those of GLES that are extensions of the same calls.
FeatureSet es_features() {
  FeatureSet set;
  if (gl_version() >= 32 || has_extension("GL_KHR_debug")) set.add(Feature::debug_labels);
  if (has_extension("GL_EXT_depth_clamp")) set.add(Feature::depth_clamp);
  if (has_extension("GL_EXT_clip_control")) set.add(Feature::clip_control);
  return set;
}

FeatureSet core_features(int time_query_bits) {
  const bool gl43 = gl_version() >= 43, gl45 = gl_version() >= 45;
  FeatureSet set;
  if (gl43 || has_extension("GL_KHR_debug")) set.add(Feature::debug_labels);
  if (time_query_bits > 0) set.add(Feature::timer_query);
  if (gl_version() >= 32 || has_extension("GL_ARB_depth_clamp")) set.add(Feature::depth_clamp);
  if (gl45 || has_extension("GL_ARB_clip_control")) set.add(Feature::clip_control);
  if (gl43) set.add(Feature::compute);                     // our compute shaders are GLSL 4.30
  if (gl_version() >= 40) set.add(Feature::tessellation);  // with transform feedback objects
  return set;
}

constexpr const char* kProbeFragment = R"(
uniform vec4 u_value;
out vec4 colour;
void main() { colour = u_value; }
)";

// Stores `value` (or blends it onto `onto`) and reads it back.
float stored(Format format, float value, float onto, bool blend) {
  static const char* kVertex =
      "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n";
  const Program program = compile_program({"rounding_probe.vert", kVertex}, {"rounding_probe.frag", kProbeFragment});
  const Texture target = make_texture({.size = {1, 1}, .format = format, .label = "rounding probe"});
  const Framebuffer fbo = make_framebuffer({.colours = {&target}, .label = "rounding probe"});
  const auto vertex_array = Object<Kind::vertex_array>::make();
  glBindVertexArray(vertex_array.id());
  glBindFramebuffer(GL_FRAMEBUFFER, fbo.id());
  glViewport(0, 0, 1, 1);
  glUseProgram(program.id());
  apply({});
  glUniform4f(program.uniform("u_value"), onto, onto, onto, 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  if (blend) apply({.blend = Blend::add});
  glUniform4f(program.uniform("u_value"), value, value, value, 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  float out[4] = {};
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, out);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return out[0];
}

// 1 + 3/4 of a step of the format's mantissa lies nearer the upper neighbour.
Rounding rounding(Format format, int mantissa_bits, bool blend) {
  const float step = 1.0f / static_cast<float>(1 << mantissa_bits);
  const float got = blend ? stored(format, 0.75f * step, 1.0f, true) : stored(format, 1 + 0.75f * step, 0, false);
  if (got == 1 + step) return Rounding::to_nearest;
  return got == 1 ? Rounding::toward_zero : Rounding::other;
}

}  // namespace

const char* label(Rounding r) {
  constexpr const char* kLabels[] = {"to nearest", "toward zero", "other"};
  return kLabels[static_cast<int>(r)];
}

const Device& device() { return g_device; }

Device probe_device(FeatureSet without) {
  Device d;
  d.vendor = text(GL_VENDOR), d.renderer = text(renderer_query()), d.version = text(GL_VERSION);
  d.glsl = text(GL_SHADING_LANGUAGE_VERSION);
  d.api = is_desktop_gl() ? Api::core : Api::es3;
  const bool es = d.api == Api::es3;
  if (gl_version() < (es ? 30 : 33))
    throw Error(ExitCode::no_gl, "OpenGL", fmt::format("'{}' is older than {}", d.version, es ? "ES 3.0" : "3.3"),
                "install a newer driver, or Mesa's software driver (libgl1-mesa-dri)");
  if (es && !has_extension("GL_EXT_color_buffer_float"))
    throw Error(ExitCode::no_gl, "OpenGL ES", "this driver does not draw into floats (EXT_color_buffer_float)",
                "take another driver or browser: G-buffers and sums of light need them");
  d.software = is_software(d.renderer);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &d.max_size);
  GLint viewport[2] = {};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  d.max_size = std::min({d.max_size, viewport[0], viewport[1]});
  glGetIntegerv(GL_MAX_DRAW_BUFFERS, &d.max_draw_buffers);
  glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &d.max_texture_units);
  d.max_table_texels = max_table_texels(d);
  if (!es) glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &d.time_query_bits);
  d.features = es ? es_features() : core_features(d.time_query_bits);
  for (const FeatureRow& r : kFeatures)
    if (without.has(r.feature)) d.features.remove(r.feature);
  return g_device = d;
}

RoundingProbe probe_rounding() {
  return {rounding(Format::rgba16f, 10, false), rounding(Format::rgba16f, 10, true),
          rounding(Format::r11g11b10f, 6, false)};
}

}  // namespace gbl::gl
