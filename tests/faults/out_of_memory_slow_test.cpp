// Memory that runs out here or there: at textures, at pictures that are read back, while they are written.
#include "tests/faults/child.h"
#include "tests/faults/whole_files.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

TEST(OutOfMemory, ItEndsInOneLineWhereverItRunsOut) {
  const TemporaryFolder folder("memory-anywhere");
  constexpr rlim_t kMiB = 1 << 20, kDriver = 600;  // Mesa itself crashes where it cannot begin
  bool enough = false;
  int ran_out = 0;
  for (rlim_t mib = kDriver; !enough && mib < 4000; mib += 50) {
    SCOPED_TRACE(testing::Message() << mib << " MiB");
    const std::filesystem::path out = folder / std::to_string(mib);
    const Ended ended = Child({"render", "--scene", "builtin:layers", "--lights", "1", "--size", "2048x2048", "--only",
                               "final,reference,error", "--sheet", "--exr", "--png16", "-o", out.string()},
                              folder / "state", {.address_bytes = mib * kMiB})
                            .wait();
    enough = ended.code == 0;
    ran_out += ended.code == 4 ? 1 : 0;
    EXPECT_EQ(ended.signal, 0) << ended.said;
    EXPECT_TRUE(enough || contains(complaint(ended.said), "memory") ||
                contains(complaint(ended.said), "Resource temporarily unavailable"))
        << ended.said;
    EXPECT_EQ(not_whole(out), "");
    EXPECT_EQ(temporaries(files_in(out)), "");
  }
  EXPECT_TRUE(enough);
  EXPECT_GT(ran_out, 5);
}

}  // namespace
}  // namespace gbl::test
