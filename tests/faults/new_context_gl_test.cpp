// Three presets of unlike layouts, one with shadows; all of them in new_context_slow_test.cpp.
#include "tests/faults/new_context.h"

namespace gbl::test {
namespace {

TEST(NewContext, TheSameSettingsGiveTheSameBits) { expect_the_same_on_each_context({"start", "viewspace", "exact"}); }

}  // namespace
}  // namespace gbl::test
