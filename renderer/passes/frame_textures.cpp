#include "renderer/passes/frame_textures.h"

#include <string_view>

#include "renderer/gl/pass_state.h"

namespace gbl {
namespace {

bool same(const std::vector<Attachment>& a, const std::vector<Attachment>& b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i)
    if (std::string_view(a[i].name) != b[i].name || a[i].format != b[i].format) return false;
  return true;
}

constexpr int kSamples = 4;

// A pass draws into what it writes first; the sum that geometry began is lit as well, and what is drawn after the
// lighting with geometry needs its depth.
bool draws_into(const Attachment& a, Pass pass, Shading shading) {
  if (a.written_by == pass) return true;
  if (pass == Pass::lighting) return a.stores == Stores::light;
  return pass == Pass::combine && a.stores == Stores::depth && shading != Shading::deferred;
}

}  // namespace

FrameTextures::Samples FrameTextures::make_sampled(glm::ivec2 size, const std::vector<Attachment>& wanted) {
  Samples out;
  std::vector<size_t> colours;
  size_t depth = 0;
  for (const Attachment& a : wanted) {
    if (a.written_by != Pass::geometry) continue;
    if (a.stores == Stores::depth) {
      depth = out.buffers.size();
      out.stencil = row(a.format).stencil;
    } else
      colours.push_back(out.buffers.size());
    out.buffers.push_back(gl::make_samples(size, a.format, kSamples, a.name));
  }
  std::vector<const gl::Renderbuffer*> attached;
  for (const size_t i : colours) attached.push_back(&out.buffers[i]);
  out.framebuffer = gl::make_sample_framebuffer(attached, out.buffers[depth], out.stencil, "gbuffer.samples");
  out.colour_count = static_cast<int>(colours.size());
  return out;
}

const gl::Framebuffer& FrameTextures::geometry_framebuffer() const {
  return samples_ ? samples_->framebuffer : framebuffer(Pass::geometry);
}

// One attachment at a time, and each mean as the driver makes it; integers and depth take one of the samples.
void FrameTextures::resolve_samples() const {
  if (!samples_) return;
  gl::apply({});
  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_->framebuffer.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer(Pass::geometry).id());
  const GLbitfield depth_bits = GL_DEPTH_BUFFER_BIT | (samples_->stencil ? GL_STENCIL_BUFFER_BIT : 0u);
  glDepthMask(true);
  glStencilMask(0xff);
  std::vector<GLenum> all;
  for (int i = 0; i < samples_->colour_count; ++i) {
    const GLenum slot = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    std::vector<GLenum> only(static_cast<size_t>(i) + 1, GL_NONE);
    only.back() = slot;
    glReadBuffer(slot);
    glDrawBuffers(static_cast<GLsizei>(only.size()), only.data());
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT | (i == 0 ? depth_bits : 0u),
                      GL_NEAREST);
    all.push_back(slot);
  }
  glDrawBuffers(static_cast<GLsizei>(all.size()), all.data());
}

bool FrameTextures::prepare(const ResolvedFrame& frame) {
  const glm::ivec2 size = frame.settings.size;
  if (size_ == size && same(frame.attachments, attachments_) && frame.shading == shading_ &&
      frame.multisampled == samples_.has_value())
    return false;
  std::vector<gl::Texture> textures;
  for (const Attachment& a : frame.attachments)
    textures.push_back(gl::make_texture({.size = size, .format = a.format, .label = a.name}));
  std::array<gl::Framebuffer, 3> framebuffers;
  for (const Pass pass : {Pass::geometry, Pass::lighting, Pass::combine}) {
    gl::FramebufferDesc desc{.label = pass == Pass::geometry ? "gbuffer" : pass == Pass::lighting ? "light" : "lit"};
    for (size_t i = 0; i < textures.size(); ++i) {
      const Attachment& a = frame.attachments[i];
      if (!draws_into(a, pass, frame.shading)) continue;
      if (row(a.format).numeric == Numeric::depth)
        desc.depth = &textures[i];
      else
        desc.colours.push_back(&textures[i]);
    }
    if (desc.depth || !desc.colours.empty()) framebuffers[static_cast<int>(pass)] = gl::make_framebuffer(desc);
  }
  std::optional<Samples> samples;
  if (frame.multisampled) samples = make_sampled(size, frame.attachments);
  // Everything new exists: only now let go of the old.
  samples_ = std::move(samples);
  shading_ = frame.shading;
  size_ = size;
  attachments_ = frame.attachments;
  textures_ = std::move(textures);
  framebuffers_ = std::move(framebuffers);
  return true;
}

const gl::Texture* FrameTextures::texture(Stores what) const {
  for (size_t i = 0; i < attachments_.size(); ++i)
    if (attachments_[i].stores == what) return &textures_[i];
  return nullptr;
}

const gl::Framebuffer& FrameTextures::framebuffer(Pass pass) const { return framebuffers_[static_cast<int>(pass)]; }

double FrameTextures::mib() const {
  double sum = 0;
  for (const gl::Texture& t : textures_) sum += gl::mib_of(t);
  return sum;
}

}  // namespace gbl
