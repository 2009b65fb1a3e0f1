// A colour for each number: its hash (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", pcg), never dark.
vec3 value(ivec2 texel) { return vec3(object_at(texel)); }

vec4 shown(ivec2 texel) {
  uint state = uint(value(texel).x) * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  uint hash = (word >> 22u) ^ word;
  return on_surfaces(texel, 0.25 + 0.75 * vec3(hash & 255u, (hash >> 8) & 255u, (hash >> 16) & 255u) / 255.0);
}

vec4 raw(ivec2 texel) { return vec4(value(texel) / 255.0, 1.0); }
