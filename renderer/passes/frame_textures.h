#pragma once
// The textures of one frame: made from its attachments, remade only when a format or the size changes.
#include <array>
#include <optional>
#include <vector>

#include "renderer/frame/resolved_frame.h"
#include "renderer/gl/texture.h"

namespace gbl {

class FrameTextures {
 public:
  // Make what this frame needs; keeps what already fits. True if anything was remade. Error if the device refuses, and
  // all is as before.
  bool prepare(const ResolvedFrame&);

  glm::ivec2 size() const { return size_; }
  const gl::Texture* texture(Stores) const;  // null if not stored
  const gl::Framebuffer& framebuffer(Pass) const;
  // Where the geometry pass draws: the G-buffer, or its samples, which resolve_samples() then averages into it.
  const gl::Framebuffer& geometry_framebuffer() const;
  void resolve_samples() const;
  const std::vector<Attachment>& attachments() const { return attachments_; }
  double mib() const;

 private:
  struct Samples {
    std::vector<gl::Renderbuffer> buffers;
    gl::Framebuffer framebuffer;
    int colour_count = 0;
    bool stencil = false;
  };
  static Samples make_sampled(glm::ivec2 size, const std::vector<Attachment>&);

  glm::ivec2 size_{0};
  std::vector<Attachment> attachments_;
  std::vector<gl::Texture> textures_;            // beside attachments_
  std::array<gl::Framebuffer, 3> framebuffers_;  // geometry, lighting, combine
  std::optional<Samples> samples_;
  Shading shading_ = Shading::deferred;
};

}  // namespace gbl
