#pragma once
// The session's file: read when the window opens, written every few seconds when something has changed, and when it
// closes. Whatever goes wrong with it is said, and the window goes on.
#include <filesystem>
#include <optional>
#include <string>

#include "app/session.h"

namespace gbl {

// $XDG_STATE_HOME/gbufferlab/session.json, or ~/.local/state/…; empty: the environment names no folder.
std::optional<std::filesystem::path> session_file();

class SessionKeeper {
 public:
  explicit SessionKeeper(std::optional<std::filesystem::path> file);  // reads it; one that is damaged is put aside

  const Session& found() const { return found_; }
  // As session.json.bad, when it cannot be used for this reason; where that fails nothing is written over it.
  void put_aside(const std::string& why);

  bool due(double seconds) const { return file_ && seconds >= next_s_; }
  void keep(const Session&, double seconds);  // if it has changed
  std::string take_trouble();                 // in a sentence, once; empty: none

 private:
  void complain(std::string);
  std::optional<std::filesystem::path> file_;  // empty: nothing is kept
  Session found_, kept_;
  double next_s_ = 0;
  std::string trouble_, said_;
};

}  // namespace gbl
