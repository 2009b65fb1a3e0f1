// The same in larger pictures.
#include "tests/study/pitfalls/pitfalls_gl.h"

namespace gbl::test {
namespace {

TEST_P(EveryPitfall, IsAsCataloguedInALargerPicture) { expect_as_catalogued({320, 180}); }
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryPitfall, testing::ValuesIn(pitfall_ids()), test_name);

}  // namespace
}  // namespace gbl::test
