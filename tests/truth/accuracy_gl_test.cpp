// The promises of `compact` and `exact` from each built-in scene's own camera; accuracy_slow_test has four cameras more
// and the models.
#include "tests/truth/accuracy.h"

namespace gbl::test {
namespace {

TEST_F(Accuracy, CompactAndExactHoldInEveryBuiltinScene) {
  for (const BuiltinScene& b : builtin_scenes()) expect_promises(fmt::format("builtin:{}", b.id), 1);
}

}  // namespace
}  // namespace gbl::test
