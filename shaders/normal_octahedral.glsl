// Normals as a point of the unfolded octahedron: see normal_encoding.glsl, which includes this.

// ---- octahedral: Meyer, Suessmuth, Sussner, Stamminger, Greiner 2010, "On floating-point normal vectors";
//      Cigolle et al. 2014, "A survey of efficient representations for independent unit vectors"
vec2 oct_from_normal(vec3 n) {
  real l1 = abs(n.x) + abs(n.y) + abs(n.z);
  real x = n.x / l1;
  real y = n.y / l1;
  if (n.z < real(0.0)) {
    real fx = (real(1.0) - abs(y)) * sign_not_zero(x);
    real fy = (real(1.0) - abs(x)) * sign_not_zero(y);
    return vec2(fx, fy);
  }
  return vec2(x, y);
}

// The point of the octahedron, not yet of the sphere.
vec3 point_from_oct(vec2 p) {
  real z = real(1.0) - abs(p.x) - abs(p.y);
  real x = p.x;
  real y = p.y;
  if (z < real(0.0)) {
    x = (real(1.0) - abs(p.y)) * sign_not_zero(p.x);
    y = (real(1.0) - abs(p.x)) * sign_not_zero(p.y);
  }
  return vec3(x, y, z);
}

vec3 encode_oct(vec3 n, real levels) {
  vec2 p = oct_from_normal(n);
  return vec3(code_from_snorm(p.x, levels), code_from_snorm(p.y, levels), real(0.0));
}
vec3 point_from_oct_code(vec3 code, real levels) {
  return point_from_oct(vec2(snorm_from_code(code.x, levels), snorm_from_code(code.y, levels)));
}
vec3 decode_oct(vec3 code, real levels) { return normalize(point_from_oct_code(code, levels)); }

// 2^bits - 2, not 2^bits - 1: with an even number of steps the middle code is exactly 0.
vec3 encode_oct8(vec3 n) { return encode_oct(n, real(254.0)); }
vec3 decode_oct8(vec3 code) { return decode_oct(code, real(254.0)); }
vec3 encode_oct10(vec3 n) { return encode_oct(n, real(1022.0)); }
vec3 decode_oct10(vec3 code) { return decode_oct(code, real(1022.0)); }
vec3 encode_oct12(vec3 n) { return encode_oct(n, real(4094.0)); }
vec3 decode_oct12(vec3 code) { return decode_oct(code, real(4094.0)); }
vec3 encode_oct14(vec3 n) { return encode_oct(n, real(16382.0)); }
vec3 decode_oct14(vec3 code) { return decode_oct(code, real(16382.0)); }
vec3 encode_oct16(vec3 n) { return encode_oct(n, real(65534.0)); }
vec3 decode_oct16(vec3 code) { return decode_oct(code, real(65534.0)); }

// The best of the four codes around the point instead of the nearest (Cigolle et al. 2014). The nearest is
// tried first and stays at a tie, so the result is never worse than oct16's.
vec3 encode_oct16_precise(vec3 n) {
  real levels = real(65534.0);
  vec2 p = oct_from_normal(n);
  vec3 best = encode_oct(n, levels);
  real least = sine2(point_from_oct_code(best, levels), n);
  real x = floor((p.x * real(0.5) + real(0.5)) * levels);
  real y = floor((p.y * real(0.5) + real(0.5)) * levels);
  for (int corner = 0; corner < 4; ++corner) {
    vec3 code = vec3(min(x + real(corner & 1), levels), min(y + real(corner >> 1), levels), real(0.0));
    real error = sine2(point_from_oct_code(code, levels), n);
    if (error < least) {
      best = code;
      least = error;
    }
  }
  return best;
}
vec3 decode_oct16_precise(vec3 code) { return decode_oct16(code); }
