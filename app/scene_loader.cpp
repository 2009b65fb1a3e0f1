#include "app/scene_loader.h"

#include <chrono>

#include "renderer/base/threads.h"

namespace gbl {

SceneLoader::~SceneLoader() { cancel(); }

void SceneLoader::cancel() {
  if (!task_.valid()) return;
  stage_.cancel();
  task_.wait();
  task_ = {};
}

void SceneLoader::start(std::string name) {
  cancel();
  stage_.begin();
  name_ = std::move(name);
  task_ = in_background([this] { return open_scene(name_, &stage_.progress()); });
}

std::shared_ptr<const Scene> SceneLoader::take(bool wait) {
  if (!task_.valid()) return nullptr;
  if (!wait && task_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return nullptr;
  return task_.get();
}

}  // namespace gbl
