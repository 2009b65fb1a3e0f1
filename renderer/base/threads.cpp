#include "renderer/base/threads.h"

#include <algorithm>
#include <thread>
#include <vector>

namespace gbl {

int all_processors() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

void on_threads(int count, const std::function<void(int)>& work) {
  std::vector<std::thread> others;
  for (int i = 1; i < count; ++i) others.emplace_back(work, i);
  work(0);
  for (std::thread& t : others) t.join();
}

}  // namespace gbl
