#pragma once
// The numbers of the pitfall that is open in the window: broken, fixed, and where it hides, one after the other while
// nothing else wants the machine. Once measured they are kept.
#include <map>

#include "app/background.h"
#include "app/pitfall_bench.h"
#include "renderer/study/pitfalls/judge.h"

namespace gbl {

class BackgroundPitfall : public BackgroundJob {
 public:
  explicit BackgroundPitfall(Lab& lab) : lab_(lab) {}

  void update(const Settings& now, const ui::Requests&, bool quiet) override;
  bool busy() const override { return shown_.running; }
  void forget() override;
  void fill(ui::Input& in) const override { in.pitfall = &shown_; }

 private:
  void work();
  bool measure_side();  // false: there is more to do, or it is not there yet
  bool measure_path();
  std::optional<double> number_of(PitfallSide, std::optional<double> along);  // empty: not there yet

  Lab& lab_;
  std::optional<PitfallBench> bench_;  // from the first entry on
  std::map<std::string, ui::PitfallInput> known_;
  std::optional<PitfallEntry> entry_;
  ui::PitfallInput shown_;
};

}  // namespace gbl
