#include "ui/panels/chart_view.h"

#include <algorithm>

namespace gbl::ui {
namespace {

constexpr FamilyPath kFamilies[] = {
    {"lights.method", "method"},
    {"layout", "layout"},
    {"normal.encoding", "normal encoding"},
    {"position.source", "position"},
    {"accumulation.format", "light sum"},
};

// axis_for() gives a quality a linear axis and everything else a logarithmic one: the chooser's wish goes over that.
ChartAxis axis_as(StudyColumn column, const std::vector<double>& values, std::optional<bool> logarithmic) {
  if (logarithmic) column.more_is_better = !*logarithmic;
  return axis_for(column, values);
}

ChartAxis looked_at(const ChartAxis& whole, const std::optional<Span>& zoom) {
  PlotAxis axis{whole};
  if (zoom) axis.look_at(*zoom);
  return axis.scale;
}

std::vector<ChartFamily> families_of(const Chart& chart, std::string_view path) {
  const Option& o = option(path);
  std::vector<ChartFamily> families;
  size_t others = o.values.size();
  for (const std::string& name : chart.families) {
    const auto row = std::find_if(o.values.begin(), o.values.end(), [&](const ValueRow& r) { return name == r.id; });
    families.push_back({name, row == o.values.end() ? others++ : static_cast<size_t>(row - o.values.begin())});
  }
  std::sort(families.begin(), families.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  return families;
}

std::vector<size_t> front_of(const ChartView& v) {
  std::vector<CostError> places;
  std::vector<size_t> judged, front;
  for (const size_t i : v.shown) {
    if (v.point(i).noisy) continue;
    judged.push_back(i);
    places.push_back({v.point(i).cost, v.chart.y.more_is_better ? -v.point(i).error : v.point(i).error});
  }
  const std::vector<bool> on_front = pareto_front(places);
  for (size_t k = 0; k < judged.size(); ++k)
    if (on_front[k]) front.push_back(judged[k]);
  std::sort(front.begin(), front.end(), [&](size_t a, size_t b) { return v.point(a).cost < v.point(b).cost; });
  return front;
}

void scale_axes(ChartView& v, const ChartState& s) {
  std::vector<double> costs, errors;
  const auto add = [&](size_t i) { costs.push_back(v.point(i).cost), errors.push_back(v.point(i).error); };
  for (const size_t i : v.shown) add(i);
  if (v.current) add(*v.current);  // is always in sight
  v.whole_x = axis_as(v.chart.x, costs, s.log_x);
  v.whole_y = axis_as(v.chart.y, errors, s.log_y);
  v.x = looked_at(v.whole_x, s.zoom_x);
  v.y = looked_at(v.whole_y, s.zoom_y);
}

}  // namespace

std::span<const FamilyPath> family_paths() { return kFamilies; }

const ChartInput& chart_input(const FrameContext& f) {
  static const ChartInput kNothing;
  return f.input.chart ? *f.input.chart : kNothing;
}

bool family_on(const ChartState& s, const std::string& family) { return !s.hidden.contains(family); }

void toggle_family(ChartState& s, const std::string& family) {
  if (s.hidden.erase(family) == 0) s.hidden.insert(family);
}

ChartView chart_view(const FrameContext& f) {
  const ChartState& s = f.state.of<ChartState>();
  const ChartInput& in = chart_input(f);
  ChartView v;
  v.chart = chart_points(in.rows, s.x, s.y, kFamilies[s.family].path);
  for (size_t i = 0; i < v.chart.points.size(); ++i) {
    const ChartPoint& p = v.point(i);
    if (in.current == p.row) v.current = i;
    if (!family_on(s, p.family)) continue;
    v.shown.push_back(i);
    if (!s.selected.empty() && in.rows[p.row].key == s.selected) v.selected = i;
  }
  v.families = families_of(v.chart, kFamilies[s.family].path);
  v.front = front_of(v);
  scale_axes(v, s);
  return v;
}

SeriesLook ChartView::look(size_t i) const {
  for (const ChartFamily& family : families)
    if (family.name == point(i).family) return series_look(family.number);
  return series_look(0);
}

void apply_row(FrameContext& f, size_t index) {
  const ChartInput& in = chart_input(f);
  if (index >= in.settings.size()) return;
  edit(f, [&](Settings& s) {
    Settings row = in.settings[index];
    row.size = s.size, row.view = s.view, row.time_s = s.time_s;
    if (row.scene == s.scene) row.camera = s.camera;
    s = std::move(row);
  });
}

}  // namespace gbl::ui
