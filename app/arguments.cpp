// The command line's grammar. CLI11 compiles slowly: it is seen by this file only.
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <iostream>

#include "app/commands.h"

namespace gbl {
namespace {

// What is drawn: for the commands that draw.
void add_settings(CLI::App& app, Arguments& a) {
  app.add_option("--scene", a.scene, "builtin:NAME or a model's file; brings its own camera and lights");
  app.add_option("--preset", a.preset, "whole settings by name (list presets)");
  app.add_option("--state", a.state, "settings from a JSON file or from a PNG that this program wrote");
  app.add_option("--set", a.set, "path=value, repeatable (list options)")->allow_extra_args(false);
  app.add_option("--size", a.size, "WxH in pixels");
  app.add_option("--lights", a.lights, "number of generated lights, 0 to 16384");
  app.add_option("--seed", a.seed, "of the generated lights");
  app.add_option("--camera", a.camera, "x,y,z:yaw,pitch[:fov] in world units and degrees");
  app.add_option("--rig", a.rig, "lights from a rig's JSON file");
  app.add_option("--time", a.time, "seconds: lights move as functions of it");
}

void add_without(CLI::App& app, Arguments& a) {
  app.add_option("--without", a.without, "features to switch off, comma-separated (info lists them)");
}

void add_own_options(CLI::App& app, const std::string& command, Arguments& a) {
  add_without(app, a);
  if (command == "render" || command == "view" || command == "bench" || command == "probe") add_settings(app, a);
  if (command != "view") app.add_flag("--json", a.json, "machine-readable output");
  if (command == "render") {
    app.add_option("-o,--output", a.output, "folder for the pictures, made if need be (default: out)");
    app.add_option("--only", a.only, "views, comma-separated (list views); default: all that are stored");
    app.add_flag("--raw", a.raw, "also NAME.raw.png: the stored codes, undecoded");
    app.add_flag("--sheet", a.sheet, "also sheet.png: all pictures with captions and legends");
  }
  if (command == "probe") {
    const CLI::Range row_or_column(0, 1 << 20);
    app.add_option("x", a.pixel_x, "column of the pixel, from 0 at the left")->required()->check(row_or_column);
    app.add_option("y", a.pixel_y, "row of the pixel, from 0 at the top")->required()->check(row_or_column);
  }
  if (command == "view") {
    app.add_flag("--present", a.present, "large type for a projector");
    app.add_option("--lesson", a.lesson, "open this lesson (list lessons)");
    app.add_flag("--fresh", a.fresh, "start from the preset; nothing is remembered between runs, so this is always so");
    app.add_option("--frames", a.frames, "draw so many frames and leave")->check(CLI::NonNegativeNumber);
  }
  if (command == "advise") {
    add_settings(app, a);
    app.add_option("--budget", a.budget, "codes of 255 as displayed that 99.9 % of the pixels must hold (default: 1)");
    app.add_option("--budget-max", a.budget_max, "the same for every pixel");
    app.add_option("--cost", a.cost, "what is to be small: time, bytes or pairs (default: time)");
    app.add_flag("--apply", a.apply, "write the set-up to settings.json");
    app.add_option("-o,--output", a.output, "folder of settings.json (default: out)");
  }
  if (command == "study") {
    app.add_option("spec", a.what, "a built-in study (list studies) or a spec's JSON file; default: tradeoff");
    app.add_option("-o,--output", a.output, "folder of rows.jsonl and the charts, made if need be (default: out/NAME)");
    app.add_option("--shard", a.shard, "i/n: every n-th case from the i-th, for several machines");
  }
  if (command == "stability") {
    app.add_option("sweep", a.sweeps, "sweeps by id; default: all. An unknown one is answered with the known ones");
    app.add_option("--configurations", a.configurations, "of cull-families, in each family (default: 48)")
        ->check(CLI::Range(1, 1000));
    app.add_option("-o,--output", a.output, "folder for tables and charts, made if need be (default: out/stability)");
  }
  if (command == "list") {
    CLI::Option* what = app.add_option("what", a.what, "what to list; `list` alone names the choices");
    app.add_flag("--md", a.markdown, "as a Markdown table")->needs(what);
    app.add_option("--docs", a.docs, "write the pages of docs/tables to this folder")->excludes(what);
  }
}

// Help of every command in one place: rows of commands().
void describe(CLI::App& app, Arguments& a) {
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

}  // namespace

Arguments parse_arguments(int argc, const char* const* argv) {
  Arguments a;
  CLI::App app("G-Buffer Lab: see every buffer of a deferred renderer, and what each choice costs.", "gbufferlab");
  app.set_version_flag("--version", "gbufferlab " GBL_VERSION);
  app.require_subcommand(0, 1);
  describe(app, a);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& e) {
    std::exit(app.exit(e));
  } catch (const CLI::CallForAllHelp& e) {
    std::exit(app.exit(e));
  } catch (const CLI::CallForVersion& e) {
    std::exit(app.exit(e));
  } catch (const CLI::ParseError& e) {
    const std::string help = unknown_argument(app, e.what());
    throw Error(ExitCode::bad_input, "command line", e.what(), help.empty() ? "see --help" : help);
  }
  return a;
}

}  // namespace gbl
