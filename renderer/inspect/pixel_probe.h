#pragma once
// One pixel of a frame: what is stored of it, bit by bit, and what the lighting reads there. Rows:
// shaders/probe_fields.h. To add one: a row there.
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/gbuffer/attachment.h"
#include "renderer/inspect/views.h"

namespace gbl {

enum class ProbeField {
#define PROBE_FIELD(name, ...) name,
#include "shaders/probe_fields.h"
#undef PROBE_FIELD
};

struct ProbeFieldRow {
  const char* path;
  int components;
  const char* unit;
  View view;  // that shows it: without it the field is not stored
};
std::span<const ProbeFieldRow> probe_fields();  // in the order of ProbeField
inline constexpr int kProbeFieldCount = 0
#define PROBE_FIELD(...) +1
#include "shaders/probe_fields.h"
#undef PROBE_FIELD
    ;

// An attachment's texel as it lies in memory: of each channel the low channel_bits(format) bits; a stencil is the second.
struct StoredTexel {
  Attachment attachment;
  std::array<uint32_t, 4> bits{};
  bool as_sampled = false;  // depth where only shaders read it: 24 bits within one code, and no stencil
};
// "b4 8f 6a 7d": the channels in order, each with all of its hexadecimal digits.
std::string hex(const StoredTexel&);

struct PixelProbe {
  glm::ivec2 pixel{0};  // origin top left
  std::vector<StoredTexel> stored;
  std::array<glm::vec4, kProbeFieldCount> values{};  // decoded; where a field is not stored its value means nothing

  glm::vec3 vector(ProbeField f) const { return values[static_cast<size_t>(f)]; }
  float number(ProbeField f) const { return values[static_cast<size_t>(f)].x; }
  bool surface() const { return number(ProbeField::surface) > 0.5f; }  // false: background
  int object() const { return static_cast<int>(number(ProbeField::object)); }
};

// As the scene names the object that is seen, a transparent one included; empty: none.
std::string_view object_name(const PixelProbe&, const Scene&);

}  // namespace gbl
