#include "app/manual.h"

#include <fmt/format.h>

#include "app/commands.h"
#include "renderer/base/files.h"
#include "renderer/base/made_by.h"
#include "renderer/lessons/lessons.h"
#include "renderer/options/options.h"
#include "renderer/options/presets.h"
#include "renderer/scenes/builtin_scenes.h"
#include "renderer/study/pitfalls/catalogue.h"

namespace gbl {
namespace {

// Text of roff: what begins a command there, or means a dash of other kinds, is made plain.
std::string in_roff(std::string_view text) {
  std::string out = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\') out += "\\e";
    if (c == '-') out += "\\-";
    if (c != '\\' && c != '-') out += c;
  }
  return out;
}

std::string bold(std::string_view text) { return "\\fB" + in_roff(text) + "\\fR"; }

std::string option_rows(const CommandText& command) {
  std::string out;
  for (const OptionText& o : command.options)
    out += fmt::format(".TP\n{}{}\n{}\n", bold(o.names), o.type.empty() ? "" : " \\fI" + in_roff(o.type) + "\\fR",
                       in_roff(o.help));
  return out;
}

struct ExitRow {
  ExitCode code;
  const char* words;
};
constexpr ExitRow kExitRows[] = {
    {ExitCode::done, "done"},
    {ExitCode::check_failed, "a check failed: a curve's statement, a pitfall's proof, an exercise"},
    {ExitCode::bad_input, "bad input: a file, an option, the command line"},
    {ExitCode::no_gl, "there is no OpenGL that can be used"},
    {ExitCode::unfinished, "could not finish: a full disk, no memory"},
    {ExitCode::interrupted, "interrupted"},
};

// ---- bash

template <class Rows, class Name>
std::string words_of(const Rows& rows, Name name) {
  std::string out;
  for (const auto& r : rows) out += (out.empty() ? "" : " ") + std::string(name(r));
  return out;
}

// "-o,--output" -> "-o --output"; what has no dash is no word to complete.
std::string option_words(const CommandText& command) {
  std::string out;
  for (const OptionText& o : command.options) {
    if (!o.names.starts_with('-')) continue;
    for (const char c : o.names) out += c == ',' ? ' ' : c;
    out += ' ';
  }
  return out;
}

}  // namespace

std::string man_page() {
  const std::vector<CommandText> commands = command_texts();
  std::string out = fmt::format(".TH GBUFFERLAB 1 \"\" \"gbufferlab {}\" \"User commands\"\n",
                                made_by().substr(0, made_by().find(' ')));
  out += ".SH NAME\ngbufferlab \\- see every buffer of a deferred renderer, and what each choice costs\n";
  out += ".SH SYNOPSIS\n" + bold("gbufferlab") + " [options] [command] [options]\n";
  out +=
      ".SH DESCRIPTION\nWithout a command the window opens or, where there is no display, the start sheet is drawn "
      "into out/. "
      "Press F1 in the window for all keys.\n";
  out += ".SH OPTIONS\n" + option_rows(commands.front());
  out += ".SH COMMANDS\n";
  for (size_t i = 1; i < commands.size(); ++i)
    out += fmt::format(".SS {}\n{}\n{}", commands[i].name, in_roff(commands[i].help), option_rows(commands[i]));
  out += ".SH EXIT STATUS\n";
  for (const ExitRow& r : kExitRows) out += fmt::format(".TP\n{}\n{}\n", static_cast<int>(r.code), in_roff(r.words));
  out +=
      ".SH FILES\n.TP\n$XDG_STATE_HOME/gbufferlab\nwhere the window was left, what this driver was asked, and its "
      "calibration "
      "(else ~/.local/state/gbufferlab). Pictures go to out/ in the working folder, or where \\-o says.\n";
  return out;
}

std::string bash_completion() {
  const std::vector<CommandText> commands = command_texts();
  std::string cases;
  for (size_t i = 1; i < commands.size(); ++i)
    cases += fmt::format("    {}) words=\"{}\" ;;\n", commands[i].name, option_words(commands[i]));
  const std::string names = words_of(std::span(commands).subspan(1), [](const CommandText& c) { return c.name; });
  const auto id = [](const auto& row) { return row.id; };
  const auto value = [](const char* option, const std::string& words) {
    return fmt::format("    {}) words=\"{}\" ;;\n", option, words);
  };
  const std::string scenes = words_of(builtin_scenes(), [](const auto& s) { return std::string("builtin:") + s.id; });
  return "# bash completion of gbufferlab, made from its tables\n_gbufferlab() {\n"
         "  local cur prev word command words=\n"
         "  _get_comp_words_by_ref -n := cur prev\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case \" " +
         names +
         " \" in *\" $word \"*) command=$word; break ;; esac\n"
         "  done\n"
         "  case $command in\n" +
         cases + "    *) words=\"" + names + " " + option_words(commands.front()) +
         "\" ;;\n  esac\n"
         "  case $prev in\n" +
         value("--preset", words_of(presets(), id)) + value("--scene", scenes) +
         value("--lesson", words_of(lesson_ids(), [](const std::string& l) { return l; })) +
         value("--pitfall", words_of(load_pitfalls(), [](const PitfallEntry& e) { return e.id; })) +
         value("--gl", "core es3") +
         value("--set", words_of(options(), [](const Option& o) { return std::string(o.path) + "="; })) +
         "  esac\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$cur\")\n"
         "  if [[ $prev == --set ]]; then compopt -o nospace; fi\n"
         "  __ltrim_colon_completions \"$cur\"\n"
         "}\n"
         "complete -o default -F _gbufferlab gbufferlab\n";
}

void write_manual(const std::filesystem::path& folder) {
  make_folder(folder);
  write_text_file(folder / "gbufferlab.1", man_page());
  write_text_file(folder / "gbufferlab", bash_completion());
}

}  // namespace gbl
