#include "renderer/figures/figure_spec.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <set>

#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/limits.h"
#include "renderer/base/resources.h"
#include "renderer/figures/drawings.h"
#include "renderer/figures/figure_json.h"
#include "renderer/inspect/views.h"
#include "renderer/options/camera_text.h"
#include "renderer/options/data_file.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/image.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;
constexpr int kFigureVersion = 1;
constexpr std::string_view kFolder = "assets/figures/";

std::vector<Assignment> patch_member(const Json& node, std::string_view where) {
  if (!node.contains("set")) return {};
  std::vector<Assignment> patch = read_patch(node["set"], where);
  for (const Assignment& a : patch) look_up(where, [&] { option(a.path); });
  return patch;
}

// What the panel does not say comes from its figure.
FigureRecipe recipe_member(const Json& node, const FigureRecipe& otherwise, std::string_view where) {
  FigureRecipe r = otherwise;
  if (const std::string p = text_member(node, "preset", where); !p.empty()) r.preset = p;
  if (const std::string s = text_member(node, "scene", where); !s.empty()) r.scene = s, r.camera.clear();
  if (const std::string c = text_member(node, "camera", where); !c.empty()) r.camera = c;
  for (Assignment& a : patch_member(node, where)) r.set.push_back(std::move(a));
  Settings tried;
  look_up(where, [&] { tried = preset(r.preset.empty() ? "start" : r.preset).make(); });
  if (!r.camera.empty()) apply_camera(tried, r.camera, where);
  apply_patch(tried, r.set, where);
  return r;
}

FigureInset inset_member(const Json& node, std::string_view where) {
  only_members(node, {"scale", "centre", "corner"}, where);
  FigureInset inset;
  inset.scale = number_member(node, "scale", inset.scale, 1, 1000, where);
  inset.centre = place_member(node, "centre", inset.centre, where);
  const std::string corner = text_member(node, "corner", where);
  if (corner.empty()) return inset;
  const auto has = [&](std::string_view word) { return corner.find(word) != std::string::npos; };
  if (has("top") == has("bottom") || has("left") == has("right"))
    throw Error(ExitCode::bad_input, where, fmt::format("\"corner\" is '{}'", corner),
                "write top left, top right, bottom left or bottom right");
  inset.top = has("top"), inset.right = has("right");
  return inset;
}

FigureAgainst against_member(const Json& node, std::string_view where) {
  only_members(node, {"set", "from", "left", "right"}, where);
  FigureAgainst against;
  against.set = patch_member(node, where);
  if (against.set.empty())
    throw Error(ExitCode::bad_input, where, "\"set\" is missing or empty: both sides would be the same");
  against.from = number_member(node, "from", against.from, 0, 1, where);
  against.left = text_member(node, "left", where), against.right = text_member(node, "right", where);
  return against;
}

FigurePanel parse_panel(const Json& node, const FigureRecipe& of_figure, const std::string& where) {
  only_members(node, {"view", "words", "preset", "scene", "camera", "set", "numbers", "inset", "against", "outside"},
               where);
  FigurePanel p;
  p.view = needed_text_member(node, "view", where);
  look_up(where, [&] { view_by_id(p.view); });
  p.words = text_member(node, "words", where);
  p.recipe = recipe_member(node, of_figure, where);
  p.numbers = flag_member(node, "numbers", false, where);
  if (node.contains("inset")) p.inset = inset_member(node["inset"], where + ": inset");
  if (node.contains("against")) {
    p.against = against_member(node["against"], where + ": against");
    FigureRecipe both = p.recipe;
    both.set.insert(both.set.end(), p.against->set.begin(), p.against->set.end());
    recipe_member(Json::object(), both, where + ": against");
  }
  p.outside = text_member(node, "outside", where);
  if (Settings tried; !p.outside.empty()) apply_camera(tried, p.outside, where + ": outside");
  const int of_one = int(p.numbers) + int(p.inset.has_value());
  if (int(p.against.has_value()) + int(!p.outside.empty()) + int(of_one > 0) > 1)
    throw Error(ExitCode::bad_input, where,
                "\"numbers\" and \"inset\", \"against\" and \"outside\" are for one picture only",
                "make a panel of each");
  return p;
}

// A patch, in which a camera may be given in one line.
std::vector<Assignment> key_of(Json key, const std::string& where) {
  std::vector<Assignment> patch;
  if (key.is_object() && key.contains("camera") && key["camera"].is_string()) {
    Settings s;
    apply_camera(s, key["camera"].get<std::string>(), where);
    for (const char* path : {"camera.position", "camera.orientation", "camera.fov"})
      patch.push_back({path, option(path).get(s)});
    key.erase("camera");
  }
  for (Assignment& a : patch_member(Json{{"set", key}}, where)) patch.push_back(std::move(a));
  Settings tried;
  apply_patch(tried, patch, where);
  return patch;
}

// Every view that has a key and is stored under these settings.
Json stored_panels(const FigureRecipe& r) {
  Settings s = preset(r.preset.empty() ? "start" : r.preset).make();
  apply_patch(s, r.set, "panels");
  Json panels = Json::array();
  for (const ViewRow& v : views())
    if (*v.key && why_missing(v.view, s).empty()) panels.push_back({{"view", v.id}});
  return panels;
}

std::vector<FigurePanel> panels_member(const Json& given, const FigureRecipe& of_figure, const std::string& where) {
  const Json panels = given == "stored" ? stored_panels(of_figure) : given;
  if (!panels.is_array() || panels.empty())
    throw Error(ExitCode::bad_input, where, "\"panels\" must be an array of at least one panel, or \"stored\"");
  std::vector<FigurePanel> out;
  for (const Json& panel : panels)
    out.push_back(parse_panel(panel, of_figure, fmt::format("{}: panel {}", where, out.size() + 1)));
  return out;
}

FigureFrames frames_member(const Json& node, const std::string& where) {
  only_members(node, {"count", "per-second", "keys"}, where);
  FigureFrames f;
  f.count = whole_member(node, "count", f.count, 2, kMostFigureFrames, where);
  f.per_second = number_member(node, "per-second", f.per_second, 0.1, 100, where);
  if (!node.contains("keys") || !node["keys"].is_array() || node["keys"].size() < 2)
    throw Error(ExitCode::bad_input, where, "\"keys\" must be an array of at least two patches");
  for (const Json& key : node["keys"])
    f.keys.push_back(key_of(key, fmt::format("{}: key {}", where, f.keys.size() + 1)));
  const auto same_path = [](const Assignment& a, const Assignment& b) { return a.path == b.path; };
  for (const auto& key : f.keys)
    if (!std::equal(key.begin(), key.end(), f.keys[0].begin(), f.keys[0].end(), same_path))
      throw Error(ExitCode::bad_input, where, "every key must set the same paths, in the same order");
  return f;
}

void check_id(const std::string& id, std::string_view where) {
  const bool plain = id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") == std::string::npos;
  if (!plain)
    throw Error(ExitCode::bad_input, where, fmt::format("id '{}' names files", id), "write a-z, 0-9, - and _ only");
}

glm::ivec2 size_member(const Json& node, const char* member, glm::ivec2 otherwise, std::string_view where) {
  if (!node.contains(member)) return otherwise;
  const Json& value = node[member];
  const auto side = [](const Json& n) {
    return n.is_number_integer() && n.get<long long>() >= 1 && n.get<long long>() <= kMostFigureSide;
  };
  if (!value.is_array() || value.size() != 2 || !side(value[0]) || !side(value[1]))
    throw Error(ExitCode::bad_input, where,
                fmt::format("\"{}\" is {}, not two whole numbers from 1 to {}", member, value.dump(), kMostFigureSide));
  return {value[0].get<int>(), value[1].get<int>()};
}

FigureSet one_figure(const Json& json, const std::string& name, const std::string& where) {
  FigureSet set{where, name, "", {parse_figure(json, where)}};
  set.title = set.figures[0].title;
  return set;
}

}  // namespace

FigureSpec parse_figure(const Json& node, std::string_view file) {
  only_members(node,
               {"id", "title", "caption", "alt", "source", "size", "columns", "letters", "heading", "preset", "scene",
                "camera", "set", "panels", "drawing", "window", "frames"},
               file);
  FigureSpec f;
  f.id = needed_text_member(node, "id", file);
  check_id(f.id, file);
  const std::string where = fmt::format("{}: {}", file, f.id);
  f.title = needed_text_member(node, "title", where), f.caption = needed_text_member(node, "caption", where);
  f.alt = text_member(node, "alt", where), f.source = text_member(node, "source", where);
  f.size = size_member(node, "size", f.size, where);
  f.columns = whole_member(node, "columns", f.columns, 1, 12, where);
  f.letters = flag_member(node, "letters", f.letters, where),
  f.heading = flag_member(node, "heading", f.heading, where);
  f.recipe = recipe_member(node, {}, where);
  f.drawing = text_member(node, "drawing", where);
  if (node.contains("window")) f.window = size_member(node, "window", {}, where);
  if (int(node.contains("panels")) + !f.drawing.empty() + f.window.has_value() != 1)
    throw Error(ExitCode::bad_input, where, "a figure has either \"panels\", a \"drawing\" or a \"window\"");
  if (!f.drawing.empty()) look_up(where, [&] { figure_drawing(f.drawing); });
  if (node.contains("panels")) f.panels = panels_member(node["panels"], f.recipe, where);
  if (node.contains("frames")) f.frames = frames_member(node["frames"], where + ": frames");
  if (f.frames && f.panels.empty()) throw Error(ExitCode::bad_input, where, "only panels have \"frames\"");
  f.json = node.dump(2);
  return f;
}

FigureSet parse_figures(std::string_view text, std::string_view name, std::string_view file) {
  const std::string where(file);
  const Json json = parse_json(text, where);
  if (!json.is_object()) throw Error(ExitCode::bad_input, where, "must be a JSON object");
  if (json.contains("id")) return one_figure(json, std::string(name), where);
  check_file_version(json, kFigureVersion, "set of figures", where);
  only_members(json, {"version", "title", "figures"}, where);
  FigureSet set{where, std::string(name), needed_text_member(json, "title", where), {}};
  if (!json.contains("figures") || !json["figures"].is_array() || json["figures"].empty())
    throw Error(ExitCode::bad_input, where, "\"figures\" must be an array of at least one figure");
  std::set<std::string> ids;
  for (const Json& node : json["figures"]) {
    set.figures.push_back(parse_figure(node, where));
    if (!ids.insert(set.figures.back().id).second)
      throw Error(ExitCode::bad_input, where, fmt::format("two figures are called '{}'", set.figures.back().id));
  }
  return set;
}

FigureSet load_figures(const std::string& name, const std::vector<std::string>& known) {
  const std::vector<std::string> ids = data_file_ids(kFolder);
  if (std::find(ids.begin(), ids.end(), name) != ids.end())
    return parse_figures(resource(data_file_name(kFolder, name)), name, data_file_name(kFolder, name));
  if (!fs::exists(name)) {
    const std::vector<std::string_view> names(known.begin(), known.end());
    throw Error(ExitCode::bad_input, "figures", fmt::format("'{}' is neither a set of figures nor a file", name),
                suggest(name, names));
  }
  if (fs::path(name).extension() != ".png") return parse_figures(read_text_file(name), name, name);
  const std::string text = read_png_text(name, kFigureKey);
  if (text.empty())
    throw Error(ExitCode::bad_input, name, "was not made as a figure",
                "render --state takes the settings of any picture of this program");
  return parse_figures(text, name, name);
}

std::vector<BuiltinFigures> builtin_figures() {
  std::vector<BuiltinFigures> out;
  for (const std::string& id : data_file_ids(kFolder)) {
    const Json json = parse_json(resource(data_file_name(kFolder, id)), data_file_name(kFolder, id));
    out.push_back({id, needed_text_member(json, "title", data_file_name(kFolder, id))});
  }
  return out;
}

}  // namespace gbl
