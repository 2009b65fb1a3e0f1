// Memory that runs out at a texture, at numbers that are read back, or while they are written.
#include "tests/faults/child.h"
#include "tests/faults/whole_files.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

// In steps of what a large texture takes: Mesa itself crashes where there is not even room to compile a shader.
TEST(OutOfMemory, ItEndsInOneLineWhereverItRunsOut) {
  const TemporaryFolder folder("memory-anywhere");
  for (const rlim_t mib : {700, 900, 1100, 1300, 1400, 1600, 1800}) {
    SCOPED_TRACE(testing::Message() << mib << " MiB");
    const std::filesystem::path out = folder / std::to_string(mib);
    const Ended ended = Child({"render", "--scene", "builtin:layers", "--lights", "1", "--size", "3072x3072", "--only",
                               "final,albedo", "--sheet", "--exr", "--png16", "-o", out.string()},
                              folder / "state", {.address_bytes = mib << 20})
                            .wait();
    EXPECT_EQ(ended.code, 4) << "signal " << ended.signal << ": " << ended.said;
    EXPECT_TRUE(contains(complaint(ended.said), "out of memory")) << ended.said;
    EXPECT_EQ(not_whole(out), "");
    EXPECT_EQ(temporaries(files_in(out)), "");
  }
}

}  // namespace
}  // namespace gbl::test
