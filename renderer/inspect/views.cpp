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

Legend legend(View v, const Settings& s, const Bounds& bounds) {
  return row(v).legend && why_missing(v, s).empty() ? row(v).legend(s, bounds) : Legend{};
}

std::string shader_of(View v) {
  const ViewRow& r = row(v);
  return r.fragment ? r.fragment : fmt::format("views/{}.glsl", r.id);
}

}  // namespace gbl
