#include "app/session_keeper.h"

#include <fmt/format.h>
#include <utility>

#include "app/state_folder.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

constexpr double kPauseSeconds = 5;  // between two writings: what a crash may lose

Session read_session(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) return {};
  if (status.type() != fs::file_type::regular) throw Error(ExitCode::bad_input, file.string(), "is not a file");
  return parse_session(read_text_file(file), file.string());
}

}  // namespace

std::optional<fs::path> session_file() {
  std::optional<fs::path> folder = state_folder();
  if (folder) *folder /= "session.json";
  return folder;
}

SessionKeeper::SessionKeeper(std::optional<fs::path> file) : file_(std::move(file)) {
  if (!file_) {
    complain("neither XDG_STATE_HOME nor HOME names a folder: this window will not be remembered");
    return;
  }
  try {
    found_ = kept_ = read_session(*file_);
  } catch (const Error& e) {
    put_aside(e.what());
  } catch (const fs::filesystem_error& e) {
    put_aside(e.what());
  }
}

void SessionKeeper::put_aside(const std::string& why) {
  if (!file_) return;
  const fs::path aside = file_->string() + ".bad";
  std::error_code error;
  fs::rename(*file_, aside, error);
  kept_ = {};
  if (!error)
    return complain(fmt::format("{}. The window starts afresh; that file is kept as {}", why, aside.string()));
  file_.reset();
  complain(
      fmt::format("{}. The window starts afresh. That file cannot be renamed to {} ({}), so it stays and this "
                  "window will not be remembered",
                  why, aside.string(), error.message()));
}

void SessionKeeper::keep(const Session& now, double seconds) {
  next_s_ = seconds + kPauseSeconds;
  if (!file_ || now == kept_) return;
  try {
    make_private_folder(file_->parent_path());
    write_text_file(*file_, session_text(now));
    kept_ = now;
    said_.clear();
  } catch (const Error& e) {
    complain(fmt::format("this window is not remembered: {}", e.what()));
  } catch (const fs::filesystem_error& e) {
    complain(fmt::format("this window is not remembered: {}", e.what()));
  }
}

// Tried again and again, said once.
void SessionKeeper::complain(std::string sentence) {
  if (sentence != said_) trouble_ = said_ = std::move(sentence);
}

std::string SessionKeeper::take_trouble() { return std::exchange(trouble_, ""); }

}  // namespace gbl
