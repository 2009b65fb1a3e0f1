#pragma once
// attachments(settings): the one function that says which targets a frame has, with formats and names. Textures,
// draw buffers, shader outputs, panel badges, file names and the bytes in every table come from it.
#include <string>
#include <vector>

#include "renderer/gbuffer/format.h"
#include "renderer/options/settings.h"

namespace gbl {

enum class Pass { geometry, lighting, combine, display };
enum class Stores {
  material,
  normal,
  reflectance,
  emission,
  ambient,
  shininess,
  id,
  position,
  depth,
  light,
  diffuse_light,
  specular_light,
  light_depth,
  lit
};

struct Attachment {
  const char* name;  // also the debug label's
  Pass written_by;
  Stores stores;
  Format format;
  const char* contents;  // what each channel holds
};

// In draw-buffer order within a pass; the depth attachment comes last of its pass. The layout must be resolved:
// `auto` has no attachments of its own (renderer/frame/resolve.h).
std::vector<Attachment> attachments(const Settings&);

// The attachment that stores this, or null.
const Attachment* find(const std::vector<Attachment>&, Stores);

// How a method spreads its work over passes; decides which attachments there are.
enum class Shading { deferred, forward, light_prepass };
Shading shading_of(LightMethod);

// Does the sum of light already hold ambient and emission when lighting begins?
bool sum_begins_in_geometry(const Settings&);

// Does a pass of these settings mark pixels? Then the depth attachment carries a stencil buffer.
bool needs_stencil(const Settings&);

// Does the lighting compare depths? Then it has a copy of the G-buffer's: to sample a texture while it is attached is
// not allowed everywhere (WebGL 2 refuses it even with writes off).
bool lighting_tests_depth(const Settings&);
bool lighting_has_depth(const Settings&);  // that, or the stencil beside it

// Every target that the geometry pass writes, depth included, as stored; accumulation apart.
int gbuffer_bytes_per_pixel(const Settings&);
int accumulation_bytes_per_pixel(const Settings&);

// What the panel of key 5 shows of a layout.
enum class MaterialView { roughness, specular, nothing };

// What the layout keeps of the material: a view or a shader asks before it decodes.
struct LayoutFacts {
  MaterialView shows;
  bool srgb_coded_albedo;         // coded in the shader; else the texture's code is stored as it is
  const char* roughness_missing;  // sentence for the panel when it is not stored
  bool words = false;             // the material is packed into integers
  bool keeps_emission = false;
  bool alpha_marks = false;  // alpha of the first attachment is 1 where a surface is
  bool stores_roughness() const { return roughness_missing[0] == '\0'; }
};
const LayoutFacts& facts(Layout);

// Do material and normal share one attachment under these settings?
bool normal_in_material(const Settings&);

}  // namespace gbl
