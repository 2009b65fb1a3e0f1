#include "renderer/study/study_paths.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/limits.h"
#include "renderer/base/size_text.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/presets.h"
#include "renderer/study/seeded_camera.h"

namespace gbl {
namespace {

constexpr glm::ivec2 kDefaultSize{640, 360};

[[noreturn]] void bad_value(std::string_view path, const OptionValue& v, std::string_view expected) {
  throw Error(ExitCode::bad_input, path, fmt::format("{} is not {}", written(v), expected));
}

// As the option itself understands it.
OptionValue checked_option(const Option& o, const OptionValue& v) {
  Settings scratch;
  o.set(scratch, v, o);
  return o.get(scratch);
}

void set(Settings& s, std::string_view path, const OptionValue& v) {
  const Option& o = option(path);
  o.set(s, v, o);
}

OptionValue checked_preset(const OptionValue& v) {
  std::vector<std::string_view> known;
  for (const Preset& p : presets()) known.emplace_back(p.id);
  const auto* id = std::get_if<std::string>(&v);
  if (!id) bad_value("preset", v, "the id of a preset");
  if (std::find(known.begin(), known.end(), *id) == known.end())
    throw Error(ExitCode::bad_input, "preset", fmt::format("unknown preset '{}'", *id), suggest(*id, known));
  return v;
}
void apply_preset(Settings& s, const OptionValue& v, SceneCache&) { s = preset(std::get<std::string>(v)).make(); }

OptionValue checked_scene(const OptionValue& v) { return checked_option(option("scene"), v); }
void apply_scene_by_name(Settings& s, const OptionValue& v, SceneCache& scenes) {
  const auto& name = std::get<std::string>(v);
  apply_scene(s, name, scenes.get(name));
}

OptionValue checked_lights(const OptionValue& v) {
  checked_option(option("lights.count"), v);
  return v;
}
void apply_lights(Settings& s, const OptionValue& v, SceneCache&) {
  set(s, "lights.count", v);
  option("lights.count").implies(s);
}

OptionValue checked_seed(const OptionValue& v) {
  const auto* k = std::get_if<Number>(&v);
  if (!k || !k->whole || k->value < 0 || k->value > kMostStudyCameras)
    bad_value("camera.seed", v, fmt::format("a whole number in 0 ... {}", kMostStudyCameras));
  return v;
}
void apply_seed(Settings& s, const OptionValue& v, SceneCache& scenes) {
  const int k = static_cast<int>(std::get<Number>(v).value);
  if (k > 0) s.camera = seeded_camera(scenes.get(s.scene), s.camera, k);
}

// "640x360" or [640, 360] -> [640, 360].
OptionValue size_array(const OptionValue& v) {
  const auto* text = std::get_if<std::string>(&v);
  if (!text) return checked_option(option("size"), v);
  const std::optional<glm::ivec2> size = size_of(*text);
  if (!size) bad_value("size", v, "a size such as \"640x360\"");
  return checked_option(option("size"), OptionList{size->x, size->y});
}
OptionValue checked_size(const OptionValue& v) {
  Settings scratch;
  set(scratch, "size", size_array(v));
  return size_text(scratch.size);
}
void apply_size(Settings& s, const OptionValue& v, SceneCache&) { set(s, "size", size_array(v)); }

// clang-format off
constexpr StudyPath kPaths[] = {
    {"preset", "whole settings by id", checked_preset, apply_preset, [](const Settings&) { return std::optional<OptionValue>(); }},
    {"scene", "with its camera, lights and look; a preset keeps how it draws", checked_scene, apply_scene_by_name, [](const Settings& s) { return std::optional<OptionValue>(s.scene); }},
    {"lights", "how many are generated", checked_lights, apply_lights, [](const Settings& s) { return std::optional<OptionValue>(s.lights.count); }},
    {"camera.seed", "0: as set; k: the k-th seeded camera", checked_seed, apply_seed, [](const Settings&) { return std::optional<OptionValue>(0); }},
    {"size", "\"WIDTHxHEIGHT\" or [WIDTH, HEIGHT]", checked_size, apply_size, [](const Settings& s) { return std::optional<OptionValue>(size_text(s.size)); }},
};
// clang-format on

const StudyPath* special(std::string_view path) {
  for (const StudyPath& p : kPaths)
    if (p.path == path) return &p;
  return nullptr;
}

// An option that a study may set; Error with the nearest paths.
const Option& study_option(std::string_view path) {
  std::vector<std::string_view> known;
  for (const StudyPath& p : kPaths) known.emplace_back(p.path);
  for (const Option& o : options()) {
    if (o.group != Group::view && o.path == path) return o;
    if (o.group != Group::view && !special(o.path)) known.emplace_back(o.path);
  }
  if (path.starts_with("view."))
    throw Error(ExitCode::bad_input, path, "a study measures what is drawn, whatever is looked at", "leave it out");
  throw Error(ExitCode::bad_input, path, "unknown path", suggest(path, known));
}

const OptionValue* find(const std::vector<Coordinate>& list, std::string_view path) {
  for (const Coordinate& c : list)
    if (c.path == path) return &c.value;
  return nullptr;
}

}  // namespace

const Scene& SceneCache::get(const std::string& name) {
  std::shared_ptr<const Scene>& scene = scenes_[name];
  if (!scene) scene = open_(name);
  return *scene;
}

std::span<const StudyPath> study_paths() { return kPaths; }

void check_path(std::string_view path) {
  if (!special(path)) study_option(path);
}

OptionValue checked_value(std::string_view path, const OptionValue& value) {
  if (const StudyPath* p = special(path)) return p->checked(value);
  return checked_option(study_option(path), value);
}

Settings settings_of(const std::vector<Coordinate>& checked, SceneCache& scenes) {
  Settings s;
  if (!find(checked, "preset") && !find(checked, "scene")) apply_scene(s, s.scene, scenes.get(s.scene));
  for (const StudyPath& p : kPaths) {
    if (std::string_view(p.path) == "size") s.size = kDefaultSize;  // a preset's own would compare other pictures
    if (const OptionValue* value = find(checked, p.path)) p.apply(s, *value, scenes);
  }
  if (!find(checked, "preset")) apply_drawing(s, s.scene);
  for (const Coordinate& c : checked)
    if (!special(c.path)) set(s, c.path, c.value);
  s.view = {};
  return s;
}

std::optional<OptionValue> value_at(std::string_view path, const std::vector<Coordinate>& list, const Settings& s) {
  if (const StudyPath* p = special(path)) {
    const OptionValue* value = find(list, path);
    return value ? *value : p->of(s);
  }
  return study_option(path).get(s);
}

std::string text_of(const Coordinate& c) {
  const auto* n = std::get_if<Number>(&c.value);
  const auto* id = std::get_if<std::string>(&c.value);
  // Options that are numbers keep doubles: 100 is not to be printed as 100.0.
  const bool whole = n && n->value == std::floor(n->value) && std::abs(n->value) < 1e15;
  const std::string text = id ? *id : whole ? fmt::format("{}", std::llround(n->value)) : written(c.value);
  return fmt::format("{}={}", c.path, text);
}

}  // namespace gbl
