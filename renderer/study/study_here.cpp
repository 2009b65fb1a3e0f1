#include "renderer/study/study_here.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/size_text.h"

namespace gbl {
namespace {

const Option* option_or_null(std::string_view path) {
  for (const Option& o : options())
    if (o.path == path) return &o;
  return nullptr;
}

bool is_of(Group group, std::string_view path) {
  const Option* o = option_or_null(path);
  return o && o->group == group;
}

bool contains(const std::vector<std::string>& list, std::string_view path) {
  return std::find(list.begin(), list.end(), path) != list.end();
}

// What a product's axis varies of the truth: a preset brings its truth, but what is true here goes over it.
std::vector<std::string> truth_at(const std::string& path) {
  if (path == "lights") return {"lights.count", "lights.source"};
  if (is_of(Group::truth, path)) return {path};
  return {};
}

template <class Each>
void for_each_axis(const StudySpec& spec, Each each) {
  for (const std::vector<PathValues>& product : spec.permute)
    for (const PathValues& axis : product) each(axis.path);
}

}  // namespace

std::vector<std::string> varied_truth(const StudySpec& spec) {
  std::vector<std::string> paths;
  for_each_axis(spec, [&](const std::string& axis) {
    for (std::string& path : truth_at(axis))
      if (!contains(paths, path)) paths.push_back(std::move(path));
  });
  return paths;
}

bool can_run_here(const StudySpec& spec) {
  bool can = std::any_of(spec.base.begin(), spec.base.end(), [](const Coordinate& c) { return c.path == "scene"; });
  for_each_axis(spec, [&](std::string_view axis) { can &= !axis.starts_with("camera.") && axis != "scene"; });
  return can;
}

StudySpec study_here(const StudySpec& spec, const Settings& now, glm::ivec2 size) {
  StudySpec here = spec;
  here.base.clear();
  for (const Coordinate& c : spec.base)
    if (c.path == "preset" || is_of(Group::method, c.path)) here.base.push_back(c);
  const std::vector<std::string> varied = varied_truth(spec);
  for (const Option& o : options()) {
    if (o.group != Group::truth || contains(varied, o.path)) continue;
    const bool is_size = std::string_view(o.path) == "size";
    const OptionValue value = is_size ? OptionValue(size_text(size)) : o.get(now);
    here.base.push_back({o.path, checked_value(o.path, value)});
  }
  return here;
}

std::string differing_truth(const Settings& a, const Settings& b, const std::vector<std::string>& varied) {
  for (const Option& o : options()) {
    const bool counts = o.group == Group::truth && std::string_view(o.path) != "size" && !contains(varied, o.path);
    if (counts && o.get(a) != o.get(b)) return o.path;
  }
  return "";
}

}  // namespace gbl
