#include "renderer/options/settings.h"

#include <algorithm>

#include "renderer/gbuffer/layout_file.h"
#include "renderer/options/options.h"

namespace gbl {

bool same_truth(const Settings& a, const Settings& b) {
  for (const Option& o : options())
    if (o.group == Group::truth && o.get(a) != o.get(b)) return false;
  return true;
}

Settings lit_alone(Settings s) {
  s.shadows = Shadows::off;
  s.reflections = Reflections::off;
  s.height_map = HeightMap::off;
  return s;
}

const LayoutRow& layout_of(const Settings& s) {
  return s.layout_file.empty() ? facts(s.layout) : layout_of_file(s.layout_file);
}

std::string layout_shader_of(const Settings& s) {
  return s.layout_file.empty() ? shader_of(s.layout) : shader_of_layout_file(s.layout_file);
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

Settings cured(const Settings& s) {
  Settings out = s;
  const Settings defaults;
  for (const Unsound& u : unsound_choices(s)) {
    const Option& o = option(u.path);
    o.set(out, o.get(defaults), o);
  }
  return out;
}

}  // namespace gbl
