#pragma once
// The textures of one frame: made from attachments(settings), remade only when a format or the size changes.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "renderer/frame/attachments.h"
#include "renderer/gl/buffer.h"
#include "renderer/gl/readback.h"
#include "renderer/gl/texture.h"
#include "renderer/gl/timer.h"
#include "renderer/inspect/views.h"
#include "renderer/light/light_clusters.h"
#include "renderer/light/lights.h"

namespace gbl {

// A texture with the framebuffer that draws into it alone.
struct Canvas {
  gl::Texture texture;
  gl::Framebuffer framebuffer;
};
Canvas make_canvas(const gl::TextureDesc&, const gl::Texture* depth = nullptr);

class Targets {
 public:
  // Make what these settings need; keeps what already fits. Error if the device refuses.
  void prepare(const Settings&);

  glm::ivec2 size() const { return size_; }
  const gl::Texture* texture(Stores) const;  // null if not stored
  const gl::Framebuffer& framebuffer(Pass) const;
  // Where the geometry pass draws: the G-buffer, or its samples, which resolve_samples() then averages into it.
  const gl::Framebuffer& geometry_framebuffer() const;
  void resolve_samples() const;
  const std::vector<Attachment>& attachments() const { return attachments_; }
  double mib() const;  // of the frame: what is made only to look at it or to judge it is left out

  Canvas& view(View);                    // RGBA8, made at first use
  const Canvas* drawn_view(View) const;  // null if never drawn at this size
  Canvas& composed();  // RGBA32F with a copy of the scene's depth: lit + what is drawn forward after it
  const gl::Texture& shown() const { return composed_valid ? composed_->texture : *texture(Stores::lit); }
  Canvas& counts();                            // RGBA32F: pairs tested, shaded, in range; with the lighting's depth
  const gl::Framebuffer& counts_with_depth();  // counts() with a depth buffer of its own: forward shading draws anew
  Canvas& counts_lit();
  Canvas& unblurred();   // RGBA32F: `lit` before its edges are blurred
  Canvas& ids();         // R32UI with the frame's depth: number of the object, from 1
  Canvas& count_sums();  // the reduction
  Canvas& probe();
  Canvas& errors();  // RGBA32F: signed error, -, -, 1 where a surface is

  // Frame-to-frame state that is not a picture.
  gl::PassTimers timers;
  gl::AsyncRead count_read, probe_read, error_read;
  gl::Texture light_data;
  gl::Texture light_lists;  // of the clustered method
  gl::Texture instance_data;
  std::vector<glm::vec4> record_texels;  // scratch, kept so that a steady frame allocates nothing
  bool light_kinds = false;              // is any light other than a point light?
  bool composed_valid = false;           // were transparent surfaces drawn over `lit` into composed()?
  std::vector<Light> lights;             // of the frame drawn last
  Settings drawn;                        // of the frame drawn last, with nothing left to choose
  LightMethod method{};                  // of the frame drawn last; never auto
  LightClusters clusters;                // of the frame drawn last, if its method was clustered
  gl::Buffer frame_block;
  bool counts_valid = false;  // of the frame drawn last
  bool ids_valid = false;
  bool counts_lit_valid = false;

 private:
  glm::ivec2 size_{0};
  std::vector<Attachment> attachments_;
  std::vector<gl::Texture> textures_;            // beside attachments_
  std::array<gl::Framebuffer, 3> framebuffers_;  // geometry, lighting, combine
  std::array<std::optional<Canvas>, kViewCount> views_;
  std::optional<Canvas> composed_, counts_, counts_lit_, count_sums_, probe_, unblurred_, ids_, errors_;
  gl::Texture counts_depth_, composed_depth_;
  gl::Framebuffer counts_with_depth_;
  struct Samples {
    std::vector<gl::Renderbuffer> buffers;
    gl::Framebuffer framebuffer;
    int colour_count = 0;
    bool stencil = false;
  };
  static Samples make_sampled(glm::ivec2 size, const std::vector<Attachment>&);
  std::optional<Samples> samples_;
  bool multisampled_ = false;
  Shading shading_ = Shading::deferred;
};

}  // namespace gbl
