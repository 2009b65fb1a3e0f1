#pragma once
// Normal encodings: the shader's own text (shaders/normal_encoding.glsl) compiled for the CPU, in float and in
// double, and what each costs in bits and in degrees.
#include <glm/glm.hpp>
#include <optional>

#include "renderer/gbuffer/format.h"
#include "renderer/rows/value_row.h"

namespace gbl {

enum class NormalEncoding {
#define ENCODING(name, ...) name,
#include "renderer/gbuffer/normal_encodings.inc"
#undef ENCODING
};

// How a code lies in a texel; the constants STORAGE_… of shaders/normal_texel.glsl. Follows from the format.
enum class NormalStorage { unorm8, uints, word, floats };

// Between a direction and what is read back: mean and 99th percentile over directions uniform by area; the maximum
// bounds every direction. Three digits, held by a test over 2^20 directions that climbs from the worst of them.
struct Degrees {
  double mean, p99, max;
};

struct EncodingRow {
  ValueRow axis;
  Format format;
  int channels;  // that carry the normal
  int bits_per_channel;
  Degrees error;                              // ideal rounding to nearest
  std::optional<Degrees> toward_zero = {};    // float formats alone: there the store rounds, and may truncate
  bool (*lost)(const glm::dvec3&) = nullptr;  // the directions that the row's pitfall strikes; a sound row has none

  constexpr int bits() const { return channels * bits_per_channel; }
  // Codes are whole numbers 0..2^bits_per_channel - 1, x lowest where they share a word; else they are floats.
  constexpr bool whole_codes() const { return row(format).numeric != Numeric::floating; }
  NormalStorage storage() const;
};
const EncodingRow& row_of(NormalEncoding);

enum class StoreRounding { to_nearest, toward_zero };

// The code as it is in the attachment, and the normal that is read from it, as the frame does both: arithmetic in the
// type of `unit`, one rounding by the store. Non-finite where the encoding has no code (stereo16f at -Z).
glm::dvec3 stored_code(NormalEncoding, const glm::dvec3& unit, StoreRounding = StoreRounding::to_nearest);
glm::vec3 stored_code(NormalEncoding, const glm::vec3& unit, StoreRounding = StoreRounding::to_nearest);
glm::dvec3 stored_normal(NormalEncoding, const glm::dvec3& unit, StoreRounding = StoreRounding::to_nearest);
glm::vec3 stored_normal(NormalEncoding, const glm::vec3& unit, StoreRounding = StoreRounding::to_nearest);

double angle_deg(const glm::dvec3& a, const glm::dvec3& b);  // of unit vectors; exact for small angles

}  // namespace gbl
