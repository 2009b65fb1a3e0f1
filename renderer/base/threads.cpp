#include "renderer/base/threads.h"

#include <algorithm>
#include <thread>
#include <vector>

namespace gbl {

int all_processors() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

void on_threads(int count, const std::function<void(int)>& work) {
  std::vector<std::jthread> others;  // joined when they go, and also where a next one cannot be started
  for (int i = 1; i < count; ++i) others.emplace_back(work, i);
  work(0);
}

}  // namespace gbl
