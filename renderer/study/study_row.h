#pragma once
// One row of a study: the columns by which set-ups are compared, with the same names in JSON, CSV and window.
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/json.h"
#include "renderer/frame/frame_report.h"
#include "renderer/options/options.h"
#include "renderer/truth/measure.h"

namespace gbl {

// Times of repeated frames of one pass, milliseconds.
struct TimeSpread {
  double median = 0, p10 = 0, p90 = 0;
};
// Nearest-rank percentiles; the list must not be empty.
TimeSpread spread_of(std::vector<double> ms);

struct Timing {
  std::map<std::string, std::vector<double>> pass_ms;  // by pass, one number per frame
  int frames = 0;
};

struct Machine {
  std::string driver, device;
};

// What a frame costs but for its times: size, time_source, pairs, bytes, draw calls, driver and device.
void append_costs(Json& row, const FrameReport&, const Machine&);

// All columns: errors, times, pairs, bytes, draw calls, machine, settings. Null: not measured.
Json study_row(const FrameReport&, const Errors&, const Timing&, const Machine&);

// When is a row measured long enough? 20 frames or 20 s, at least 3 frames, 1 if one exceeds 20 s.
bool measured_enough(int frames, double seconds, double slowest_s);

}  // namespace gbl
