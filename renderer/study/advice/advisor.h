#pragma once
// The cheapest set-up for a scene that holds an error budget, over its own camera and seeded ones: first every value
// of every axis alone, with nothing else lost, then the products of those that hold, cheapest first. By bytes and by
// pairs all of them are in the order of their cost, and the first that holds is the answer. By time it is the fastest of
// those that were measured: every sound method with the smallest set-up, and a few more set-ups with the fastest method. "Model no more
// than a scene needs" (the user's words), carried out. Shadows, mirrors and height maps are judged apart from what is stored.
// No GL: what is measured comes through a JudgeFn.
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/frame/validate.h"
#include "renderer/options/options.h"
#include "renderer/scene/scene.h"
#include "renderer/truth/measure.h"

namespace gbl {

enum class AdviceCost { time, bytes, pairs };
struct AdviceCostRow {
  AdviceCost cost;
  const char* id;
  const char* unit;
};
inline constexpr AdviceCostRow kAdviceCosts[] = {{AdviceCost::time, "time", "ms"},
                                                 {AdviceCost::bytes, "bytes", "bytes per pixel"},
                                                 {AdviceCost::pairs, "pairs", "pairs"}};
inline const AdviceCostRow& row(AdviceCost c) { return kAdviceCosts[static_cast<size_t>(c)]; }

// How far displayed colours may be off, 0..1, and in how large a share of the pixels they may be off by more.
struct ErrorBudget {
  double display_difference = 1 / 255.0;
  double share_over = 0.001;
  bool holds(const BoundCheck& b) const { return b.share_over() <= share_over; }
};

inline constexpr int kAdviceCameras = 5;  // the settings' own and four seeded ones

// What is asked of a set-up: is the bound held from this camera (0: the settings' own)?
using JudgeFn = std::function<BoundCheck(const Settings&, int camera)>;
// What it costs from the settings' own camera: ms of a frame or pairs shaded + tested; bytes need no measurement.
using CostFn = std::function<double(const Settings&)>;
using AdviceProgress = std::function<void(const std::string& what)>;

// One axis' value, tried with nothing else lost, or a whole set-up.
struct Tried {
  std::vector<Assignment> values;
  bool holds = true;
  int camera = 0;    // the first at which it failed, or the worst
  BoundCheck worst;  // there
};

// Of an axis that no layout stores (sight_advice.h): the values in the order of their cost, each with its worst camera.
struct SightChoice {
  std::vector<Tried> tried;
  size_t taken = 0;
};

struct AdvisedSetup {
  Settings settings;
  double cost = 0;
  int bytes_per_pixel = 0;             // G-buffer and light together
  Tried proof;                         // the worst camera's check, with light that nothing hides
  std::optional<Tried> together = {};  // with shadows, mirrors and height maps. It need not hold: see sight_advice.h
};

struct Advice {
  std::optional<AdvisedSetup> best, runner_up;  // by bytes and pairs the runner-up has another method
  std::vector<Tried> values;                    // each axis' values alone, in the order tried
  std::vector<Tried> rejected;                  // whole set-ups cheaper than the best that failed together
  std::vector<AdvisedSetup> measured;           // by time: all that the best is the fastest of
  std::vector<SightChoice> sights;              // shadow maps, mirrors, height maps: what the best has of them
  std::vector<std::string> left_out;            // what the best leaves out and why, a sentence each
  bool stopped = false;  // before the answer: `best` is the cheapest so far that holds, if there is one
};

// The best is the cheapest by cost; equal costs: fewer bytes first. When cancelled it says so in `stopped`.
Advice advise(const Settings& truth, const Scene&, const ErrorBudget&, AdviceCost, const DeviceLimits&, const JudgeFn&,
              const CostFn&, const AdviceProgress&, const std::atomic<bool>& cancel);

// What a set-up is made of, as far as it is in use: layout, normal.encoding, …
std::vector<Assignment> setup_values(const Settings&);
std::string in_words(const std::vector<Assignment>&);  // "layout=split normal.encoding=oct8"

}  // namespace gbl
