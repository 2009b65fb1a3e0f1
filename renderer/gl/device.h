#pragma once
// What this GL context is and can do, asked once at start-up.
#include <string>

#include "renderer/base/features.h"

namespace gbl::gl {

// OpenGL 3.3 core, or OpenGL ES 3.0, which is what browsers have as WebGL 2.
enum class Api { core, es3 };

enum class Rounding { to_nearest, toward_zero, other };
const char* label(Rounding);

struct Device {
  Api api = Api::core;
  std::string vendor, renderer, version, glsl;
  FeatureSet features;    // present and not switched off
  bool software = false;  // a CPU rasteriser: its times say nothing about a GPU
  int max_size = 0;       // of a texture and viewport, pixels a side
  int max_draw_buffers = 0;
  int max_texture_units = 0;  // of all stages together
  size_t max_table_texels = 0;
  int time_query_bits = 0;
};

// How stores and blends round here: GL leaves it open, llvmpipe truncates, GPUs mostly round to nearest.
struct RoundingProbe {
  Rounding half_store;  // of a value stored to RGBA16F
  Rounding half_blend;  // of a sum blended into RGBA16F
  Rounding r11_store;   // of a value stored to R11G11B10F
};
RoundingProbe probe_rounding();

// Needs a current context of GL 3.3 or GLES 3.0 or later; throws Error(no_gl) otherwise. `without` is switched off.
Device probe_device(FeatureSet without);

// The current context's device, for code that only needs features (labels, timers). Set by probe_device.
const Device& device();

}  // namespace gbl::gl
