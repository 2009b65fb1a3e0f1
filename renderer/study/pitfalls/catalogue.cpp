#include "renderer/study/pitfalls/catalogue.h"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

#include "renderer/base/json.h"
#include "renderer/base/resources.h"
#include "renderer/inspect/views.h"
#include "renderer/options/data_file.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/pitfalls/pitfall_metrics.h"

namespace gbl {
namespace {

constexpr int kVersion = 1;
constexpr std::string_view kFolder = "assets/pitfalls/";

constexpr PitfallGroup kGroups[] = {
    {"normals", "Normals"},
    {"position", "Position and depth"},
    {"volumes", "Light volumes and ranges"},
    {"accumulation", "Sums and colour"},
    {"shading", "Shading"},
    {"shadows", "Shadows"},
    {"mirrors", "Mirrors and glass"},
    {"heights", "Height maps"},
    {"passes", "Passes"},
};

size_t group_index(std::string_view id) {
  const auto found = std::find_if(std::begin(kGroups), std::end(kGroups), [&](const auto& g) { return id == g.id; });
  return static_cast<size_t>(found - std::begin(kGroups));
}

std::string known_group(const Json& json, std::string_view where) {
  std::string id = needed_text_member(json, "group", where);
  std::vector<std::string_view> known;
  for (const PitfallGroup& g : kGroups) known.emplace_back(g.id);
  if (group_index(id) == known.size())
    throw Error(ExitCode::bad_input, where, fmt::format("unknown group '{}'", id), suggest(id, known));
  return id;
}

double number_member(const Json& node, const char* member, std::string_view where) {
  if (!node.contains(member) || !node[member].is_number())
    throw Error(ExitCode::bad_input, where, fmt::format("\"{}\" must be a number", member));
  return node[member].get<double>();
}

PitfallBounds bounds_of(const Json& node, std::string_view where) {
  const PitfallBounds b{number_member(node, "broken_at_least", where), number_member(node, "fixed_at_most", where)};
  if (!(b.broken_at_least > b.fixed_at_most))
    throw Error(ExitCode::bad_input, where, "\"broken_at_least\" must be more than \"fixed_at_most\"");
  return b;
}

std::vector<Assignment> patch_member(const Json& node, const char* member, std::string_view where) {
  return node.contains(member) ? read_patch(node[member], where) : std::vector<Assignment>{};
}

std::string file_name(std::string_view id) { return data_file_name(kFolder, id); }

}  // namespace

std::vector<PitfallGroup> pitfall_groups() { return {std::begin(kGroups), std::end(kGroups)}; }

PitfallEntry parse_pitfall(std::string_view id, std::string_view json_text) {
  const std::string where = file_name(id);
  const Json json = parse_json(json_text, where);
  if (!json.is_object()) throw Error(ExitCode::bad_input, where, "must be a JSON object");
  check_file_version(json, kVersion, "pitfall", where);
  only_members(json, {"version",         "group",         "order",       "lecture", "title",  "source", "symptom",
                      "cause",           "question",      "do",          "dont",    "impact", "see",    "still",
                      "preset",          "view",          "metric",      "set",     "broken", "fixed",  "truth",
                      "broken_at_least", "fixed_at_most", "toward_zero", "blind",   "path"},
               where);
  PitfallEntry e;
  e.id = id;
  e.group = known_group(json, where);
  e.order = order_member(json, "order", 0, where), e.lecture = order_member(json, "lecture", 0, where);
  const auto text = [&](const char* member) { return needed_text_member(json, member, where); };
  e.title = text("title"), e.source = text("source"), e.symptom = text("symptom"), e.cause = text("cause");
  e.question = text("question"), e.do_this = text("do"), e.do_not = text("dont"), e.impact = text("impact");
  e.see = text("see"), e.still = text("still");
  e.preset = text("preset"), e.view = text("view"), e.metric = text("metric");
  look_up(where, [&] { view_by_id(e.view), pitfall_metric(e.metric); });
  e.set = patch_member(json, "set", where), e.truth = patch_member(json, "truth", where);
  e.broken = patch_member(json, "broken", where), e.fixed = patch_member(json, "fixed", where);
  e.bounds = bounds_of(json, where);
  if (json.contains("toward_zero")) {
    only_members(json["toward_zero"], {"broken_at_least", "fixed_at_most"}, where + ": toward_zero");
    e.toward_zero = bounds_of(json["toward_zero"], where + ": toward_zero");
  }
  if (json.contains("blind")) {
    const Json& blind = json["blind"];
    const std::string here = where + ": blind";
    only_members(blind, {"set", "at_most", "why"}, here);
    e.blind = {patch_member(blind, "set", here), number_member(blind, "at_most", here),
               needed_text_member(blind, "why", here)};
  }
  if (json.contains("path")) {
    const std::string here = where + ": path";
    only_members(json["path"], {"from", "to"}, here);
    e.path = {patch_member(json["path"], "from", here), patch_member(json["path"], "to", here)};
  }
  look_up(where, [&] {  // tried now, not when a lecturer opens it
    for (const PitfallSide side : {PitfallSide::broken, PitfallSide::fixed}) truth_of(e, side);
    if (e.blind) truth_of(e, PitfallSide::blind);
    if (e.path) camera_on_path(e, 0), camera_on_path(e, 1);
  });
  return e;
}

std::vector<PitfallEntry> load_pitfalls() {
  std::vector<PitfallEntry> all;
  for (const std::string& id : data_file_ids(kFolder)) all.push_back(parse_pitfall(id, resource(file_name(id))));
  std::stable_sort(all.begin(), all.end(), [](const PitfallEntry& a, const PitfallEntry& b) {
    return std::pair(group_index(a.group), a.order) < std::pair(group_index(b.group), b.order);
  });
  return all;
}

PitfallEntry load_pitfall(std::string_view id) {
  const std::vector<std::string> ids = data_file_ids(kFolder);
  if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
    for (const AbsentPitfall& a : absent_pitfalls())
      if (id == a.id) throw Error(ExitCode::bad_input, id, fmt::format("is not in the catalogue: {}", a.why));
    const std::vector<std::string_view> known(ids.begin(), ids.end());
    throw Error(ExitCode::bad_input, "pitfalls", fmt::format("unknown pitfall '{}'", id), suggest(id, known));
  }
  return parse_pitfall(id, resource(file_name(id)));
}

Settings settings_of(const PitfallEntry& e, PitfallSide side) {
  const std::string where = file_name(e.id);
  Settings s = preset(e.preset).make();
  apply_patch(s, e.set, where);
  apply_patch(s, side == PitfallSide::fixed ? e.fixed : e.broken, where);
  if (side == PitfallSide::blind) {
    assert(e.blind);
    apply_patch(s, e.blind->set, where);
  }
  s.view.main = e.view;
  return s;
}

Camera camera_on_path(const PitfallEntry& e, double t) {
  assert(e.path);
  Settings from = settings_of(e, PitfallSide::broken), to = from;
  apply_patch(from, e.path->from, file_name(e.id)), apply_patch(to, e.path->to, file_name(e.id));
  Camera c = from.camera;
  c.position = glm::mix(from.camera.position, to.camera.position, t);
  c.orientation = glm::slerp(from.camera.orientation, to.camera.orientation, t);
  return c;
}

Settings truth_of(const PitfallEntry& e, PitfallSide side) {
  Settings s = settings_of(e, side);
  if (side != PitfallSide::fixed) apply_patch(s, e.truth, file_name(e.id));
  return s;
}

}  // namespace gbl
