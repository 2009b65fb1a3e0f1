#pragma once
// The picture of a pitfall: broken, fixed and their difference side by side, cut to where it shows.
#include <filesystem>

#include "app/lab.h"
#include "renderer/study/pitfalls/catalogue.h"

namespace gbl {

struct PitfallStrip {
  Image broken, fixed, difference;  // of one size
  double most_codes = 0;            // what the difference's brightest colour stands for
};
PitfallStrip draw_strip(Lab&, const PitfallEntry&);

// As one true-colour PNG of at most 120 KB. A file that shows the same already is left as it is.
void write_strip(const std::filesystem::path&, const PitfallStrip&);

}  // namespace gbl
