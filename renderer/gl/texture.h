#pragma once
// Textures and framebuffers, made from descriptions. Formats are rows of renderer/gbuffer/format.h.
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/gbuffer/format.h"
#include "renderer/gl/object.h"

namespace gbl::gl {

struct Texture {
  Object<Kind::texture> name;
  glm::ivec2 size{0};
  Format format = Format::rgba8;
  std::string label;
  GLuint id() const { return name.id(); }
};

struct TextureDesc {
  glm::ivec2 size{1, 1};
  Format format = Format::rgba8;
  bool linear_filter = false;  // else nearest: attachments are read by texel
  std::string_view label;
};
double mib_of(const Texture&);  // its texels, without mipmaps
// Its texels as squares where it is shown larger than it is, or blended; of a texture with a linear filter.
void magnify_squares(const Texture&, bool);

Texture make_texture(const TextureDesc&);  // contents undefined; Error if the driver has no room for it

enum class Address { repeat, clamp, mirror };
enum class Filtering {
  nearest,
  linear,
  nearest_mipmap_nearest,
  linear_mipmap_nearest,
  nearest_mipmap_linear,
  linear_mipmap_linear
};

struct ImageDesc {
  glm::ivec2 size{1, 1};
  const void* rgba = nullptr;        // 8 bits a channel, first row = texture row 0
  const uint16_t* rgba16 = nullptr;  // or 16, linear; not together with srgb
  bool srgb = false;                 // decoded to linear when sampled
  Address address_u = Address::repeat, address_v = Address::repeat;
  Filtering min = Filtering::linear_mipmap_linear, mag = Filtering::linear;
  std::string_view label;
};
Texture make_image(const ImageDesc&);  // with mipmaps if `min` reads them

using Framebuffer = Object<Kind::framebuffer>;
struct FramebufferDesc {
  std::vector<const Texture*> colours;  // in draw-buffer order
  const Texture* depth = nullptr;
  std::string_view label;
};
Framebuffer make_framebuffer(const FramebufferDesc&);  // Error that says why if it cannot be drawn into

// Several samples per pixel, to draw into and resolve from. Errors as above.
using Renderbuffer = Object<Kind::renderbuffer>;
Renderbuffer make_samples(glm::ivec2 size, Format, int samples, std::string_view label);
Framebuffer make_sample_framebuffer(const std::vector<const Renderbuffer*>& colours, const Renderbuffer& depth,
                                    bool stencil, std::string_view label);

// All texels from memory: rows bottom to top, four floats each, into a float format.
void write_texels(const Texture&, const void* rgba32f);

// Before texels are taken from or put into memory: rows without gaps, and memory is memory, not a buffer object.
void state_pixel_storage();

struct GlFormat {
  GLenum internal, format, type;  // type: of client data that holds the texel without loss
};
const GlFormat& gl_format(Format);

// A name for frame debuggers; nothing without Feature::debug_labels.
void set_label(GLenum kind, GLuint id, std::string_view label);

}  // namespace gbl::gl
