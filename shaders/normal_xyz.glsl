// Normals as x, y, z: see normal_encoding.glsl, which includes this.

// ---- n * 0.5 + 0.5 in three bytes: nclgl tutorial 15, bufferFragment.glsl line 23
vec3 encode_xyz8(vec3 n) { return codes_from_snorms(n, real(255.0)); }
vec3 decode_xyz8(vec3 code) { return normalize(snorms_from_codes(code, real(255.0))); }

// ---- n itself in three unsigned bytes, as engine blog part 30 had it: the pitfall `negative-normal-clamped`
real code_cut_at_0(real x) { return nearest(max(x, real(0.0)) * real(255.0)); }
vec3 encode_xyz8_raw(vec3 n) { return vec3(code_cut_at_0(n.x), code_cut_at_0(n.y), code_cut_at_0(n.z)); }
vec3 decode_xyz8_raw(vec3 code) {
  // Nothing left of it: +Z, because normalize() of zero is a NaN that no light would show.
  if (length2(code) == real(0.0)) return vec3(real(0.0), real(0.0), real(1.0));
  return normalize(code);
}

// ---- the same in ten bits: 1022 levels, so that the axes are exact
vec3 encode_xyz10(vec3 n) { return codes_from_snorms(n, real(1022.0)); }
vec3 decode_xyz10(vec3 code) { return normalize(snorms_from_codes(code, real(1022.0))); }

// ---- as it is, in floats
vec3 encode_xyz16f(vec3 n) { return n; }
vec3 decode_xyz16f(vec3 code) { return normalize(code); }
vec3 encode_xyz32f(vec3 n) { return n; }
vec3 decode_xyz32f(vec3 code) { return code; }  // unit to the last bit as it was stored; normalising would round again

// ---- the length whose rounding fits best: Kaplanyan 2010, "CryENGINE 3: reaching the speed of light". The source
//      looks the length up in a cube map; here all are tried. Vectors shorter than 64 steps have a multiple that is not.
vec3 encode_bestfit8(vec3 n) {
  real longest = max(abs(n.x), max(abs(n.y), abs(n.z)));
  vec3 best = n;
  real least = real(2.0);
  for (int steps = 127; steps >= 64; --steps) {
    real scale = real(steps) / longest;
    vec3 v = vec3(nearest(n.x * scale), nearest(n.y * scale), nearest(n.z * scale));
    real error = sine2(v, n);
    // Better by more than float noise: of vectors along one line the longest stays, on every machine.
    if (error < least - real(1e-13)) {
      best = v;
      least = error;
    }
  }
  return vec3(best.x + real(127.0), best.y + real(127.0), best.z + real(127.0));
}
vec3 decode_bestfit8(vec3 code) {
  return normalize(vec3(code.x - real(127.0), code.y - real(127.0), code.z - real(127.0)));
}

// ---- x and y alone: nclgl tutorial 15, section G-Buffers. The root has one sign, z has two: `xy-only-z-sqrt`.
vec3 encode_xy_sqrt(vec3 n) {
  return vec3(code_from_snorm(n.x, real(4094.0)), code_from_snorm(n.y, real(4094.0)), real(0.0));
}
vec3 decode_xy_sqrt(vec3 code) {
  real x = snorm_from_code(code.x, real(4094.0));
  real y = snorm_from_code(code.y, real(4094.0));
  return normalize(vec3(x, y, sqrt(max(real(1.0) - x * x - y * y, real(0.0)))));
}
