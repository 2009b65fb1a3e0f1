#include "renderer/scenes/rig.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <mutex>

#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

constexpr int kRigVersion = 1;

// One light's members, read by name; what is not asked for is unknown.
class Members {
 public:
  Members(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
    if (!json.is_object()) bad("", "is not an object");
  }
  [[noreturn]] void bad(std::string_view member, std::string_view what) const {
    throw Error(ExitCode::bad_input, fmt::format("{}{}{}", where_, member.empty() ? "" : ": ", member), what);
  }
  bool has(const char* name) const { return json_.contains(name); }
  double number(const char* name, double low, double high) const {
    if (!has(name)) bad(name, "is missing");
    const Json& v = json_[name];
    if (!v.is_number() || !(v.get<double>() >= low && v.get<double>() <= high))
      bad(name, fmt::format("is not a number in {:g} ... {:g}", low, high));
    return v.get<double>();
  }
  glm::dvec3 vector(const char* name, double low, double high) const {
    if (!has(name)) bad(name, "is missing");
    const Json& v = json_[name];
    if (!v.is_array() || v.size() != 3) bad(name, "is not an array of 3 numbers");
    glm::dvec3 out;
    for (int k = 0; k < 3; ++k) {
      if (!v[k].is_number() || !(v[k].get<double>() >= low && v[k].get<double>() <= high))
        bad(name, fmt::format("holds something that is not a number in {:g} ... {:g}", low, high));
      out[k] = v[k].get<double>();
    }
    return out;
  }
  void only(std::initializer_list<std::string_view> known) const {
    for (const auto& [key, value] : json_.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        bad(key, fmt::format("is unknown; {}", suggest(key, std::vector<std::string_view>(known))));
  }

 private:
  const Json& json_;
  std::string where_;
};

LightKind kind_of(const Json& json, const Members& m) {
  const std::string kind = json.value("kind", Json("point")).is_string() ? json.value("kind", "point") : "";
  if (kind == "point") return LightKind::point;
  if (kind == "spot") return LightKind::spot;
  if (kind == "directional") return LightKind::directional;
  m.bad("kind", "is not point, spot or directional");
}

Light light_of(const Json& json, std::string where) {
  constexpr double kFar = 1e9;
  const Members m(json, std::move(where));
  m.only(
      {"kind", "position", "direction", "colour", "candela", "lux", "range", "inner_deg", "outer_deg", "attenuation"});
  Light l;
  l.kind = kind_of(json, m);
  if (l.kind != LightKind::directional) l.position = m.vector("position", -kFar, kFar);
  if (l.kind != LightKind::point) {
    const glm::dvec3 direction = m.vector("direction", -kFar, kFar);
    if (!(glm::length(direction) > 0)) m.bad("direction", "has no length");
    l.direction = glm::normalize(direction);
  }
  const char* unit = l.kind == LightKind::directional ? "lux" : "candela";
  l.colour = (m.has("colour") ? m.vector("colour", 0, kFar) : glm::dvec3(1)) * m.number(unit, 0, kFar);
  if (l.kind == LightKind::spot) {
    const double outer = m.number("outer_deg", 0, 90);
    const double inner = m.has("inner_deg") ? m.number("inner_deg", 0, outer) : 0;
    l.inner_cos = std::cos(glm::radians(inner)), l.outer_cos = std::cos(glm::radians(outer));
  }
  if (m.has("attenuation")) l.coefficients = m.vector("attenuation", 0, kFar);
  if (l.kind == LightKind::directional) return l;
  l.ends_faint = !m.has("range");
  if (!l.ends_faint) l.range = m.number("range", 0, kFar);
  return l;
}

}  // namespace

std::vector<Light> parse_rig(std::string_view text, std::string_view where) {
  const Json json = parse_json(text, where);
  const Members m(json, std::string(where));
  m.only({"version", "lights"});
  const double version = m.number("version", 1, 1e9);
  if (version > kRigVersion)
    m.bad("version",
          fmt::format("{:g} is newer than this program reads ({}); update the program", version, kRigVersion));
  if (!m.has("lights") || !json["lights"].is_array()) m.bad("lights", "is not an array");
  if (json["lights"].size() > static_cast<size_t>(kMaxLights))
    m.bad("lights", fmt::format("holds more than {} lights", kMaxLights));
  std::vector<Light> lights;
  for (const Json& one : json["lights"])
    lights.push_back(light_of(one, fmt::format("{}: light {}", where, lights.size())));
  return lights;
}

long long rig_stamp(const std::string& file) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  return error ? 0 : static_cast<long long>(time.time_since_epoch().count());
}

std::vector<Light> rig_lights(const std::string& file) {
  struct Read {
    std::filesystem::file_time_type time;
    std::vector<Light> lights;
  };
  static std::map<std::string, Read> g_read;
  static std::mutex g_mutex;
  const std::lock_guard lock(g_mutex);
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  const auto found = g_read.find(file);
  if (!error && found != g_read.end() && found->second.time == time) return found->second.lights;
  const std::string text = read_json(file).dump();
  return (g_read[file] = {time, parse_rig(text, file)}).lights;
}

}  // namespace gbl
