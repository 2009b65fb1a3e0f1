#include "tests/faults/new_context.h"

namespace gbl::test {
namespace {

TEST(NewContext, EachPresetGivesTheSameBits) {
  std::vector<std::string> ids;
  for (const Preset& p : presets()) ids.emplace_back(p.id);
  expect_the_same_on_each_context(ids);
}

}  // namespace
}  // namespace gbl::test
