#pragma once
// Stability curves: one parameter moved through the place where a method breaks, one curve per method, and of every
// curve a statement that is checked. Data in, rows out, through a MeasureFn: no GL here.
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/frame/validate.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"
#include "renderer/study/journal.h"
#include "renderer/study/stability/stability_statement.h"
#include "renderer/study/study.h"
#include "renderer/truth/measure.h"

namespace gbl {

// What is drawn at one point of a curve. The scene is made for the sweep; settings.scene is unique to it.
struct SweepSetup {
  Settings settings;
  std::shared_ptr<const Scene> scene;
};

struct Measured {
  Errors errors;
  std::shared_ptr<const Truth> truth;
  Drawn drawn = {};
};

// How this device rounds what it stores and blends into small floats: GL leaves it open, and statements depend on it.
struct DeviceRounding {
  StoreRounding half_store = StoreRounding::to_nearest;
  StoreRounding half_blend = StoreRounding::to_nearest;
  StoreRounding r11 = StoreRounding::to_nearest;  // its store; blends are taken to round alike
};

// What a curve shows: a column of Errors, or a number that needs the truth as well.
struct SweepMetric {
  const char* id;
  const char* unit;
  const char* help;
  std::optional<double> (*value)(const SweepSetup&, const Measured&);  // null: the column of Errors with this id
};
std::span<const SweepMetric> sweep_metrics();
const SweepMetric& sweep_metric(std::string_view id);
std::optional<double> value_of(const SweepMetric&, const SweepSetup&, const Measured&);

// Pixels that the truth lights by more than 1/255, ambient light and emission apart.
double lit_pixels(const Truth&);

struct Curve {
  std::string id;                        // "cull=back fit=circumscribed"
  std::function<void(Settings&)> apply;  // what makes this curve: the method
  std::vector<Expected> expected;        // never empty
};

struct Sweep {
  const char* id;
  const char* label;
  const char* parameter;  // what is moved
  const char* unit;       // of the parameter; "" = a number
  bool log_axis;
  const char* metric;  // a SweepMetric's id
  const char* help;    // what is drawn, and what is to be seen
  std::vector<double> (*values)();
  std::vector<Curve> (*curves)(const DeviceRounding&);
  SweepSetup (*at)(double value);  // before a curve is applied
  // Options that stay the sweep's in a scene of the user's: its parameter, and what it is about. Empty: it needs its own scene.
  std::vector<const char*> keeps = {};
};
std::span<const Sweep> sweeps();
const Sweep& sweep(std::string_view id);  // Error(bad_input) with the known ones

bool has_families(const Sweep&);  // see kFamilySpan
inline constexpr int kFamilies = 3;
std::vector<double> family_values(int configurations);  // of each family, 1 to kFamilySpan

SweepSetup setup_at(const Sweep&, const Curve&, double value, const std::function<void(SweepSetup&)>& over = {});
AxisWords words_of(const Sweep&);

struct SweepRow {
  std::string sweep, curve;
  double x = 0;
  std::string metric;
  std::optional<double> value;  // of the metric; empty: not measured. May be infinite or NaN
  Errors errors;
  double lit_pixels = 0;
};

struct Judged {
  std::string statement;
  Verdict verdict;
};
struct CurveResult {
  std::string curve;
  std::string not_drawn;  // why this device cannot draw it; then there are no rows and nothing is judged
  std::vector<SweepRow> rows;
  std::vector<Judged> judged;
  Settings settings;  // of the first point
};
struct SweepResult {
  const Sweep* sweep = nullptr;
  std::vector<CurveResult> curves;
  size_t left = 0;         // points that were not measured; then no curve is judged
  std::string given = {};  // what the command line gave (stability_given.h); then no curve is judged
  bool holds() const;
};

using MeasureFn = std::function<Measured(const SweepSetup&)>;
using SweepProgressFn = std::function<void(const Sweep&, size_t done, size_t total)>;

struct SweepRun {
  std::vector<double> values;  // empty: the sweep's own
  DeviceLimits limits;
  DeviceRounding rounding;
  Shard shard;                                 // takes values, so that curves still share the truth of a point
  Journal* journal = nullptr;                  // keeps each point as it is measured, and gives back those that it has
  std::function<void(SweepSetup&)> over = {};  // what the command line gives, over each point
  std::string given = {};                      // the same in words
};
// Point by point, for a window that goes on in between. Value by value, so that curves share the truth of a point.
class SweepRunner {
 public:
  SweepRunner(const Sweep&, const SweepRun&);
  bool complete() const { return next_ == total(); }
  const SweepSetup& setup() const { return setup_; }  // of the next point
  SweepRow row(const Measured&) const;                // of that point
  void add(SweepRow);                                 // after the last one every curve is judged
  void add(const Measured& m) { add(row(m)); }
  void skip();                                                      // that point stays unmeasured
  double value() const { return values_[next_ / curves_.size()]; }  // of the parameter, at that point
  size_t value_index() const { return next_ / curves_.size(); }
  const Curve& curve() const { return curves_[next_ % curves_.size()]; }
  const SweepResult& result() const { return result_; }
  const std::vector<Curve>& curves() const { return curves_; }
  size_t done() const { return next_; }  // points of curves that cannot be drawn are counted, too
  size_t total() const { return values_.size() * curves_.size(); }

 private:
  void find_next();
  std::vector<double> values_;
  std::vector<Curve> curves_;
  SweepResult result_;
  std::function<void(SweepSetup&)> over_;
  size_t next_ = 0;  // value by value, and in it curve by curve
  std::optional<size_t> based_;
  SweepSetup base_, setup_;  // of the value `based_`, before and after the curve is applied
};

// The whole sweep at once. Errors of `measure` and of the journal are thrown on.
SweepResult run_sweep(const Sweep&, const SweepRun&, const MeasureFn&, const SweepProgressFn&,
                      const std::atomic<bool>& cancel);

}  // namespace gbl
