// libFuzzer target: any bytes are taken or refused. `fuzz --reader=NAME …` (scripts/fuzz.sh).
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/readers.h"

static const gbl::test::Reader* reader = nullptr;

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  constexpr std::string_view kFlag = "--reader=";
  for (int i = 1; i < *count; ++i)
    if (const std::string_view argument = (*arguments)[i]; argument.substr(0, kFlag.size()) == kFlag)
      reader = gbl::test::reader_named(argument.substr(kFlag.size()));
  if (reader) return 0;
  std::fprintf(stderr, "say which: --reader=");
  for (const gbl::test::Reader& r : gbl::test::readers()) std::fprintf(stderr, "%s ", r.name);
  std::fprintf(stderr, "\n");
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  takes(*reader, {reinterpret_cast<const char*>(data), size});
  return 0;
}
