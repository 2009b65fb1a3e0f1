#include "renderer/base/threads.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace gbl {
namespace {

// Joined when they go, and also where a next one cannot be started.
struct Threads {
  std::vector<std::thread> all;
  ~Threads() {
    for (std::thread& t : all) t.join();
  }
};

}  // namespace

int all_processors() { return kHasThreads ? static_cast<int>(std::max(1u, std::thread::hardware_concurrency())) : 1; }

void on_threads(int count, const std::function<void(int)>& work) {
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto guarded = [&](int i) {
    try {
      work(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      thrown = std::current_exception();
    }
  };
  {
    Threads others;
    for (int i = 1; i < count; ++i) others.all.emplace_back(guarded, i);
    guarded(0);
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace gbl
