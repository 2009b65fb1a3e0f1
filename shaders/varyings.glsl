// What position.glsl wants from the vertex shader of every pass that reads the G-buffer.
#if VARYING_INVERSE
out mat4 inverse_viewproj;
void pass_varyings() { inverse_viewproj = inverse(clip_from_world); }
#else
void pass_varyings() {}
#endif
