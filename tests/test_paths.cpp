#include "tests/test_paths.h"

namespace gbl::test {

std::filesystem::path source_folder() { return GBL_ROOT; }
std::string program() { return GBL_PROGRAM; }

}  // namespace gbl::test
