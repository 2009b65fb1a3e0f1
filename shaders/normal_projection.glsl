// Normals as a point of a plane, or of a globe's grid: see normal_encoding.glsl, which includes this.

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

// ---- Lambert's azimuthal equal-area map from +Z: Lambert 1772; as "spheremap transform" Mittring 2009, "A bit more
//      deferred". A disc of radius sin(angle / 2); its whole rim is the pole -Z, so the pole has codes: we store (1, 0).
vec3 encode_lambert16(vec3 n) {
  real s = square(n.x) + square(n.y);
  real k = sqrt(real(0.5) / (real(1.0) + abs(n.z)));
  // Below the equator 1 + z has lost its digits: radius and direction apart. 1e-30: squares that are still exact.
  if (n.z < real(0.0)) k = s > real(1e-30) ? sqrt((real(0.5) - n.z * real(0.5)) / s) : real(0.0);
  real x = k > real(0.0) ? n.x * k : real(1.0);
  return vec3(code_from_snorm(x, real(65534.0)), code_from_snorm(n.y * k, real(65534.0)), real(0.0));
}
vec3 decode_lambert16(vec3 code) {
  // (cos(angle / 2))^2 = 1 - x^2 - y^2 in whole numbers: near the rim floats would cancel. Beyond the rim: the pole.
  int x = int(code.x) - 32767;
  int y = int(code.y) - 32767;
  int rest = 32767 * 32767 - x * x - y * y;
  real c2 = rest > 0 ? real(rest) / real(1073676289.0) : real(0.0);
  real k = real(2.0) * sqrt(c2) / real(32767.0);
  return normalize(vec3(real(x) * k, real(y) * k, real(2.0) * c2 - real(1.0)));
}

// ---- angles, in turns
// atan2(y, x): -1/2..1/2, and 0 at the origin. Gregory's series for tangents up to tan(pi / 8): 2e-8 radians are left.
real turn_of(real x, real y) {
  real longer = max(abs(x), abs(y));
  if (longer == real(0.0)) return real(0.0);
  real t = min(abs(x), abs(y)) / longer;
  bool steep = t > real(0.41421356);
  real u = steep ? (t - real(1.0)) / (t + real(1.0)) : t;  // tan(a - pi / 4)
  real z = u * u;
  real series = real(1.0) / real(13.0) - z * (real(1.0) / real(15.0));
  series = real(1.0) / real(11.0) - z * series;
  series = real(1.0) / real(9.0) - z * series;
  series = real(1.0) / real(7.0) - z * series;
  series = real(1.0) / real(5.0) - z * series;
  series = real(1.0) / real(3.0) - z * series;
  // A difference times the constant: of a product times a constant compilers change the order, and the last bit.
  real turn = (u - u * z * series) * real(0.15915494309189535) + (steep ? real(0.125) : real(0.0));
  if (abs(y) > abs(x)) turn = real(0.25) - turn;
  if (x < real(0.0)) turn = real(0.5) - turn;
  return y < real(0.0) ? -turn : turn;
}

// (cos, sin) of so many turns. Taylor's series up to an eighth of a turn: 2e-9 are left. Quarter turns are exact.
vec2 direction_of_turn(real turn) {
  real quarters = nearest(turn * real(4.0));
  real a = (turn - quarters * real(0.25)) * real(6.283185307179586);
  real z = a * a;
  real s = real(1.0) - z / real(72.0);
  s = real(1.0) - z / real(42.0) * s;
  s = real(1.0) - z / real(20.0) * s;
  s = a * (real(1.0) - z / real(6.0) * s);
  real c = real(1.0) - z / real(90.0);
  c = real(1.0) - z / real(56.0) * c;
  c = real(1.0) - z / real(30.0) * c;
  c = real(1.0) - z / real(12.0) * c;
  c = real(1.0) - z / real(2.0) * c;
  int quarter = int(quarters) & 3;
  if (quarter == 1) return vec2(-s, c);
  if (quarter == 2) return vec2(-c, -s);
  if (quarter == 3) return vec2(s, -c);
  return vec2(c, s);
}

// ---- spherical: azimuth about +Z in 65536 steps a turn (the seam has one code, not two), angle from +Z in 65534 a
//      half turn. At the poles every azimuth is right; we store that of +X.
vec3 encode_spherical16(vec3 n) {
  real azimuth = nearest((turn_of(n.x, n.y) + real(0.5)) * real(65536.0));
  real polar = turn_of(n.z, sqrt(square(n.x) + square(n.y)));
  return vec3(azimuth < real(65536.0) ? azimuth : real(0.0), nearest(polar * real(131068.0)), real(0.0));
}
vec3 decode_spherical16(vec3 code) {
  vec2 azimuth = direction_of_turn(code.x / real(65536.0) - real(0.5));
  vec2 polar = direction_of_turn(code.y / real(131068.0));
  return normalize(vec3(polar.y * azimuth.x, polar.y * azimuth.y, polar.x));
}
