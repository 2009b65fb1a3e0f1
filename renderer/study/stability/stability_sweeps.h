#pragma once
// The rows of sweeps(), a function each; the sweeps of a kind share a file.
#include "renderer/study/stability/stability.h"

namespace gbl {

// stability_volumes.cpp: which faces of a light's volume are seen
Sweep light_distance_sweep();
Sweep near_corner_sweep();
Sweep far_plane_sweep();
Sweep volume_level_sweep();
// stability_normals.cpp: what a normal's code loses
Sweep normal_angle_sweep();
Sweep roughness_sweep();
Sweep sub_pixel_pan_sweep();
// stability_positions.cpp: where the surface is taken to be
Sweep view_distance_sweep();
Sweep world_offset_sweep();
Sweep near_plane_sweep();
Sweep depth_decode_sweep();
// stability_light.cpp: sums, and where a light ends
Sweep light_count_sweep();
Sweep range_threshold_sweep();
// stability_shadows.cpp: what shadow maps lose
Sweep shadow_bias_sweep();
// stability_heights.cpp: where a line of sight ends in a height map
Sweep parallax_steps_sweep();
Sweep parallax_angle_sweep();
// stability_families.cpp: everything at once
Sweep cull_families_sweep();

}  // namespace gbl
