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

struct Sample {
  double seconds, value;
};

// What caches fill at first is no leak: the first third of the time is left out. Records in the order of their `seconds`.
template <class Record>
std::span<const Record> after_warm_up(const std::vector<Record>& records) {
  const double begin_s = records.back().seconds / 3;
  const auto begin =
      std::find_if(records.begin(), records.end(), [&](const Record& r) { return r.seconds >= begin_s; });
  return std::span(records).subspan(static_cast<size_t>(begin - records.begin()));
}

// From the first quarter of the samples after the warm-up to their last quarter, as a share: 0.02 is 2 % more. Medians:
// one sample that is off says nothing. Needs three samples.
inline double growth(const std::vector<Sample>& samples) {
  std::vector<double> rest;
  for (const Sample& s : after_warm_up(samples)) rest.push_back(s.value);
  const size_t quarter = std::max<size_t>(1, rest.size() / 4);
  return median(std::span(rest).last(quarter)) / median(std::span(rest).first(quarter)) - 1;
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
