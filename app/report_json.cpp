#include "app/report_json.h"

#include <fmt/format.h>

#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/row_json.h"

namespace gbl {
Json report_json(const Lab& lab) {
  const FrameReport& r = lab.report();
  Json json;
  json["lights"] = r.light_count;
  json["method"] = row(r.drawn.lights.method).id;
  json["method_reason"] = r.method_reason.empty() ? Json(nullptr) : Json(r.method_reason);
  for (const PassTime& p : r.passes) json["time_ms_" + p.pass] = or_null(p.ms);
  append_cells(json, cells_of(r, lab.machine()));
  const std::vector<Unsound> unsound = unsound_choices(lab.drawn());
  json["sound"] = unsound.empty();
  json["pitfalls"] = Json::array();
  for (const Unsound& u : unsound) json["pitfalls"].push_back(u.pitfall);
  json["choices"] = r.choices;
  json["settings"] = to_json(lab.drawn());
  return json;
}

}  // namespace gbl
