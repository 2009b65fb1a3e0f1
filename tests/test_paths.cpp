#include "tests/test_paths.h"

namespace gbl::test {

std::filesystem::path source_folder() { return GBL_ROOT; }
std::filesystem::path build_folder() { return GBL_BUILD; }
std::string program() { return (build_folder() / "gbufferlab").string(); }

}  // namespace gbl::test
