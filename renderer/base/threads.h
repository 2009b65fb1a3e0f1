#pragma once
// Work on all processors.
#include <functional>

namespace gbl {

int all_processors();  // 1 or more

// work(0) … work(count - 1), each on a thread of its own, the first on the caller's. Back when all have returned; throws
// what one of them threw.
void on_threads(int count, const std::function<void(int)>& work);

}  // namespace gbl
