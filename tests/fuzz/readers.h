#pragma once
// Everything that reads bytes from outside, one row each: for tests that bend small files, and for the fuzzer (scripts/fuzz.sh).
#include <span>
#include <string_view>
#include <vector>

#include "tests/gltf/gltf_fixture.h"

namespace gbl::test {

struct Reader {
  const char* name;
  void (*read)(std::string_view bytes);  // throws Error, or checks what it read: a broken promise aborts
  std::vector<Seed> (*seeds)();          // small files that it takes
};
std::span<const Reader> readers();
const Reader* reader_named(std::string_view name);  // null: there is none

// True: taken; false: refused, as it should be: one line that can be printed, exit code of bad input. Aborts otherwise.
bool takes(const Reader&, std::string_view bytes);

}  // namespace gbl::test
