#pragma once
// Work on all processors.
#include <functional>
#include <future>
#include <utility>

namespace gbl {

int all_processors();  // 1 or more

// work(0) … work(count - 1), each on a thread of its own, the first on the caller's. Back when all have returned; throws
// what one of them threw.
void on_threads(int count, const std::function<void(int)>& work);

// What work() returns or throws, once it is there: on a thread of its own, or, where there are none, at once.
template <class Work>
auto in_background(Work work) -> std::future<decltype(work())> {
#ifdef __EMSCRIPTEN__
  std::packaged_task<decltype(work())()> task(std::move(work));
  task();
  return task.get_future();
#else
  return std::async(std::launch::async, std::move(work));
#endif
}

}  // namespace gbl
