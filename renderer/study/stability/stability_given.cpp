#include "renderer/study/stability/stability_given.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace gbl {
namespace {

using Paths = std::set<std::string, std::less<>>;

void add_differing(Paths& paths, const Settings& a, const Settings& b) {
  for (const Option& o : options())
    if (o.group != Group::view && !(o.get(a) == o.get(b))) paths.insert(o.path);
}

// Its parameter and what its curves change. In the sweep's own scene everything that changes on the way counts.
Paths varied_by(const Sweep& s, bool place) {
  Paths paths(s.keeps.begin(), s.keeps.end());
  const std::vector<double> values = s.values();
  const Settings first = s.at(values.front()).settings;
  if (!place) add_differing(paths, first, s.at(values.back()).settings);
  const std::vector<Curve> curves = s.curves({});
  std::vector<Settings> drawn(curves.size(), first);
  for (size_t i = 0; i < curves.size(); ++i) {
    curves[i].apply(drawn[i]);
    add_differing(paths, drawn[0], drawn[i]);
    add_differing(paths, first, drawn[i]);
  }
  return paths;
}

bool takes_place(const Sweep& s, const SweepGiven& given) { return given.place || (given.state && !s.keeps.empty()); }

std::string sweeps_that_take_a_scene() {
  std::string ids;
  for (const Sweep& s : sweeps())
    if (!s.keeps.empty()) ids += (ids.empty() ? "" : ", ") + std::string(s.id);
  return ids;
}

void take(Settings& into, const Settings& from, const Option& o) { o.set(into, o.get(from), o); }

}  // namespace

bool is_place(std::string_view path) {
  constexpr std::string_view kPlace[] = {"scene",       "lights",     "lights.source", "lights.count",
                                         "lights.seed", "lights.rig", "time_s"};
  return path.starts_with("camera.") || std::find(std::begin(kPlace), std::end(kPlace), path) != std::end(kPlace);
}

std::string refusal(const Sweep& s, const SweepGiven& given) {
  if (given.place && s.keeps.empty())
    return fmt::format("'{}' needs the scene, camera and lights that it makes; these take others: {}", s.id,
                       sweeps_that_take_a_scene());
  const Paths varied = varied_by(s, takes_place(s, given));
  for (const std::string& path : given.paths)
    if (varied.contains(path)) return fmt::format("{} is what '{}' varies or needs", path, s.id);
  return "";
}

std::function<void(SweepSetup&)> given_over(const Sweep& s, const SweepGiven& given) {
  return [varied = varied_by(s, takes_place(s, given)), place = takes_place(s, given), given](SweepSetup& setup) {
    const auto is_given = [&](const Option& o) {
      return std::find(given.paths.begin(), given.paths.end(), o.path) != given.paths.end();
    };
    for (const Option& o : options()) {
      if (o.group == Group::view || varied.contains(o.path)) continue;
      const bool is_size = std::string_view(o.path) == "size";  // a sweep's own is small: it has many points
      const bool from_place = place && o.group == Group::truth && !is_size;
      const bool from_ways = given.ways && o.group == Group::method;
      if (from_place || from_ways || is_given(o)) take(setup.settings, given.settings, o);
    }
    if (place) setup.scene = given.scene;
  };
}

}  // namespace gbl
