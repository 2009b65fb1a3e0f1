#pragma once
// How far a file is read, said by the thread that reads it and shown by the one that draws.
#include <mutex>
#include <string>

#include "renderer/opening/scene_look.h"

namespace gbl {

class LoadStage {
 public:
  LoadStage();
  LoadStage(const LoadStage&) = delete;
  const LoadProgress& progress() const { return progress_; }  // for the thread that reads
  void begin();                                               // before it does
  void cancel() { progress_.cancelled = true; }               // it then ends in Error(interrupted)
  std::string text() const;                                   // "textures, 40 %"

 private:
  LoadProgress progress_;
  mutable std::mutex mutex_;
  std::string text_;
};

}  // namespace gbl
