#include "app/load_stage.h"

#include <fmt/format.h>

namespace gbl {

LoadStage::LoadStage() {
  progress_.report = [this](std::string_view stage, double fraction) {
    const std::lock_guard lock(mutex_);
    text_ = fmt::format("{}, {:.0f} %", stage, 100 * fraction);
  };
  begin();
}

void LoadStage::begin() {
  progress_.cancelled = false;
  const std::lock_guard lock(mutex_);
  text_ = "opening";
}

std::string LoadStage::text() const {
  const std::lock_guard lock(mutex_);
  return text_;
}

}  // namespace gbl
