#pragma once
// An attachment of a frame: which pass writes it, what it stores, in which format. textures, draw buffers, shader outputs,
// panel badges, file names and the bytes in every table come from the list of them (renderer/frame/attachments.h).
#include "renderer/gbuffer/format.h"

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

}  // namespace gbl
