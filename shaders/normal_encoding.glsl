// Unit normals to stored codes and back. Written in the subset common to GLSL and C++ with GLM (free functions,
// no swizzles, no out parameters), so that the code that ships is the code the unit tests measure: C++ includes it
// twice, with real = float and real = double.
//
// A code is a vec3 of whole numbers 0..levels for integer formats (unused channels 0), so the rounding is ours and
// the same on CPU, GPU and web; float formats hold the value itself and the store rounds.

real sign_not_zero(real x) { return x < real(0.0) ? real(-1.0) : real(1.0); }

// Nearest whole number, halves up: one definition everywhere (GLSL leaves the halves of round() open).
real nearest(real x) { return floor(x + real(0.5)); }

// -1..1 <-> 0..levels; levels is even for the octahedral codes so that 0, hence every axis, has a code.
real code_from_snorm(real x, real levels) { return nearest(clamp(x * real(0.5) + real(0.5), real(0.0), real(1.0)) * levels); }
real snorm_from_code(real c, real levels) { return c / levels * real(2.0) - real(1.0); }

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

vec3 normal_from_oct(vec2 p) {
  real z = real(1.0) - abs(p.x) - abs(p.y);
  real x = p.x;
  real y = p.y;
  if (z < real(0.0)) {
    x = (real(1.0) - abs(p.y)) * sign_not_zero(p.x);
    y = (real(1.0) - abs(p.x)) * sign_not_zero(p.y);
  }
  return normalize(vec3(x, y, z));
}

vec3 encode_oct(vec3 n, real levels) {
  vec2 p = oct_from_normal(n);
  return vec3(code_from_snorm(p.x, levels), code_from_snorm(p.y, levels), real(0.0));
}
vec3 decode_oct(vec3 code, real levels) {
  return normal_from_oct(vec2(snorm_from_code(code.x, levels), snorm_from_code(code.y, levels)));
}

// 65534 and 254, not 65535 and 255: with an even number of steps the middle code is exactly 0.
vec3 encode_oct16(vec3 n) { return encode_oct(n, real(65534.0)); }
vec3 decode_oct16(vec3 code) { return decode_oct(code, real(65534.0)); }
vec3 encode_oct8(vec3 n) { return encode_oct(n, real(254.0)); }
vec3 decode_oct8(vec3 code) { return decode_oct(code, real(254.0)); }

// ---- n * 0.5 + 0.5 in three bytes: nclgl tutorial 15, bufferFragment.glsl line 23
vec3 encode_xyz8(vec3 n) {
  return vec3(code_from_snorm(n.x, real(255.0)), code_from_snorm(n.y, real(255.0)), code_from_snorm(n.z, real(255.0)));
}
vec3 decode_xyz8(vec3 code) {
  return normalize(vec3(snorm_from_code(code.x, real(255.0)), snorm_from_code(code.y, real(255.0)), snorm_from_code(code.z, real(255.0))));
}

// ---- stereographic, from the pole -Z: tutorial 9, step 3. At n = (0, 0, -1), and within 0.014 degrees of it in
//      float, 1 + z is 0 and there is no code: the pitfall `stereographic-pole`.
vec3 encode_stereo16f(vec3 n) {
  real d = real(1.0) + n.z;
  return vec3(n.x / d, n.y / d, real(0.0));
}
vec3 decode_stereo16f(vec3 code) {
  real s = code.x * code.x + code.y * code.y;
  real k = real(2.0) / (real(1.0) + s);
  return vec3(code.x * k, code.y * k, k - real(1.0));
}
