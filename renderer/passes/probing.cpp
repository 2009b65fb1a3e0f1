// One pixel, stored and decoded (renderer/inspect/pixel_probe.h), read back without waiting.
#include <cstring>

#include "renderer/gl/transfer.h"
#include "renderer/passes/frame_block.h"
#include "renderer/passes/lighting.h"

namespace gbl {

void Renderer::start_probe(const Settings& s, const GpuScene& scene, Targets& targets, glm::ivec2 pixel) {
  if (!targets.canvases.counts_valid) count_pairs(s, scene, targets, false);
  Frame frame = frame_of(s, scene, targets);
  gl::Defines defines = frame.defines();
  defines.push_back({"SPLIT", frame.resolved.split});
  const gl::Program& program = programs_.get("fullscreen.vert", "probe.frag", defines);
  draw_ids(frame);
  Canvas& canvas = targets.canvases.probe();
  begin_drawing(canvas.framebuffer, canvas.texture.size, {});
  bind_gbuffer(frame);
  bind_light_sums(frame);
  gl::bind_texture("lit", frame.texture(Stores::lit));
  gl::bind_texture("counts", targets.canvases.counts().texture);
  gl::bind_texture("ids", targets.canvases.ids().texture);
  glUseProgram(program.id());
  const glm::ivec2 texel{pixel.x, s.size.y - 1 - pixel.y};
  glUniform2i(program.uniform("pixel"), texel.x, texel.y);
  shapes_.draw_fullscreen();

  ProbeReads& reads = targets.reads.probe;
  reads.pixel = pixel;
  std::vector<const gl::Texture*> stored;
  for (const Attachment& a : targets.frame.attachments()) stored.push_back(targets.frame.texture(a.stores));
  reads.stored.start(stored, texel);
  reads.values.start(canvas.texture);
}

static StoredTexel stored_texel(Attachment a, const std::array<uint32_t, 4>& bits) {
  const bool as_sampled = row(a.format).numeric == Numeric::depth && !gl::reads_depth();
  if (as_sampled) a.contents = "window depth as shaders sample it: 24 bits within one code";
  return {a, bits, as_sampled};
}

std::optional<PixelProbe> Renderer::take_probe(Targets& targets, bool wait) {
  const std::vector<float>* values = targets.reads.probe.values.take(wait);
  if (!values) return {};
  PixelProbe out{.pixel = targets.reads.probe.pixel};
  std::memcpy(out.values.data(), values->data(), sizeof out.values);
  const auto bits = targets.reads.probe.stored.take(true);  // it was asked for first: it has come
  const std::vector<Attachment>& attachments = targets.frame.attachments();
  for (size_t i = 0; bits && i < bits->size(); ++i) out.stored.push_back(stored_texel(attachments[i], (*bits)[i]));
  return out;
}

}  // namespace gbl
