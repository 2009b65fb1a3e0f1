#include "renderer/gl/texture.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>

#include "renderer/base/error.h"
#include "renderer/base/size_text.h"
#include "renderer/gl/device.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/gl_error.h"

namespace gbl::gl {
namespace {

constexpr GlFormat kGlFormats[] = {
    {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
    {GL_RG8, GL_RG, GL_UNSIGNED_BYTE},
    {GL_RG16UI, GL_RG_INTEGER, GL_UNSIGNED_SHORT},
    {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
    {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT},
    {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
    {GL_RG16F, GL_RG, GL_FLOAT},
    {GL_RGBA16F, GL_RGBA, GL_FLOAT},
    {GL_R11F_G11F_B10F, GL_RGB, GL_FLOAT},
    {GL_RGBA32F, GL_RGBA, GL_FLOAT},
    {GL_R32F, GL_RED, GL_FLOAT},
    {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
    {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
    {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
    {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8},
    {GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV},
};
static_assert(std::size(kGlFormats) == std::size(kFormats));

constexpr GLenum kAddress[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
constexpr GLenum kFiltering[] = {GL_NEAREST,
                                 GL_LINEAR,
                                 GL_NEAREST_MIPMAP_NEAREST,
                                 GL_LINEAR_MIPMAP_NEAREST,
                                 GL_NEAREST_MIPMAP_LINEAR,
                                 GL_LINEAR_MIPMAP_LINEAR};

void set_sampling(GLenum min, GLenum mag, GLenum wrap_u, GLenum wrap_v) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(mag));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap_u));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap_v));
}

}  // namespace

const GlFormat& gl_format(Format f) { return kGlFormats[static_cast<size_t>(f)]; }

void set_label(GLenum kind, GLuint id, std::string_view label) {
  if (!label.empty() && device().features.has(Feature::debug_labels))
    glObjectLabel(kind, id, static_cast<GLsizei>(label.size()), label.data());
}

namespace {

// "a texture of 1280x720 RGBA16F (7.0 MiB)"
std::string asked(std::string_view kind, glm::ivec2 size, std::string_view format, double bytes_per_pixel) {
  return fmt::format("{} of {} {} ({:.1f} MiB)", kind, size_text(size), format,
                     bytes_per_pixel * size.x * size.y / (1 << 20));
}

constexpr const char* kSmallerTarget = "choose a smaller size, or a layout of fewer bytes";

}  // namespace

double mib_of(const Texture& t) { return double(t.size.x) * t.size.y * row(t.format).bytes / (1 << 20); }

Texture make_texture(const TextureDesc& d) {
  Texture t{Object<Kind::texture>::make(), d.size, d.format, std::string(d.label)};
  const GlFormat& f = gl_format(d.format);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, t.id());
  state_pixel_storage();
  attempt({d.label, asked("a texture", d.size, row(d.format).label, row(d.format).bytes), kSmallerTarget}, [&] {
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(f.internal), d.size.x, d.size.y, 0, f.format, f.type, nullptr);
  });
  const GLenum filter = d.linear_filter ? GL_LINEAR : GL_NEAREST;
  set_sampling(filter, filter, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
  set_label(GL_TEXTURE, t.id(), d.label);
  return t;
}

void magnify_squares(const Texture& t, bool squares) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, t.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, squares ? GL_NEAREST : GL_LINEAR);
}

// Else half floats stand for them: eleven bits and more where it is dark.
static bool has_16_bits() { return device().api == Api::core || has_extension("GL_EXT_texture_norm16"); }
static std::vector<float> shares_of(const ImageDesc& d) {
  std::vector<float> out(4u * static_cast<size_t>(d.size.x) * static_cast<size_t>(d.size.y));
  std::transform(d.rgba16, d.rgba16 + out.size(), out.begin(), [](uint16_t word) { return float(word) / 65535; });
  return out;
}

Texture make_image(const ImageDesc& d) {
  Texture t{Object<Kind::texture>::make(), d.size, Format::rgba8, std::string(d.label)};
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, t.id());
  state_pixel_storage();
  set_sampling(kFiltering[static_cast<int>(d.min)], kFiltering[static_cast<int>(d.mag)],
               kAddress[static_cast<int>(d.address_u)], kAddress[static_cast<int>(d.address_v)]);
  const bool as_floats = d.rgba16 && !has_16_bits();
  const std::vector<float> floats = as_floats ? shares_of(d) : std::vector<float>();
  const GLint format = as_floats ? GL_RGBA16F : d.rgba16 ? GL_RGBA16 : d.srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8;
  const char* name = d.rgba16 ? "RGBA16" : d.srgb ? "sRGB8" : "RGBA8";
  attempt({d.label, asked("an image", d.size, name, d.rgba16 ? 8 : 4), "make the image smaller"}, [&] {
    const void* texels = as_floats ? floats.data() : d.rgba16 ? static_cast<const void*>(d.rgba16) : d.rgba;
    glTexImage2D(GL_TEXTURE_2D, 0, format, d.size.x, d.size.y, 0, GL_RGBA,
                 as_floats  ? GL_FLOAT
                 : d.rgba16 ? GL_UNSIGNED_SHORT
                            : GL_UNSIGNED_BYTE,
                 texels);
    if (d.min != Filtering::nearest && d.min != Filtering::linear) glGenerateMipmap(GL_TEXTURE_2D);
  });
  set_label(GL_TEXTURE, t.id(), d.label);
  return t;
}

namespace {

void require_complete(std::string_view label) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ExitCode::no_gl, label,
                fmt::format("these attachments cannot be drawn into together: {}", framebuffer_text(status)),
                "choose another layout or format");
}

}  // namespace

Renderbuffer make_samples(glm::ivec2 size, Format format, int samples, std::string_view label) {
  Renderbuffer buffer = Renderbuffer::make();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  const std::string what =
      asked(fmt::format("a {}-sample buffer", samples), size, row(format).label, double(row(format).bytes) * samples);
  attempt({label, what, kSmallerTarget}, [&] {
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, gl_format(format).internal, size.x, size.y);
  });
  set_label(GL_RENDERBUFFER, buffer.id(), label);
  return buffer;
}

Framebuffer make_sample_framebuffer(const std::vector<const Renderbuffer*>& colours, const Renderbuffer& depth,
                                    bool stencil, std::string_view label) {
  Framebuffer fbo = Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, fbo.id());
  std::vector<GLenum> buffers;
  for (const Renderbuffer* colour : colours) {
    const GLenum slot = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, slot, GL_RENDERBUFFER, colour->id());
    buffers.push_back(slot);
  }
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                            GL_RENDERBUFFER, depth.id());
  glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  set_label(GL_FRAMEBUFFER, fbo.id(), label);
  require_complete(label);
  return fbo;
}

Framebuffer make_framebuffer(const FramebufferDesc& d) {
  Framebuffer fbo = Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, fbo.id());
  std::vector<GLenum> buffers;
  for (const Texture* colour : d.colours) {
    const GLenum slot = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
    glFramebufferTexture2D(GL_FRAMEBUFFER, slot, GL_TEXTURE_2D, colour->id(), 0);
    buffers.push_back(slot);
  }
  if (d.depth) {
    const GLenum slot = row(d.depth->format).stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
    glFramebufferTexture2D(GL_FRAMEBUFFER, slot, GL_TEXTURE_2D, d.depth->id(), 0);
  }
  glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  set_label(GL_FRAMEBUFFER, fbo.id(), d.label);
  require_complete(d.label);
  return fbo;
}

void state_pixel_storage() {
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  for (const GLenum gap : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS, GL_PACK_ROW_LENGTH,
                           GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS})
    glPixelStorei(gap, 0);
  if (device().api == Api::core)
    for (const GLenum swap : {GL_UNPACK_SWAP_BYTES, GL_PACK_SWAP_BYTES}) glPixelStorei(swap, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
}

void write_texels(const Texture& t, const void* rgba32f) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, t.id());
  state_pixel_storage();
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, t.size.x, t.size.y, GL_RGBA, GL_FLOAT, rgba32f);
}

}  // namespace gbl::gl
