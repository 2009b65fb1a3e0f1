#pragma once
// A set-up measured as a row of a study: errors against the reference, then times of repeated frames, then counts.
// In steps of a frame or less, with targets of its own, so that a window can go on drawing in between.
#include "app/truth_keeper.h"
#include "renderer/base/threads.h"
#include "renderer/frame/estimate.h"
#include "renderer/study/page/thumbnails.h"
#include "renderer/study/rows/study_row.h"

namespace gbl {

double now_s();  // a clock that never goes back

struct BenchWishes {
  bool errors = true;       // against the reference
  bool times = true;        // of repeated frames
  bool columns = true;      // all of them; else of the errors only what bound() needs, and no counts
  int frames = 20;          // as many are timed, unless they take very long
  bool all_frames = false;  // however long they take
};

class Bench {
 public:
  // kept_truths: how many references are held for the next rows.
  Bench(Renderer& renderer, const FrameCost& cost, Machine machine, size_t kept_truths)
      : renderer_(renderer), cost_(cost), machine_(std::move(machine)), truths_(kept_truths, all_processors()) {}

  // Begins a row. The settings must be valid on this device; the scene is the one that they name.
  void start(const Settings&, std::shared_ptr<const GpuScene>, BenchWishes);
  // Does the next piece of work. True when the row is complete; `wait`: as much as it takes.
  bool step(bool wait);
  bool running() const { return phase_ != Phase::done; }
  void stop();  // gives the row up

  // Of the row that is complete.
  MeasuredColumns row() const;
  const Errors& errors() const { return errors_; }
  double total_ms() const;  // median; infinite if nothing was timed
  const FrameReport& report() const { return report_; }
  const std::shared_ptr<const TruthSet>& truth() const { return truth_; }  // null without errors
  const Drawn& drawn() const { return drawn_; }
  Image picture();          // of the frame measured last: the view `final`; waits for the GPU
  Thumbnails thumbnails();  // of the same; needs errors
  // The bound of renderer/truth/measure.h, of the frame measured last (needs errors).
  BoundCheck bound(double display_difference) const;

 private:
  enum class Phase { truth, warm_up, times, judge, done };
  void time_a_frame();
  void judge();

  Renderer& renderer_;
  const FrameCost& cost_;
  Machine machine_;
  TruthKeeper truths_;
  Targets targets_;
  Settings settings_;
  std::shared_ptr<const GpuScene> scene_;
  BenchWishes wishes_;
  Phase phase_ = Phase::done;
  std::shared_ptr<const TruthSet> truth_;
  Timing timing_;
  double begun_s_ = 0, slowest_s_ = 0;
  FrameReport report_;
  Errors errors_;
  Drawn drawn_;
};

}  // namespace gbl
