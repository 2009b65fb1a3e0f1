#include "renderer/gbuffer/position_source.h"

#include <gtest/gtest.h>
#include <set>

namespace gbl {
namespace {

TEST(PositionSource, ErrorsAreThoseOfTheTable) {
  for (const PositionRow& r : position_rows())
    for (size_t k = 0; k < std::size(kPositionRanges); ++k) {
      const double measured = largest_position_error(r, kPositionRanges[k]);
      // Two digits are stated: half a unit of the second is at most 5 %.
      EXPECT_NEAR(r.max_error[k] / measured, 1, 0.051) << id_of(r) << " at " << kPositionRanges[k];
    }
}

TEST(PositionSource, EveryStoredSourceAndEveryDepthFormatHasARow) {
  std::set<std::string> ids;
  std::set<PositionSource> sources;
  std::set<DepthFormat> formats;
  for (const PositionRow& r : position_rows()) {
    EXPECT_TRUE(ids.insert(id_of(r)).second) << id_of(r);
    sources.insert(r.source);
    if (r.source == PositionSource::depth) formats.insert(r.format);
  }
  EXPECT_EQ(sources.size(), rows<PositionSource>().size());
  EXPECT_EQ(formats.size(), rows<DepthFormat>().size() - 1) << "all but auto, which is one of the others";
}

double error_of(const char* id, double range) {
  for (const PositionRow& r : position_rows())
    if (id_of(r) == id) return largest_position_error(r, range);
  ADD_FAILURE() << id;
  return 0;
}

// The catalogue's statements, as orders of magnitude.
TEST(PositionSource, TheCataloguesClaimsHold) {
  // `d32f-not-reversed`: no gain over 24 bits; reversed, a thousand times better.
  EXPECT_NEAR(error_of("depth/d32f/view-ray", 9000) / error_of("depth/d24/view-ray", 9000), 1, 0.2);
  EXPECT_LT(error_of("depth/d32f-reversed/view-ray", 9000), 1e-3 * error_of("depth/d32f/view-ray", 9000));
  // `float-inverse-viewproj`: its noise is larger than the depth buffer's own.
  EXPECT_GT(error_of("depth/d24/inverse-viewproj", 1000), 10 * error_of("depth/d24/view-ray", 1000));
  // `fp16-world-position`: as bad near the camera as far from it; in view space it grows with distance instead.
  EXPECT_GT(error_of("world16f", 10), 1);
  EXPECT_LT(error_of("view16f", 10), 0.01);
  // `pos-scale-1e6`: fixed point, some 3 cm in each coordinate at any distance.
  for (const double range : kPositionRanges) EXPECT_NEAR(error_of("view-scaled", range), 0.044, 0.01);
}

}  // namespace
}  // namespace gbl
