#pragma once
// A scene read on another thread while the window goes on.
#include <future>
#include <memory>
#include <string>

#include "app/load_stage.h"

namespace gbl {

class SceneLoader {
 public:
  ~SceneLoader();                // cancels and waits
  void start(std::string name);  // cancels what is under way
  bool loading() const { return task_.valid(); }
  const std::string& name() const { return name_; }
  std::string progress() const { return stage_.text(); }

  // The scene once it is there, null before; Error if it cannot be read. `wait` blocks.
  std::shared_ptr<const Scene> take(bool wait = false);

 private:
  void cancel();
  std::string name_;
  std::future<std::shared_ptr<const Scene>> task_;
  LoadStage stage_;
};

}  // namespace gbl
