#pragma once
// What the window starts with: what the command line says, or where the window was left.
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/session_keeper.h"

namespace gbl {

// A command line that says nothing of what is shown leaves it to the session. A talk and a lesson begin as they are
// written.
bool goes_on(const Arguments&);
// And they leave the session's settings as they were.
bool is_remembered(const Arguments&);

struct Start {
  Setup asked;                              // by the command line: Home returns to it
  std::optional<ui::Snapshot> left;         // where the window goes on, if it does
  std::shared_ptr<const Scene> left_scene;  // of those settings
};

// Reads the scene; a session whose files are gone is put aside. Error for a bad command line.
Start start_of(const Arguments&, SessionKeeper&, const LoadProgress* = nullptr);

}  // namespace gbl
