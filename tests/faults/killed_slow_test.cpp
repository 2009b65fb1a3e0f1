// Every command of the list, killed at many moments.
#include "tests/faults/killing.h"

namespace gbl::test {
namespace {

TEST(Killed, AtManyMoments) {
  const TemporaryFolder given("killed-often");
  for (const QuickCommand& command : quick_commands(given.path()))
    for (uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(testing::Message() << command.name << ", seed " << seed);
      Killing killing(command, seed);
      killing.in_a_new_folder(4);
      killing.over_an_older_run(8);
    }
}

}  // namespace
}  // namespace gbl::test
