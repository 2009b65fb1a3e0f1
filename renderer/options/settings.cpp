#include "renderer/options/settings.h"

#include <algorithm>

#include "renderer/options/options.h"

namespace gbl {

bool same_truth(const Settings& a, const Settings& b) {
  for (const Option& o : options())
    if (o.group == Group::truth && o.get(a) != o.get(b)) return false;
  return true;
}

namespace {

// Where nothing is stored, how it is stored means nothing.
bool of_gbuffer(std::string_view path) {
  for (const std::string_view prefix : {"layout", "normal.", "position.", "accumulation.", "background.skip"})
    if (path.starts_with(prefix)) return true;
  return false;
}

}  // namespace

// Cull, level, fit, clip and depth of a volume mean nothing to a method that draws none. The stencil method draws both
// faces against the depth, whatever is chosen: to it only the mesh's level and fit mean something.
bool in_use(const Option& o, const Settings& s) {
  const std::string_view path = o.path;
  const bool of_mesh = path == "lights.volume.level" || path == "lights.volume.fit";
  if (of_mesh && s.lights.method == LightMethod::volumes_stencil) return true;
  if (path == "lights.cull" || path.starts_with("lights.volume.")) return draws_chosen_faces(s.lights.method);
  if (of_gbuffer(path) && shading_of(s.lights.method) == Shading::forward) return false;
  if (path == "position.reconstruct") return s.position.source == PositionSource::depth;
  if (path == "tangents") return s.normal_map == NormalMap::on;
  if (path == "range.threshold") return s.range.kind == RangeKind::threshold;
  return true;
}

std::vector<std::string> ids_of(const std::set<Mistake>& mistakes) {
  std::vector<std::string> ids;
  for (const Mistake m : mistakes) ids.emplace_back(row(m).id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<Unsound> unsound_choices(const Settings& s) {
  std::vector<Unsound> found;
  for (const Option& o : options()) {
    if (o.group != Group::method || o.kind != Kind::choice || !in_use(o, s)) continue;
    const ValueRow& r = o.values[chosen(o, s)];
    if (!r.sound()) found.push_back({o.path, r.id, id_of(r.pitfall)});
  }
  for (const std::string& id : ids_of(s.mistakes)) found.push_back({"mistakes", id, id});
  return found;
}

}  // namespace gbl
