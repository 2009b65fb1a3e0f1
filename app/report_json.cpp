#include "app/report_json.h"

#include <fmt/format.h>

namespace gbl {
namespace {

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

Json report_json(const Lab& lab) {
  const FrameReport& r = lab.report();
  const gl::Device& d = lab.device();
  Json json;
  json["size"] = fmt::format("{}x{}", r.size.x, r.size.y);
  json["lights"] = r.light_count;
  json["method"] = row(r.drawn.lights.method).id;
  json["method_reason"] = r.method_reason.empty() ? Json(nullptr) : Json(r.method_reason);
  for (const PassTime& p : r.passes) json["time_ms_" + p.pass] = or_null(p.ms);
  json["time_source"] = r.time_source;
  json["pairs_tested"] = r.pairs ? Json(r.pairs->tested) : Json(nullptr);
  json["pairs_shaded"] = r.pairs ? Json(r.pairs->shaded) : Json(nullptr);
  json["pairs_lit"] = r.pairs ? or_null(r.pairs->lit) : Json(nullptr);
  json["bytes_per_pixel"] = r.gbuffer_bytes_per_pixel;
  json["accumulation_bytes_per_pixel"] = r.accumulation_bytes_per_pixel;
  json["mib"] = r.mib;
  json["draw_calls"] = r.draw_calls;
  json["driver"] = d.version;
  json["device"] = d.renderer;
  const std::vector<Unsound> unsound = unsound_choices(lab.drawn());
  json["sound"] = unsound.empty();
  json["pitfalls"] = Json::array();
  for (const Unsound& u : unsound) json["pitfalls"].push_back(u.pitfall);
  json["choices"] = r.choices;
  json["settings"] = to_json(lab.drawn());
  return json;
}

}  // namespace gbl
