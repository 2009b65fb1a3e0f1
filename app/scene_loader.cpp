#include "app/scene_loader.h"

#include <chrono>
#include <fmt/format.h>

namespace gbl {

SceneLoader::~SceneLoader() { cancel(); }

void SceneLoader::cancel() {
  if (!task_.valid()) return;
  progress_.cancelled = true;
  task_.wait();
  task_ = {};
}

void SceneLoader::start(std::string name) {
  cancel();
  progress_.cancelled = false;
  progress_.report = [this](std::string_view stage, double fraction) {
    const std::lock_guard lock(mutex_);
    stage_ = fmt::format("{}, {:.0f} %", stage, 100 * fraction);
  };
  {
    const std::lock_guard lock(mutex_);
    stage_ = "opening";
  }
  name_ = std::move(name);
  task_ = std::async(std::launch::async, [this] { return open_scene(name_, &progress_); });
}

std::string SceneLoader::progress() const {
  const std::lock_guard lock(mutex_);
  return stage_;
}

std::shared_ptr<const Scene> SceneLoader::take(bool wait) {
  if (!task_.valid()) return nullptr;
  if (!wait && task_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return nullptr;
  return task_.get();
}

}  // namespace gbl
