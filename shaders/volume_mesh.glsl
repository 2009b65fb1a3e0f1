// Where a vertex of a light volume's mesh stands, seen from the light. Written in the subset common to GLSL and C++
// with GLM (as normal_encoding.glsl), so that the meshes that ship are those that the unit tests measure.
//   scale: of the mesh, 1 inscribed, 1/inradius circumscribed     slack: how much farther out every face stands

vec3 sphere_vertex(vec3 vertex, real range, real scale, real slack) { return vertex * ((range + slack) * scale); }
real sphere_reach(real range, real scale, real slack) { return (range + slack) * scale; }

// A cone of the unit mesh: apex at 0, base of radius 1 at z = 1. Angles below a milliradian are drawn as one.
real cone_sine(real outer_cos) {
  return max(sqrt((real(1.0) - outer_cos) * (real(1.0) + outer_cos)), real(1.0e-3));
}
real cone_height(real range, real slack) { return range * real(1.000001) + slack; }  // where d < range ends, and a bit
real cone_set_back(real outer_cos, real slack) { return slack / cone_sine(outer_cos); }  // moves its side out by slack
real cone_radius(real range, real outer_cos, real scale, real slack) {
  real height = cone_height(range, slack) + cone_set_back(outer_cos, slack);
  return height * scale * cone_sine(outer_cos) / outer_cos;
}

// Frame about a unit axis: Duff et al. 2017, "Building an orthonormal basis, revisited".
vec3 beside(vec3 axis, real x, real y) {
  real side = axis.z < real(0.0) ? real(-1.0) : real(1.0);
  real a = real(-1.0) / (side + axis.z);
  real b = axis.x * axis.y * a;
  return x * vec3(real(1.0) + side * axis.x * axis.x * a, side * b, -side * axis.x) +
         y * vec3(b, side + axis.y * axis.y * a, -axis.y);
}

vec3 cone_vertex(vec3 vertex, vec3 axis, real range, real outer_cos, real scale, real slack) {
  real radius = cone_radius(range, outer_cos, scale, slack);
  real set_back = cone_set_back(outer_cos, slack);
  return beside(axis, vertex.x * radius, vertex.y * radius) +
         axis * (vertex.z * (cone_height(range, slack) + set_back) - set_back);
}
real cone_reach(real range, real outer_cos, real scale, real slack) {
  real height = cone_height(range, slack);
  real radius = cone_radius(range, outer_cos, scale, slack);
  return max(sqrt(height * height + radius * radius), cone_set_back(outer_cos, slack));
}
