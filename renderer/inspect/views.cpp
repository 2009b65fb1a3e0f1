#include "renderer/inspect/views.h"

#include <fmt/format.h>

#include "renderer/inspect/view_buffers.h"
#include "renderer/rows/value_table.h"

namespace gbl {
namespace {

#define VIEW(name, ...) {.view = View::name, __VA_ARGS__},
constexpr ViewRow kViews[] = {
#include "renderer/inspect/views.inc"
};
#undef VIEW
constexpr auto kValues =
    values_of<kViews>([](const ViewRow& r) { return ValueRow{.id = r.id, .label = r.label, .help = r.sentence}; });

}  // namespace

std::span<const ViewRow> views() { return kViews; }

const ViewRow& row(View v) { return kViews[static_cast<size_t>(v)]; }

GBL_ROWS(View, kValues)

const ViewRow& view_by_id(std::string_view id) {
  return kViews[static_cast<size_t>(parse_id(kValues, id, "view", "view"))];
}

bool needs_truth(View v) { return row(v).needs_truth; }

bool counted(View v) { return row(v).counted; }

std::string why_missing(View v, const Settings& s) { return row(v).why_missing ? row(v).why_missing(s) : ""; }

std::optional<Attachment> attachment_of(View v, const Settings& s) { return row(v).stored_as(s).attachment; }

std::string stored_as(View v, const Settings& s) {
  const auto [a, elsewhere] = row(v).stored_as(s);
  return a ? fmt::format("{} {} {} B", a->name, row(a->format).label, row(a->format).bytes) : elsewhere;
}

bool single_number(View v, const ViewLook& look) {
  return row(v).values.components == 1 || look.channels.size() == 1 || look.map != ColourMap::own;
}

bool follows_picture(View v, const Settings::View& view) {
  const ViewRow& r = row(v);
  return r.legend == count_legend || r.values.fitted || look_of(view.looks, r.id).fit;
}

glm::dvec2 shown_range(View v, const Settings& s, const Bounds& bounds, const ViewStats* stats) {
  const ViewRow& r = row(v);
  const ViewLook look = look_of(s.view.looks, r.id);
  if (look.range) return *look.range;
  if (stats && stats->pixels > 0 && (look.fit || r.values.fitted))
    return fitted_range(*stats, r.values.components, look.channels);
  return v == View::depth ? depth_view_range(s.camera, bounds) : glm::dvec2(r.values.black, r.values.white);
}

Legend legend(View v, const Settings& s, const Bounds& bounds, const ViewStats* stats) {
  if (!why_missing(v, s).empty()) return {};
  const ViewLook look = look_of(s.view.looks, row(v).id);
  const LegendOf of{s, bounds, shown_range(v, s, bounds, stats), stats};
  if (look.raw) return {};  // codes are on no scale
  if (!look.plain()) return look_legend(of, look, single_number(v, look));
  if (!row(v).classes.empty()) return class_legend(row(v).classes);
  return row(v).legend ? row(v).legend(of) : Legend{};
}

std::string shader_of(View v) {
  const ViewRow& r = row(v);
  return r.fragment ? r.fragment : fmt::format("views/{}.glsl", r.id);
}

}  // namespace gbl
