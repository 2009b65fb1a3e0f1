#pragma once
// attachments(settings): the one function that says which targets a frame has, with formats and names. Textures,
// draw buffers, panel badges, file names and the bytes in every table come from it.
#include <string>
#include <vector>

#include "renderer/format.h"
#include "renderer/settings.h"

namespace gbl {

enum class Pass { geometry, lighting, combine, display };
enum class Stores {
  material,
  normal,
  reflectance,
  emission,
  depth,
  light,
  diffuse_light,
  specular_light,
  light_depth,
  lit
};

struct Attachment {
  const char* name;  // also the sampler's and the debug label's
  Pass written_by;
  Stores stores;
  Format format;
  const char* contents;  // what each channel holds
};

// In draw-buffer order within a pass; the depth attachment comes last of its pass.
std::vector<Attachment> attachments(const Settings&);

// The attachment that stores this, or null.
const Attachment* find(const std::vector<Attachment>&, Stores);

// Does a pass of these settings mark pixels? Then the depth attachment carries a stencil buffer.
bool needs_stencil(const Settings&);

// Does the lighting compare depths? Then it has a copy of the G-buffer's: to sample a texture while it is attached is
// not allowed everywhere (WebGL 2 refuses it even with writes off).
bool lighting_tests_depth(const Settings&);

// Every target that the geometry pass writes, depth included, as stored; accumulation apart.
int gbuffer_bytes_per_pixel(const Settings&);
int accumulation_bytes_per_pixel(const Settings&);

// What the layout keeps of the material: a view or a shader asks before it decodes.
struct LayoutFacts {
  bool stores_roughness;
  bool srgb_coded_albedo;         // coded in the shader; else the texture's code is stored as it is
  const char* roughness_missing;  // sentence for the panel when it is not stored
};
const LayoutFacts& facts(Layout);

}  // namespace gbl
