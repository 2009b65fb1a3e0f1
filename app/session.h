#pragma once
// What a window leaves to the next one, as a value and as JSON:
//   {"version": 1, "last": {"large": false, "settings": {…}}, "bookmarks": {"3": {…}}, "recent": ["/home/…/model.glb"]}
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/bookmarks.h"

namespace gbl {

inline constexpr int kSessionVersion = 1;
inline constexpr size_t kMostRecent = 10;

struct Session {
  std::optional<ui::Snapshot> last;  // what the window showed; empty: no window has said so yet
  ui::Bookmarks bookmarks;
  std::vector<std::string> recent;  // files that were opened, the newest first
  bool operator==(const Session&) const = default;
};

// To the front of the list, by its absolute path.
void remember(std::vector<std::string>& recent, const std::string& file);

// Files that settings name are written as absolute paths: the next window may start in another folder.
std::string session_text(const Session&);
Session parse_session(std::string_view text, std::string_view where);  // Error(bad_input)

}  // namespace gbl
