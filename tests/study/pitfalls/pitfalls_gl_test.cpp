// Every entry of the catalogue fails when broken, holds when fixed, and hides where it is said to hide.
#include "tests/study/pitfalls/pitfalls_gl.h"

namespace gbl::test {
namespace {

TEST_P(EveryPitfall, IsAsCatalogued) { expect_as_catalogued({160, 90}); }
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryPitfall, testing::ValuesIn(pitfall_ids()), test_name);

}  // namespace
}  // namespace gbl::test
