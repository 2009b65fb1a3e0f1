#include <fmt/format.h>
#include <utility>

#include "app/commands.h"
#include "app/file_opening.h"
#include "app/lab_window.h"

namespace gbl {

namespace {

// What is named without an option, as what it is.
Arguments with_file(Arguments a) {
  if (!a.file) return a;
  const FileKind kind = kind_of_file(*a.file);
  std::optional<std::string>& into = kind == FileKind::model ? a.scene : kind == FileKind::rig ? a.rig : a.state;
  if (into)
    throw Error(ExitCode::bad_input, *a.file, fmt::format("and {}: two of a kind are given", *into), "leave one out");
  into = std::exchange(a.file, std::nullopt);
  return a;
}

}  // namespace

ExitCode run_view(const Arguments& given) {
  const Arguments a = with_file(given);
  if (!display_present()) setup_of(a);  // what is wrong with the command line is said first
  LabWindow window(a);
  const int frames = a.frames.value_or(0);  // 0: until it is closed
  for (int n = 0; frames == 0 || n < frames; ++n)
    if (!window.step()) break;
  window.keep();
  return ExitCode::done;
}

}  // namespace gbl
