#pragma once
// The truths of the settings judged last: made once, kept while they are wanted.
#include <deque>
#include <memory>

#include "renderer/passes/judging.h"

namespace gbl {

class TruthKeeper {
 public:
  // kept: how many truths are held at once (about 250 bytes per pixel each).
  TruthKeeper(size_t kept, int threads) : kept_(kept), threads_(threads) {}

  // The truth of these settings in this scene; null while it is being made (one for other settings is given up).
  // `wait` blocks until it is there. The scene must not change its content under the same name.
  std::shared_ptr<const TruthSet> get(Renderer&, const GpuScene&, const Settings&, bool wait);
  // Of the one being made, 0..1; 1 when none is.
  double progress() const { return maker_ ? maker_->progress() : 1; }
  bool working() const { return maker_ != nullptr; }
  void stop() { maker_.reset(); }  // gives up the one being made
  void forget();                   // another scene stands under an old name

 private:
  size_t kept_;
  int threads_;
  std::deque<std::shared_ptr<const TruthSet>> sets_;  // newest first
  std::unique_ptr<TruthMaker> maker_;
};

}  // namespace gbl
