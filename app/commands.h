#pragma once
// The commands: name, help and function, one row each; and what the command line gave them.
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/base/features.h"
#include "renderer/gl/device.h"
#include "renderer/options/options.h"
#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

struct LoadProgress;

// The command line, read but not yet judged: see settings_of() for the order in which its parts apply.
struct Arguments {
  std::string command;                // empty: none given
  std::string what;                   // of `list`, `study` and `figures`
  std::vector<std::string> sweeps;    // of `stability`; none: all
  std::optional<int> configurations;  // of each family of random ones
  std::vector<std::string> pitfalls;  // by id; none: all
  bool list = false;                  // of `pitfalls` and `figures`: only what there is

  std::optional<std::string> file;  // of `view`: a model, a state or a rig, as what it is
  std::optional<std::string> scene, preset, state, rig, camera, size, layout_file;
  std::optional<int> lights;
  std::optional<unsigned> seed;
  std::optional<double> time;
  std::vector<std::string> set;
  bool run_layouts = false;  // those that a state, a study, a figure or a lesson names
  std::string without;
  std::string gl = "core";  // or "es3"
  bool json = false, markdown = false;

  std::optional<std::filesystem::path> output;  // -o DIR
  std::string only;                             // views, comma-separated
  bool raw = false, sheet = false, exr = false, png16 = false;
  std::optional<double> scale, width_cm;                                         // of `figures`
  bool script = false;                                                           // of `handout`
  bool light = false, grey = false, few_colours = false, pictures_only = false;  // of `figures`
  std::optional<std::filesystem::path>
      check;                                 // of `figures`: compare with this folder; of `exercise`: an answer, or "-"
  std::optional<int> pixel_x, pixel_y;       // of `probe`, origin top left
  std::optional<double> budget, budget_max;  // of `advise`: codes of 255 as displayed
  std::string cost = "time";                 // of `advise`
  bool apply = false;                        // of `advise`: write the settings
  std::optional<std::string> shard;          // of `study`: "i/n"
  std::optional<std::string> axes;           // of `study`: options, comma-separated
  std::optional<std::string> time_budget;    // of `study`: "10m"
  std::vector<std::filesystem::path> merge;  // of `study`: folders to make one of
  bool present = false, fresh = false;
  std::string lesson, pitfall;  // of `view`: open this one
  std::optional<int> frames;    // `view`: draw so many and leave, 0: until closed; `bench`: time so many, 0: none
  std::optional<std::filesystem::path> grade;   // … a class's folder
  bool csv = false;                             // … as a table
  std::optional<double> limit_s;                // … seconds for one answer
  bool here = false;                            // … judged in this process
  bool no_truth = false;                        // of `bench`: without the reference
  std::string growth;                           // … how time grows along this axis
  bool calibrate = false;                       // … what each kind of work costs on this device
  bool micro = false;                           // … what one pair costs
  std::vector<std::string> against;             // … the same with these options, in turn
  std::optional<std::filesystem::path> docs;    // of `list`: the folder of the documents' tables
  std::optional<std::filesystem::path> manual;  // … of a man page and the shell's completions
  std::optional<std::filesystem::path> report;  // of `info`
  std::vector<std::filesystem::path> reports;   // of `info`: such files as a table
};

// None: help or the version was asked for, and is printed. Throws Error(bad_input).
std::optional<Arguments> parse_arguments(int argc, const char* const* argv);

// defaults < preset < state < scene < camera, lights, rig, seed, size, time < set, whatever the order on the line.
// The scene comes along when it had to be opened on the way, so that it is not read twice.
struct Setup {
  Settings settings;
  std::shared_ptr<const Scene> scene;  // of settings.scene, or null
};
Setup setup_of(const Arguments&, const LoadProgress* = nullptr);
void apply_typed(Settings&, const std::string& assignment);  // "layout-file=mine.glsl": what is typed may run
FeatureSet without_of(const Arguments&);
gl::Api api_of(const Arguments&);

// The same for a study, which has settings of its own: path by path what the line gives, and apart what its state says.
struct Given {
  std::vector<Assignment> state, explicitly;
};
Given given_of(const Arguments&);

struct Command {
  const char* name;
  const char* help;
  ExitCode (*run)(const Arguments&);
};
std::span<const Command> commands();

ExitCode run_view(const Arguments&);
ExitCode run_render(const Arguments&);
ExitCode run_probe(const Arguments&);
ExitCode run_bench(const Arguments&);
ExitCode run_study_command(const Arguments&);
ExitCode run_advise(const Arguments&);
ExitCode run_stability(const Arguments&);
ExitCode run_pitfalls(const Arguments&);
ExitCode run_figures(const Arguments&);
ExitCode run_handout(const Arguments&);
ExitCode run_exercise(const Arguments&);
ExitCode run_list(const Arguments&);
// The grammar of the command line, for the manual.
struct OptionText {
  std::string names, type, help;  // "-o,--output", "TEXT", …; names without a dash: a word of its own
};
struct CommandText {
  std::string name, help;  // no name: what stands before any command
  std::vector<OptionText> options;
};
std::vector<CommandText> command_texts();

// As `list WHAT --md` prints it; `columns` chooses some of them.
std::string list_markdown(const std::string& what, std::span<const std::string_view> columns = {});
ExitCode run_info(const Arguments&);
ExitCode run_start_sheets(const Arguments&);  // what happens without a command and without a display

bool display_present();

// What was chosen, reduced or left out, and why; on standard error, a line each.
void say_choices(const std::vector<std::string>&);

// Catches what commands throw: one line on standard error and the exit code.
int run_program(int argc, const char* const* argv);

}  // namespace gbl
