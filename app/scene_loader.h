#pragma once
// A scene read on another thread while the window goes on.
#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <string>

#include "renderer/base/error.h"
#include "renderer/opening/scene_look.h"

namespace gbl {

class SceneLoader {
 public:
  ~SceneLoader();                // cancels and waits
  void start(std::string name);  // cancels what is under way
  bool loading() const { return task_.valid(); }
  const std::string& name() const { return name_; }
  std::string progress() const;  // "textures, 40 %"

  // The scene once it is there, null before; Error if it cannot be read. `wait` blocks.
  std::shared_ptr<const Scene> take(bool wait = false);

 private:
  void cancel();
  std::string name_;
  std::future<std::shared_ptr<const Scene>> task_;
  LoadProgress progress_;
  mutable std::mutex mutex_;
  std::string stage_;
};

}  // namespace gbl
