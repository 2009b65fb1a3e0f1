#pragma once
// Work on all processors.
#include <functional>
#include <future>
#include <utility>

namespace gbl {

#ifdef __EMSCRIPTEN__
inline constexpr bool kHasThreads = false;  // a page that is opened from disk
#else
inline constexpr bool kHasThreads = true;
#endif

int all_processors();  // 1 or more

// work(0) … work(count - 1), each on a thread of its own, the first on the caller's. Back when all have returned; throws
// what one of them threw.
void on_threads(int count, const std::function<void(int)>& work);

// What work() returns or throws, once it is there: on a thread of its own, or, where there are none, at once.
template <class Work>
auto in_background(Work work) -> std::future<decltype(work())> {
  if constexpr (kHasThreads) return std::async(std::launch::async, std::move(work));
  std::packaged_task<decltype(work())()> task(std::move(work));
  task();
  return task.get_future();
}

}  // namespace gbl
