#include "renderer/base/memory.h"

#include <fstream>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gbl {

void return_freed_memory() {
#ifdef __GLIBC__
  constexpr int kLargeBytes = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, kLargeBytes);  // mallopt(3): setting it ends its adjustment
  mallopt(M_TRIM_THRESHOLD, 4 * kLargeBytes);
  mallopt(M_ARENA_MAX, 1);
#endif
}

void return_free_pages() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

uint64_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  uint64_t pages = 0, resident = 0;
  if (!(statm >> pages >> resident)) return 0;
  return resident * static_cast<uint64_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace gbl
