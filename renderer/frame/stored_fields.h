#pragma once
// What the bits of an attachment mean: its fields. An attachment's `contents` is the one place that says it, in a small
// language:
//   contents  group; group; ...    of one channel or some that mean the same: "rgb: albedo, sRGB-coded; a: roughness"
//   numbers   name, more           a number a channel; "exponent / 256" is stored divided
//   words     item, item, ...      from the lowest bit: "metal 10, occlusion 10" are codes of as many bits, 0..1;
//                                  "albedo 9 9 8" has components; "roughness bits 6-9" is a part of a longer code
// "r, where it shines" is how a word's bits are shared out where its highest bit is 1, "r, elsewhere" where it is 0. Depth,
// normals and positions have no such words: format, encoding and source say how they lie.
#include <string>
#include <vector>

#include "renderer/gbuffer/attachment.h"
#include "renderer/options/settings.h"

namespace gbl {

// Bits of one channel that lie side by side. Beside depth a stencil is the next channel; kPadding: of no channel.
inline constexpr int kPadding = 4;
struct BitRun {
  int channel, first, bits;
  int holds = 0;  // the lowest bit of the field's code that lies here
};
using BitRuns = std::vector<BitRun>;  // of one code, the lowest first

enum class CodeKind {
  number,    // as it is
  share,     // of the largest: 0..1
  floating,  // a float of so many bits
  normal     // all components make one direction
};

struct StoredField {
  std::string name;
  std::vector<BitRuns> components;
  CodeKind kind = CodeKind::share;
  bool srgb = false;             // its number is coded as settings.colour says
  double scale = 1, offset = 0;  // what is meant = number * scale + offset
};
inline constexpr const char* kUnusedBits = "unused";  // the name of bits that nothing reads

// From the first channel's lowest bit on; each bit of the format stands in one of them. shines: the highest bit of the first
// channel is 1.
std::vector<StoredField> stored_fields(const Settings&, const Attachment&, bool shines = false);

}  // namespace gbl
