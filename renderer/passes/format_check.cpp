#include "renderer/passes/format_check.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "renderer/frame/attachments.h"
#include "renderer/gbuffer/position_source.h"
#include "renderer/gl/readback.h"
#include "renderer/options/options.h"
#include "renderer/passes/canvas.h"
#include "renderer/passes/frame_block.h"
#include "renderer/passes/normal_texels.h"
#include "renderer/passes/passes.h"
#include "renderer/scene/camera.h"

namespace gbl {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The larger error; where nothing finite came back, that is the worst.
double worse(double a, double b) { return std::isnan(a) || std::isnan(b) || std::isinf(b) ? kNone : std::max(a, b); }

// ---- normals ---------------------------------------------------------------------------------------------------
constexpr glm::ivec2 kDirections{64, 64};

// Evenly over the sphere, along a spiral of the golden angle (Vogel 1979, A better way to construct the sunflower head).
std::vector<glm::vec4> directions() {
  constexpr int kCount = kDirections.x * kDirections.y;
  std::vector<glm::vec4> out;
  for (int i = 0; i < kCount; ++i) {
    const double z = 1 - 2 * (i + 0.5) / kCount, turn = 2.39996322972865 * i, flat = std::sqrt(1 - z * z);
    out.emplace_back(glm::vec3(glm::normalize(glm::dvec3(flat * std::cos(turn), flat * std::sin(turn), z))), 0);
  }
  return out;
}

FormatCheck check(NormalEncoding e, const gl::RoundingProbe& rounding) {
  Settings s;
  s.normal.encoding = e;
  const EncodingRow& r = row_of(e);
  const std::vector<glm::vec4> sent = directions();
  const gl::Buffer behind_block = gl::Buffer::make();
  const shared::FrameBlock block{};
  gl::write_uniform_block(behind_block, 0, &block, sizeof block);
  const NormalTexels got = normals_through_gpu(s, sent, kDirections);
  double error = 0;
  for (size_t i = 0; i < sent.size(); ++i)
    if (!r.lost || !r.lost(sent[i])) error = worse(error, angle_deg(glm::dvec3(sent[i]), glm::dvec3(got.decoded[i])));
  const bool nearest = rounding.half_store == gl::Rounding::to_nearest;
  const Degrees& stated = nearest ? r.error : r.toward_zero.value_or(r.error);
  // The table has three digits. An inverse square root may be off by some units in the last place.
  return {e, error, 1.005 * stated.max + 5e-5, "degrees"};
}

// ---- depth -----------------------------------------------------------------------------------------------------
constexpr int kRanges = 64;

// From the near to the far plane, each by the same factor farther.
double range_at(const Camera& c, int i) { return c.near * std::pow(c.far / c.near, (i + 0.5) / kRanges); }

// Between a stored depth and the next, near this one. Below 1 a float's arithmetic is no finer than 2^-24, whatever is stored.
double depth_step(Format f, DepthRuns runs, double depth) {
  const double arithmetic = runs == DepthRuns::reversed ? std::ldexp(depth, -23) : std::ldexp(1.0, -24);
  return row(f).channel_bits[0] < 32 ? std::max(arithmetic, std::ldexp(1.0, -row(f).channel_bits[0])) : arithmetic;
}

// Distances of surfaces, a pixel each, that went through vertex shader, clipping and depth buffer, as shaders decode them.
std::vector<double> ranges_read(const Camera& camera, Format format, DepthRuns runs) {
  constexpr glm::ivec2 kSize{kRanges, 1};
  const gl::Texture depth = gl::make_texture({.size = kSize, .format = format, .label = "format check.depth"});
  const gl::Framebuffer target = gl::make_framebuffer({.depth = &depth, .label = "format check.depth"});
  const gl::Program surface =
      gl::compile_program({"format_check.vert",
                           "uniform vec2 clip_zw;\nvoid main() {\n"
                           "  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
                           "  gl_Position = vec4(corner * clip_zw.y, clip_zw);\n}\n"},
                          {"format_check.frag", "void main() {}\n"});
  Shapes shapes;
  const bool reversed = runs == DepthRuns::reversed;
  begin_drawing(target, kSize, {.depth_write = true, .colour_write = false, .zero_to_one = reversed});
  glUseProgram(surface.id());
  const glm::dmat4 clip_from_here = clip_from_view(camera, 1, runs);
  for (int i = 0; i < kRanges; ++i) {
    const glm::dvec4 clip = clip_from_here * glm::dvec4(0, 0, -range_at(camera, i), 1);
    glUniform2f(surface.uniform("clip_zw"), static_cast<float>(clip.z), static_cast<float>(clip.w));
    glViewport(i, 0, 1, 1);
    shapes.draw_fullscreen();
  }
  const Canvas read = make_canvas({.size = kSize, .format = Format::rgba32f, .label = "format check.ranges"});
  const gl::Defines defines = {{"DEPTH_REVERSED", reversed}};
  gl::ShaderText decode = gl::load_shader("depth.glsl", defines);
  decode.body +=
      "uniform sampler2D depths;\nlayout(location = 0) out vec4 range;\nvoid main() {\n"
      "  range = vec4(range_from_depth(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).x));\n}\n";
  const gl::Program decoding = gl::compile_program(gl::load_shader("fullscreen.vert", defines), decode);
  shared::FrameBlock block{};
  block.planes = glm::vec4(camera.near, camera.far, camera.near * camera.far, camera.far - camera.near);
  const gl::Buffer buffer = gl::Buffer::make();
  gl::write_uniform_block(buffer, 0, &block, sizeof block);
  glUniformBlockBinding(decoding.id(), glGetUniformBlockIndex(decoding.id(), "FrameBlock"), 0);
  begin_drawing(read.framebuffer, kSize, {});
  gl::bind_texture("depths", depth);
  glUseProgram(decoding.id());
  shapes.draw_fullscreen();
  const std::vector<float> floats = gl::read_rgba32f(read.texture);
  std::vector<double> out;
  for (size_t i = 0; i < floats.size(); i += 4) out.push_back(floats[i]);
  return out;
}

FormatCheck check(DepthFormat f, const gl::RoundingProbe&) {
  Settings s;
  s.depth.format = f;
  Camera camera;
  camera.near = 0.1, camera.far = 1000;
  const DepthRuns runs = depth_runs(f);
  const Format format = find(attachments(s), Stores::depth)->format;
  const std::vector<double> read = ranges_read(camera, format, runs);
  double error = 0;
  for (int i = 0; i < kRanges; ++i) {
    const double range = range_at(camera, i), depth = depth_from_range(camera, range, runs);
    const double step = depth_step(format, runs, depth);
    const double step_range = std::max(std::abs(range_from_depth(camera, depth + step, runs) - range),
                                       std::abs(range_from_depth(camera, depth - step, runs) - range));
    const double decoding = std::ldexp(range, -23);  // is float arithmetic, too
    error = worse(error, std::abs(read[static_cast<size_t>(i)] - range) / (step_range + decoding));
  }
  return {f, error, 4, "steps"};  // clip coordinates, their quotient, the viewport and the store round, each by a step
}

// ---- sums of light ---------------------------------------------------------------------------------------------
constexpr int kSums = 16;

// Between a stored number and the next, near this one.
double value_step(const FormatRow& f, int channel, double value) {
  const int bits = f.channel_bits[static_cast<size_t>(channel)];
  if (f.numeric != Numeric::floating) return std::ldexp(1.0, -bits);
  const int mantissa = bits == 32 ? 23 : bits == 16 ? 10 : bits == 11 ? 6 : 5;
  return std::ldexp(1.0, std::ilogb(value) - mantissa);
}

glm::vec4 blended(Format format, float addend) {
  const Canvas sum = make_canvas({.size = {1, 1}, .format = format, .label = "format check.sum"});
  const gl::Program program = gl::compile_program(
      gl::load_shader("fullscreen.vert", {}),
      {"format_check.frag",
       "uniform float addend;\nlayout(location = 0) out vec4 colour;\nvoid main() { colour = vec4(addend); }\n"});
  Shapes shapes;
  begin_drawing(sum.framebuffer, {1, 1}, {.blend = gl::Blend::add});
  constexpr float kNothing[4] = {};
  glClearBufferfv(GL_COLOR, 0, kNothing);
  glUseProgram(program.id());
  glUniform1f(program.uniform("addend"), addend);
  for (int i = 0; i < kSums; ++i) shapes.draw_fullscreen();
  const std::vector<float> floats = gl::read_rgba32f(sum.texture);
  return {floats[0], floats[1], floats[2], floats[3]};
}

FormatCheck check(AccumulationFormat f, const gl::RoundingProbe&) {
  Settings s;
  s.accumulation.format = f, s.accumulation.targets = AccumulationTargets::one;
  const FormatRow& format = row(find(attachments(s), Stores::light)->format);
  double error = 0;
  // Small sums, and where the format has room for them sums far above 1.
  for (const double addend : {0.05, 50.0}) {
    if (format.numeric != Numeric::floating && addend > 1) continue;
    const glm::vec4 got = blended(format.format, static_cast<float>(addend));
    for (int c = 0; c < std::min(format.channels, 3); ++c)
      error = worse(error, std::abs(got[c] - kSums * addend) / value_step(format, c, kSums * addend));
  }
  return {f, error, kSums, "steps"};  // each addition rounds once, by a whole step at most
}

template <class E>
std::string name_in(const char* path, E value) {
  return fmt::format("{}={}", path, row(value).id);
}

}  // namespace

std::string name_of(StoredAs s) {
  if (const auto* e = std::get_if<NormalEncoding>(&s)) return name_in("normal.encoding", *e);
  if (const auto* d = std::get_if<DepthFormat>(&s)) return name_in("depth.format", *d);
  return name_in("accumulation.format", std::get<AccumulationFormat>(s));
}

std::vector<StoredAs> stored_by(const Settings& s) {
  return {s.normal.encoding, s.depth.format, s.accumulation.format};
}

std::vector<StoredAs> all_stored(FeatureSet features) {
  std::vector<StoredAs> out;
  for (const ValueRow& r : rows<NormalEncoding>()) out.emplace_back(static_cast<NormalEncoding>(r.value));
  for (const ValueRow& r : rows<DepthFormat>()) {
    const auto d = static_cast<DepthFormat>(r.value);
    const bool can = depth_runs(d) == DepthRuns::standard || features.has(Feature::clip_control);
    if (d != DepthFormat::auto_ && can) out.emplace_back(d);
  }
  for (const ValueRow& r : rows<AccumulationFormat>()) out.emplace_back(static_cast<AccumulationFormat>(r.value));
  return out;
}

std::string FormatCheck::said() const {
  return fmt::format("{}: known values come back {:.3g} {} off where {:.3g} are allowed", name_of(checked), error, unit,
                     bound);
}

FormatCheck check_format(StoredAs s, const gl::RoundingProbe& rounding) {
  return std::visit([&](auto value) { return check(value, rounding); }, s);
}

}  // namespace gbl
