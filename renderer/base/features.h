#pragma once
// What the lab can use beyond its core path (GL 3.3 core and GLES 3.0 in common). Each is asked for once at
// start-up and can be switched off with --without, so that the way without it is tested too.
#include <cstdint>
#include <span>
#include <string_view>

namespace gbl {

enum class Feature { none, debug_labels, timer_query, depth_clamp, clip_control, compute, tessellation };

struct FeatureRow {
  Feature feature;
  const char* id;
  const char* used_for;
};

inline constexpr FeatureRow kFeatures[] = {
    {Feature::debug_labels, "debug-labels", "names of passes and textures in a frame debugger"},
    {Feature::timer_query, "timer-query", "milliseconds per pass; without it the CPU clock is used and said"},
    {Feature::depth_clamp, "depth-clamp", "light volumes that are depth-tested and cut by near or far plane"},
    {Feature::clip_control, "clip-control", "reversed depth with a 0..1 clip range"},
    {Feature::compute, "compute", "tiled light lists built on the GPU"},
    {Feature::tessellation, "tessellation", "surfaces cut into small triangles and moved by their height maps"},
};

// A set of features, small enough to pass by value.
class FeatureSet {
 public:
  constexpr bool has(Feature f) const { return f == Feature::none || (bits_ >> int(f)) & 1u; }
  constexpr void add(Feature f) { bits_ |= 1u << int(f); }
  constexpr void remove(Feature f) { bits_ &= ~(1u << int(f)); }
  constexpr bool operator==(const FeatureSet&) const = default;

 private:
  uint32_t bits_ = 0;
};

// "compute,clip-control" -> the set; an unknown id is an Error that lists the known ones.
FeatureSet parse_features(std::string_view comma_separated);

}  // namespace gbl
