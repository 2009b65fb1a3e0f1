#pragma once
// Twelve small pictures, each judged by the reference: whether the lab's numbers hold with the driver at hand.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/lab.h"
#include "renderer/base/json_fwd.h"

namespace gbl {

struct SelfTestResult {
  std::string id, what;
  std::string skipped;  // why this device cannot draw it; empty: it was tried
  std::string failed;   // what the driver refused; empty: nothing
  std::string hash;     // of the picture's 8-bit codes: equal pictures have equal ones
  double flip_mean = 0, flip_at_most = 0;
  double off_pixels = 0;  // share of the pixels that are off by more than a code of 255
  double nonfinite_pixels = 0;
  bool holds() const { return skipped.empty() && failed.empty() && nonfinite_pixels == 0 && flip_mean <= flip_at_most; }
};

std::vector<SelfTestResult> run_self_test(Lab&, const std::function<void(const SelfTestResult&)>& done);
Json to_json(const SelfTestResult&);

}  // namespace gbl
