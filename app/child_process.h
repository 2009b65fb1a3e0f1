#pragma once
// This program once more, in a process of its own: what it does there can neither hang nor crash the one that waits.
#include <string>
#include <vector>

namespace gbl {

struct ChildResult {
  int exit_code = 0;
  int signal = 0;          // that ended it; 0: it ended by itself
  bool timed_out = false;  // it was ended after the limit
  std::string out, err;    // what it printed
};

// Waits for it. Error(unfinished) if no process can be started.
ChildResult run_child(const std::vector<std::string>& arguments, double limit_s);

}  // namespace gbl
