#pragma once
// What a process holds, and whether that stays flat over a long run.
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <span>
#include <unistd.h>
#include <vector>

namespace gbl::test {

inline double median(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

// What caches fill at first is no leak: the first third is left out.
template <class T>
std::span<const T> after_warm_up(const std::vector<T>& records) {
  return std::span(records).subspan(records.size() / 3);
}

// From the first quarter of the records after the warm-up to their last quarter, as a share: 0.02 is 2 % more. Medians:
// one record that is off says nothing. Needs three records.
inline double growth(const std::vector<double>& records) {
  const std::span<const double> rest = after_warm_up(records);
  const size_t quarter = std::max<size_t>(1, rest.size() / 4);
  return median(rest.last(quarter)) / median(rest.first(quarter)) - 1;
}

// Of a process: its memory that is in RAM.
inline double resident_mib(int process) {
  double pages = 0, resident = 0;
  std::ifstream(fmt::format("/proc/{}/statm", process)) >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

// llvmpipe keeps the triangles of a picture until their place is needed again, and with threads it has up to 64 such places,
// as many as it happened to lag behind: 40 MiB more or less at the same settings. Without threads it has one. To be called
// before the first context, or before the program starts.
inline void draw_without_threads() { setenv("LP_NUM_THREADS", "0", 1); }

// How long a test that goes on for as long as it is asked to does so.
inline double long_run_s(double otherwise) {
  const char* asked = std::getenv("GBL_LONG_RUN_S");
  return asked ? std::atof(asked) : otherwise;
}

}  // namespace gbl::test
