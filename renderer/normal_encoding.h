#pragma once
// Normal encodings: the shader's own text (shaders/normal_encoding.glsl) compiled for the CPU, in float and in
// double, and what each costs in bits and in degrees.
#include <glm/glm.hpp>

#include "renderer/axes.h"

namespace gbl {

// Error over directions uniform by area, ideal rounding to nearest, to three digits; asserted by a test over 2^20
// directions. The maximum is the worst direction that climbing from the worst of those finds.
struct EncodingRow {
  NormalEncoding encoding;
  int bits;  // that carry the normal
  double mean_deg, p99_deg, max_deg;
};
const EncodingRow& row_of(NormalEncoding);

// Encode, store in the attachment's format and decode, as the frame does: `Real` arithmetic, format rounded to
// nearest. Non-finite where the encoding has no code (stereo16f at -Z).
glm::dvec3 stored_normal_f64(NormalEncoding, const glm::dvec3& unit);
glm::vec3 stored_normal_f32(NormalEncoding, const glm::vec3& unit);

double angle_deg(const glm::dvec3& a, const glm::dvec3& b);  // of unit vectors; exact for small angles

}  // namespace gbl
