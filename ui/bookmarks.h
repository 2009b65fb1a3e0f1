#pragma once
// What is kept by Ctrl+Shift+1…9 and come back to by Ctrl+1…9.
#include <array>
#include <optional>

#include "renderer/options/settings.h"

namespace gbl::ui {

// What the window shows: the settings, and whether their view is shown alone.
struct Snapshot {
  Settings settings;
  bool large = false;
  bool operator==(const Snapshot&) const = default;
};

inline constexpr size_t kBookmarks = 9;
using Bookmarks = std::array<std::optional<Snapshot>, kBookmarks>;  // of the keys 1…9

}  // namespace gbl::ui
