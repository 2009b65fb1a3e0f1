#pragma once
// What pair_arithmetic.cpp hands to the part of it that is compiled for wide vectors. Plain data: nothing that is
// inlined there may be used elsewhere.

namespace gbl {

inline constexpr int kLanes = 8;  // pixels side by side

struct PairLight {
  float position[3], range, colour[3], profile;
};
struct PairPixels {  // each number of kLanes pixels
  float position[3][kLanes], normal[3][kLanes], f0[3][kLanes], exponent[kLanes], roughness[kLanes];
};
struct PairSums {
  float diffuse[3][kLanes], specular[3][kLanes];
};

// The sum of all lights of a block.
using PairLoop = void (*)(const PairPixels&, const PairLight* lights, int count, PairSums&);

PairLoop pair_loop(int model, int attenuation);  // null: there is no such variant

}  // namespace gbl
