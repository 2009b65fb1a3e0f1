#include "app/commands.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <new>
#include <system_error>

#include "renderer/base/files.h"
#include "renderer/base/json_error.h"
#include "renderer/gbuffer/layout_file.h"

namespace gbl {
namespace {

constexpr Command kCommands[] = {
    {"view", "open the window: the lab itself", run_view},
    {"render", "draw without a window: each view as a PNG, a captioned sheet", run_render},
    {"probe", "one pixel: the stored bits of every attachment, and what the lighting reads from them", run_probe},
    {"bench", "one set-up measured: errors against the reference, times, pairs, bytes", run_bench},
    {"study", "many set-ups measured and charted: speed against accuracy; goes on where it was stopped",
     run_study_command},
    {"advise", "the cheapest set-up for this scene that holds an error budget, and what it leaves out", run_advise},
    {"stability", "one parameter through the place where methods break, each curve with a statement that is checked",
     run_stability},
    {"pitfalls", "where methods fail: each pitfall broken and fixed, judged by the reference", run_pitfalls},
    {"figures", "captioned figures for lecture notes, from data: Markdown and LaTeX beside each picture", run_figures},
    {"handout",
     "a lesson on paper: figures, questions with room to write, answers at the end; or the lecturer's script",
     run_handout},
    {"exercise", "tasks from the tutorials: a state to begin with, an answer that is measured, a class graded",
     run_exercise},
    {"list",
     "presets, scenes, layouts, encodings, positions, methods, mistakes, views, overlays, options, keys, pitfalls, "
     "lessons, studies, exercises",
     run_list},
    {"info", "the driver, its limits and its rounding; which features are there and why not", run_info},
};

ExitCode run(const Arguments& a) {
  if (a.run_layouts) allow_every_layout_file();
  if (a.command.empty()) return display_present() ? run_view(a) : run_start_sheets(a);
  for (const Command& c : kCommands)
    if (a.command == c.name) return c.run(a);
  return ExitCode::bad_input;
}

// fmt::print() names no file where it fails; flush_output() does.
ExitCode run_and_print(const Arguments& a) {
  try {
    const ExitCode code = run(a);
    flush_output();
    return code;
  } catch (const std::system_error& e) {
    errno = e.code().value();
    flush_output();
    throw;
  }
}

int complain(const char* message, ExitCode code) {
  fmt::print(stderr, "gbufferlab: {}\n", message);
  return static_cast<int>(code);
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

void say_choices(const std::vector<std::string>& choices) {
  for (const std::string& c : choices) fmt::print(stderr, "gbufferlab: {}\n", c);
}

bool display_present() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"})
    if (const char* value = std::getenv(name); value && *value) return true;
  return false;
}

int run_program(int argc, const char* const* argv) {
  // Files are renamed into place when whole, so leaving at once loses nothing but a temporary file.
  for (const int end : {SIGINT, SIGTERM})
    std::signal(end, [](int) { std::_Exit(static_cast<int>(ExitCode::interrupted)); });
  try {
    const std::optional<Arguments> a = parse_arguments(argc, argv);
    if (!a) return flush_output(), static_cast<int>(ExitCode::done);
    return static_cast<int>(run_and_print(*a));
  } catch (const Error& e) {
    return complain(e.what(), e.code());
  } catch (const std::bad_alloc&) {
    return complain("out of memory; choose a smaller size or scene", ExitCode::unfinished);
  } catch (const std::exception& e) {
    return complain(printable(without_library(e.what()), 300).c_str(), ExitCode::unfinished);
  }
}

}  // namespace gbl
