#include "ui/bookmarks.h"

#include <fmt/format.h>

#include "ui/commands.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

std::optional<Snapshot>& bookmark_of(FrameContext& f, const KeyEvent& e) {
  return f.state.bookmarks[static_cast<size_t>(e.key[0] - '1')];
}

void keep_in(FrameContext& f, const KeyEvent& e, const char* was) {
  bookmark_of(f, e) = Snapshot{f.settings, f.state.large};
  say(f, {fmt::format("Bookmark {} {}: this is kept there. Ctrl+{} comes back to it.", e.key, was, e.key), ""});
}

}  // namespace

void keep_bookmark(FrameContext& f, const KeyEvent& e) {
  keep_in(f, e, bookmark_of(f, e) ? "is replaced" : "was empty");
}

void go_to_bookmark(FrameContext& f, const KeyEvent& e) {
  const std::optional<Snapshot>& kept = bookmark_of(f, e);
  if (!kept) return keep_in(f, e, "was empty");
  const Settings before = f.settings;
  if (!replace_settings(f, kept->settings)) return;
  f.state.large = kept->large;
  Sentence changes = describe_change(before, f.settings);
  if (changes.text.empty())
    changes.text = f.settings == before ? "It keeps what is shown now." : "The camera, or what is looked at.";
  say(f, {fmt::format("Bookmark {}. {}", e.key, changes.text), changes.pitfall});
}

}  // namespace gbl::ui
