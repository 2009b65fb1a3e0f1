// Commands that are killed while they run; more of it in killed_slow_test.cpp.
#include "tests/faults/killing.h"

namespace gbl::test {
namespace {

TEST(Killed, NothingHalfIsSeenAndTheNextRunIsAsIfNothingHadBeen) {
  const TemporaryFolder given("killed");
  for (const QuickCommand& command : quick_commands(given.path())) {
    if (command.name != "study" && command.name != "render") continue;
    Killing killing(command, 1);
    killing.in_a_new_folder(1);
    killing.over_an_older_run(1);
  }
}

}  // namespace
}  // namespace gbl::test
