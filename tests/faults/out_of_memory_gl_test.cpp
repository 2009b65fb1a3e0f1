// Pictures for which there is no memory: said, and never a crash.
#include "tests/faults/child.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

// A texture of this size takes a gigabyte, and the program with its driver less than half of one.
constexpr rlim_t kRoom = rlim_t(3) << 29;

TEST(OutOfMemory, AnAbsurdSizeIsRefusedInOneLine) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer takes terabytes of addresses for itself: there is no limit to set";
#endif
  const TemporaryFolder folder("memory");
  const std::string out = (folder / "out").string();
  const std::vector<std::vector<std::string>> commands = {
      {"render", "-o", out},
      {"render", "--only", "final,reference,error", "--sheet", "--exr", "--png16", "--raw", "-o", out},
      {"render", "--set", "lights.method=forward", "-o", out},
      {"render", "--set", "antialias=msaa-resolved", "-o", out},
      {"probe", "3", "4"},
      {"bench", "--frames", "1"},
      {"advise", "--budget", "1"}};
  for (std::vector<std::string> words : commands) {
    words.insert(words.end(), {"--scene", "builtin:layers", "--size", "16384x16384"});
    const Ended ended = Child(words, folder / "state", {.address_bytes = kRoom}).wait();
    EXPECT_EQ(ended.signal, 0) << ended.said;
    EXPECT_EQ(ended.code, 4) << ended.said;
    EXPECT_TRUE(contains(complaint(ended.said), "out of memory")) << ended.said;
  }
}

}  // namespace
}  // namespace gbl::test
