// The command line's grammar. CLI11 compiles slowly: it is seen by this file only.
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <iostream>
#include <limits>
#include <type_traits>

#include "app/commands.h"
#include "renderer/base/limits.h"
#include "renderer/base/number.h"

namespace gbl {
namespace {

constexpr const char* kTitle = "G-Buffer Lab: see every buffer of a deferred renderer, and what each choice costs.";

// A number, read by the rule of all options.
template <class Value>
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<Value>& into, const std::string& help,
                        double least, double most) {
  const auto take = [&into, name, least, most](const std::string& text) {
    constexpr bool kWhole = std::is_integral_v<Value>;
    const std::optional<double> n = kWhole ? std::optional<double>(whole_decimal(text)) : decimal(text);
    if (!n)
      throw Error(ExitCode::bad_input, name, fmt::format("'{}' is not a {}", text, kWhole ? "whole number" : "number"),
                  kWhole ? "write it in decimal digits, e.g. 12" : "write a decimal, e.g. 12 or 0.5");
    if (*n < least || *n > most)
      throw Error(ExitCode::bad_input, name, fmt::format("{} is outside {} to {}", text, least, most));
    into = static_cast<Value>(*n);
  };
  return app.add_option_function<std::string>(name, take, help)
      ->type_name(std::is_integral_v<Value> ? "INT" : "NUMBER");
}

constexpr double kAnyInt = std::numeric_limits<int>::max();
constexpr double kAnyNumber = std::numeric_limits<double>::max();

void add_run_layouts(CLI::App& app, Arguments& a) {
  app.add_flag("--run-layouts", a.run_layouts,
               "run the layout files that a state, study, figure or lesson names: text for the GPU, else refused");
}

// What is drawn: for the commands that draw.
void add_settings(CLI::App& app, Arguments& a) {
  app.add_option("--scene", a.scene, "builtin:NAME or a model's file; brings its own camera and lights");
  app.add_option("--preset", a.preset, "whole settings by name (list presets)");
  app.add_option("--state", a.state, "settings from a JSON file or from a PNG that this program wrote");
  app.add_option("--set", a.set, "one option (list options); repeatable: --set a=1 --set b=2")
      ->allow_extra_args(false)
      ->option_text("PATH=VALUE");
  app.add_option("--size", a.size, "WxH in pixels");
  add_number(app, "--lights", a.lights, fmt::format("number of generated lights, 0 to {}", kMaxLights), -kAnyInt,
             kAnyInt);
  add_number(app, "--seed", a.seed, "of the generated lights", 0, std::numeric_limits<unsigned>::max());
  app.add_option("--camera", a.camera, "x,y,z:yaw,pitch[:fov] in world units and degrees");
  app.add_option("--rig", a.rig, "lights from a rig's JSON file");
  app.add_option("--layout-file", a.layout_file, "a layout of your own: one GLSL file, see docs/layout-files.md");
  add_run_layouts(app, a);
  add_number(app, "--time", a.time, "seconds: lights move as functions of it", -kAnyNumber, kAnyNumber);
}

void add_without(CLI::App& app, Arguments& a) {
  app.add_option("--without", a.without, "features to switch off, comma-separated (info lists them)");
  app.add_option("--gl", a.gl, "core: OpenGL 3.3 (default); es3: OpenGL ES 3.0, what a browser has")->type_name("API");
}

void add_own_options(CLI::App& app, const std::string& command, Arguments& a) {
  add_without(app, a);
  if (command == "render" || command == "view" || command == "bench" || command == "probe") add_settings(app, a);
  CLI::Option* json = command == "view" ? nullptr : app.add_flag("--json", a.json, "machine-readable output");
  if (command == "render") {
    app.add_option("-o,--output", a.output, "folder for the pictures, made if need be (default: out)");
    app.add_option("--only", a.only,
                   "views, comma-separated (list views); default: those that have a key and are stored");
    app.add_flag("--raw", a.raw, "also NAME.raw.png: the stored codes, undecoded");
    app.add_flag("--png16", a.png16, "also VIEW.16.png: the numbers between the view's black and white in 16 bits");
    app.add_flag("--exr", a.exr, "also layers.exr: the numbers of all these views, as floats");
    app.add_flag("--sheet", a.sheet, "also sheet.png: all pictures with captions and legends");
  }
  if (command == "probe") {
    constexpr double kMost = 1 << 20;
    add_number(app, "x", a.pixel_x, "column of the pixel, from 0 at the left", 0, kMost)->required();
    add_number(app, "y", a.pixel_y, "row of the pixel, from 0 at the top", 0, kMost)->required();
  }
  if (command == "view") {
    app.add_option("file", a.file, "a model, settings, a rig, or a picture that this program wrote: as if dropped");
    app.add_flag("--present", a.present,
                 "the picture fills the window, one caption in large type; Ctrl+Shift+P: everything");
    app.add_option("--lesson", a.lesson,
                   "open this lesson (list lessons), NAME:3 at its third step; a --state is shown with it");
    app.add_option("--pitfall", a.pitfall, "open this pitfall, broken (list pitfalls)");
    app.add_flag("--fresh", a.fresh, "start as loaded and not where the window was left");
    add_number(app, "--frames", a.frames, "draw so many frames and leave", 0, kAnyInt);
  }
  if (command == "bench") {
    add_number(app, "--frames", a.frames, "time so many frames; 0: none (default: up to 20)", 0, kAnyInt);
    app.add_flag("--no-truth", a.no_truth,
                 "without the reference: no errors, and the GPU counts the pairs that are lit");
    app.add_option("--against", a.against,
                   "PATH=VALUE: time the same with this option in turn and give the ratio; repeatable");
    app.add_option("--growth", a.growth, "lights, pixels, overlap or triangles: how time and memory grow with it");
    app.add_option("-o,--output", a.output, "folder of the chart of --growth, made if need be (default: none)");
    app.add_flag("--calibrate", a.calibrate,
                 "measure what each kind of work costs on this device, and keep it: lights.method=auto chooses by it");
    app.add_flag("--micro", a.micro,
                 "what one (pixel, light) pair costs, by shading model, falloff and method (default scene: hall)");
  }
  if (command == "advise") {
    add_settings(app, a);
    add_number(app, "--budget", a.budget, "codes of 255 as displayed that 99.9 % of the pixels must hold (default: 1)",
               -kAnyNumber, kAnyNumber);
    add_number(app, "--budget-max", a.budget_max, "the same for every pixel", -kAnyNumber, kAnyNumber);
    app.add_option("--cost", a.cost, "what is to be small: time, bytes or pairs (default: time)");
    app.add_flag("--apply", a.apply, "write the set-up to settings.json");
    app.add_option("-o,--output", a.output, "folder of advice.html and settings.json (default with --apply: out)");
  }
  if (command == "study") {
    add_settings(app, a);
    app.add_option("spec", a.what, "a built-in study (list studies) or a spec's JSON file; default: tradeoff");
    app.add_option("-o,--output", a.output,
                   "folder of rows.jsonl, the page and the charts, made if need be (default: out/NAME)");
    app.add_option(
        "--axes", a.axes,
        "make the study from options, comma-separated: every value of each alone first, then pairs, then more");
    app.add_option("--budget", a.time_budget,
                   "stop after this time, e.g. 90s, 10m, 1h30m; run it again and it goes on");
    app.add_option("--shard", a.shard, "i/n: every n-th case from the i-th, for several machines");
    app.add_option("--merge", a.merge, "folders of one study, e.g. of its shards, into -o DIR")->option_text("DIR ...");
  }
  if (command == "stability") {
    add_settings(app, a);
    app.add_option("sweep", a.sweeps, "sweeps by id; default: all. An unknown one is answered with the known ones");
    add_number(app, "--configurations", a.configurations, "of cull-families, in each family (default: 48)", 1, 1000);
    app.add_option("-o,--output", a.output,
                   "folder of points.jsonl, the page, tables and charts, made if need be (default: out/stability)");
    app.add_option("--shard", a.shard, "i/n: every n-th point of a curve from the i-th, for several machines");
  }
  if (command == "pitfalls") {
    app.add_option("id", a.pitfalls, "pitfalls by id; default: all");
    app.add_flag("--list", a.list, "only what there is");
    app.add_option("--size", a.size, "WxH of the pictures that are judged (default: 320x180)");
    app.add_option("-o,--output", a.output, "folder for a page and a picture each, made if need be (default: none)");
  }
  if (command == "figures" || command == "handout") add_run_layouts(app, a);
  if (command == "figures") {
    app.add_option("set", a.what,
                   "a set of figures, a spec's JSON file, or a picture made of one; without: what there is");
    app.add_flag("--list", a.list, "only what is in the set");
    app.add_option("--only", a.only, "figures by id, comma-separated; default: all");
    app.add_option("-o,--output", a.output,
                   "folder for pictures and captions, made if need be (default: out/figures/SET)");
    add_number(app, "--scale", a.scale, "of frames, type and lines, 0.25 to 8 (default: 1)", 0.25, 8);
    add_number(app, "--width-cm", a.width_cm, "as printed, at 300 dots per inch; the scale follows", 2, 100)
        ->excludes("--scale");
    app.add_flag("--light", a.light, "on white paper");
    app.add_flag("--grey", a.grey, "as a printer without colours shows it");
    app.add_flag("--pictures-only", a.pictures_only, "without captions");
    app.add_flag("--few-colours", a.few_colours, "256 colours at most: a third of the bytes");
    app.add_flag("--exr", a.exr, "also ID.exr: the numbers of the views in it, as floats");
    app.add_option("--check", a.check, "say which pictures in this folder are out of date; exit code 1 if any");
  }
  if (command == "handout") {
    app.add_option("lesson", a.what, "a lesson (list lessons), or a lesson's JSON file")->required();
    app.add_option("-o,--output", a.output, "folder for the handout, made if need be (default: out/handout)");
    app.add_flag("--script", a.script, "the lecturer's script instead: what to press, what to say, minutes");
  }
  if (command == "exercise") {
    CLI::Option* name = app.add_option("name", a.what, "an exercise; without one all are listed");
    CLI::Option* output = app.add_option("-o,--output", a.output,
                                         "folder for task, state, answer and pictures, made if need be; then no window "
                                         "opens (default: out/exercises/NAME)");
    CLI::Option* check =
        app.add_option("--check", a.check, "judge this answer's file; -: standard input. Exit code 1: it is wrong");
    CLI::Option* grade = app.add_option("--grade", a.grade,
                                        "judge a class: FOLDER/STUDENT/EXERCISE.json or FOLDER/STUDENT-EXERCISE.json");
    check->excludes(output);
    grade->excludes(name)->excludes(check)->excludes(output);
    app.add_flag("--csv", a.csv, "with --grade: a line for each answer")->needs(grade)->excludes(json);
    add_number(app, "--limit", a.limit_s,
               fmt::format("seconds that one answer may take (default: {:g})", kAnswerSeconds), 0.1, 86400);
    app.add_flag("--here", a.here, "judge in this process and not in one of its own")->needs(check)->group("");
  }
  if (command == "info") {
    CLI::Option* report = app.add_option(
        "--report", a.report,
        "draw twelve pictures, judge them by the reference, and write all that a bug report needs to this file");
    app.add_option("--table", a.reports, "such files as one Markdown table; nothing is drawn")
        ->excludes(report)
        ->excludes(json);
  }
  if (command == "list") {
    CLI::Option* what = app.add_option("what", a.what, "what to list; `list` alone names the choices");
    app.add_flag("--md", a.markdown, "as a Markdown table")->needs(what)->excludes(json);
    app.add_option("--docs", a.docs, "write the pages of docs/tables to this folder")->excludes(what);
    app.add_option("--manual", a.manual, "write a man page and bash's completions to this folder")->excludes(what);
  }
}

// Help of every command in one place: rows of commands().
void describe(CLI::App& app, Arguments& a) {
  app.set_version_flag("--version", "gbufferlab " GBL_VERSION);
  app.set_help_all_flag("--help-all", "help of all commands");
  add_settings(app, a);  // without a command it draws, too
  add_without(app, a);
  for (const Command& c : commands()) {
    CLI::App* sub = app.add_subcommand(c.name, c.help);
    add_own_options(*sub, c.name, a);
    sub->callback([&a, name = c.name] { a.command = name; });
  }
}

std::string unknown_argument(const CLI::App& app, const std::string& message) {
  // CLI11 says "The following argument was not expected: rendr": add what is known and what is near.
  const size_t colon = message.rfind(": ");
  if (message.find("not expected") == std::string::npos || colon == std::string::npos) return "";
  const std::string given = message.substr(colon + 2, message.find(' ', colon + 2) - colon - 2);
  std::vector<std::string> owned;
  const std::vector<const CLI::App*> subs = app.get_subcommands(nullptr);
  const CLI::App* current = app.get_subcommands().empty() ? &app : app.get_subcommands().front();
  if (given.starts_with("-")) {
    for (const CLI::Option* o : current->get_options()) owned.push_back(o->get_name());
  } else {
    for (const Command& c : commands()) owned.emplace_back(c.name);
  }
  std::vector<std::string_view> known(owned.begin(), owned.end());
  return suggest(given, known);
}

// An empty value is a script's mistake: a variable that was never set.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::Option* o : app.get_options())
    for (const std::string& value : o->results())
      if (value.empty())
        throw Error(ExitCode::bad_input, o->get_name(), "has an empty value", "give one or leave it out");
  for (const CLI::App* command : app.get_subcommands()) refuse_empty_values(*command);
}

CommandText text_of(const CLI::App& app) {
  CommandText out{app.get_parent() ? app.get_name() : "", app.get_description(), {}};
  for (const CLI::Option* o : app.get_options()) {
    const bool flag = o->get_items_expected_max() == 0;
    const std::string type = flag ? "" : o->get_option_text().empty() ? o->get_type_name() : o->get_option_text();
    out.options.push_back({o->get_name(o->get_positional(), true), type, o->get_description()});
  }
  return out;
}

}  // namespace

std::vector<CommandText> command_texts() {
  Arguments a;
  CLI::App app(kTitle, "gbufferlab");
  describe(app, a);
  std::vector<CommandText> out{text_of(app)};
  for (const CLI::App* command : app.get_subcommands(nullptr)) out.push_back(text_of(*command));
  return out;
}

std::optional<Arguments> parse_arguments(int argc, const char* const* argv) {
  Arguments a;
  CLI::App app(kTitle, "gbufferlab");
  app.require_subcommand(0, 1);
  describe(app, a);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    app.exit(e);
    return {};
  } catch (const CLI::ParseError& e) {
    const std::string help = unknown_argument(app, e.what());
    throw Error(ExitCode::bad_input, "command line", e.what(), help.empty() ? "see --help" : help);
  }
  refuse_empty_values(app);
  return a;
}

}  // namespace gbl
