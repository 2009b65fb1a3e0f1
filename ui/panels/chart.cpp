// F3: speed against accuracy. Its row and its keys: whatever the mouse does in it can be done here.
#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "ui/panels/chart_view.h"

namespace gbl::ui {
namespace {

constexpr double kZoomStep = 1.5;

ChartState& chart_of(FrameContext& f) { return f.state.of<ChartState>(); }

template <class List, class Is>
size_t neighbour(const List& list, Is is, bool back) {
  const auto n = static_cast<size_t>(std::size(list));
  const auto at = static_cast<size_t>(std::find_if(std::begin(list), std::end(list), is) - std::begin(list));
  return at == n ? 0 : (at + (back ? n - 1 : 1)) % n;
}

std::string step_column(std::span<const StudyColumn> columns, const std::string& now, bool back) {
  return columns[neighbour(
                     columns, [&](const StudyColumn& c) { return c.id == now; }, back)]
      .id;
}

void step_x(FrameContext& f, const KeyEvent& e) {
  ChartState& s = chart_of(f);
  s.x = step_column(cost_columns(), s.x, e.shift);
  s.zoom_x.reset(), s.log_x.reset();
}

void step_y(FrameContext& f, const KeyEvent& e) {
  ChartState& s = chart_of(f);
  s.y = step_column(chart_error_columns(), s.y, e.shift);
  s.zoom_y.reset(), s.log_y.reset();
}

void toggle_log_y(FrameContext& f, const KeyEvent&) {
  ChartState& s = chart_of(f);
  s.log_y = !chart_view(f).y.logarithmic;
  s.zoom_y.reset();
}

void toggle_log_x(FrameContext& f, const KeyEvent&) {
  ChartState& s = chart_of(f);
  s.log_x = !chart_view(f).x.logarithmic;
  s.zoom_x.reset();
}

void toggle_front(FrameContext& f, const KeyEvent&) { chart_of(f).front = !chart_of(f).front; }

void step_family(FrameContext& f, const KeyEvent& e) {
  ChartState& s = chart_of(f);
  const size_t n = family_paths().size();
  s.family = (s.family + (e.shift ? n - 1 : 1)) % n;
  s.hidden.clear();  // names of other families
}

// 1 … 8 are the first eight, with Shift the next.
void switch_family(FrameContext& f, const KeyEvent& e) {
  const auto number = static_cast<size_t>(e.key[0] - '1') + (e.shift ? 8 : 0);
  for (const ChartFamily& family : chart_view(f).families)
    if (family.number == number) toggle_family(chart_of(f), family.name);
}

// Without a selected point the middle of the plot stays where it is.
void zoom(FrameContext& f, const KeyEvent& e) {
  ChartState& s = chart_of(f);
  const ChartView v = chart_view(f);
  const std::optional<size_t> about = v.selected ? v.selected : v.current;
  const double factor = e.key == "-" ? 1 / kZoomStep : kZoomStep;
  const auto one = [&](const ChartAxis& seen, const ChartAxis& whole, std::optional<double> value) {
    const PlotAxis axis{seen};
    const Span span = axis.span();
    return zoomed(span, value ? axis.along(*value) : (span.low + span.high) / 2, factor, PlotAxis{whole}.span());
  };
  s.zoom_x = one(v.x, v.whole_x, about ? std::optional(v.point(*about).cost) : std::nullopt);
  s.zoom_y = one(v.y, v.whole_y, about ? std::optional(v.point(*about).error) : std::nullopt);
}

void fit_all(FrameContext& f, const KeyEvent&) {
  chart_of(f).zoom_x.reset();
  chart_of(f).zoom_y.reset();
}

void step_study(FrameContext& f, const KeyEvent& e) {
  ChartState& s = chart_of(f);
  const std::vector<ChartInput::Study>& all = chart_input(f).studies;
  if (all.empty()) return say(f, {"There is no study that can run here.", ""});
  const auto& study = all[neighbour(
      all, [&](const ChartInput::Study& one) { return one.id == s.study; }, e.shift)];
  s.study = study.id;
  s.x = study.x, s.y = study.y;
  s.zoom_x.reset(), s.zoom_y.reset(), s.log_x.reset(), s.log_y.reset();
  s.hidden.clear();
  s.selected.clear();
  for (size_t i = 0; i < family_paths().size(); ++i)
    if (study.family == family_paths()[i].path) s.family = i;
  say(f, {fmt::format("Study “{}”: {}. R runs it.", study.id, study.label), ""});
}

void run_or_stop(FrameContext& f, const KeyEvent&) {
  ChartState& s = chart_of(f);
  const bool running = !chart_input(f).running.empty();
  s.run = !running, s.stop = running;
}

// Right and left walk along the cost, up and down along the error; with Shift on the front alone. Every shown point
// is reached.
void select_next(FrameContext& f, const KeyEvent& e) {
  const ChartView v = chart_view(f);
  std::vector<size_t> order = e.shift ? v.front : v.shown;
  if (order.empty()) return say(f, {"There is no point to choose.", ""});
  const bool along_cost = e.key == "Left" || e.key == "Right", back = e.key == "Left" || e.key == "Down";
  const auto rank = [&](size_t i) {
    const ChartPoint& p = v.point(i);
    return along_cost ? std::tuple(p.cost, p.error, i) : std::tuple(p.error, p.cost, i);
  };
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return rank(a) < rank(b); });
  const std::optional<size_t> from = v.selected ? v.selected : v.current;
  size_t next = back ? order.size() - 1 : 0;
  if (from && back) {
    const auto at =
        std::lower_bound(order.begin(), order.end(), *from, [&](size_t a, size_t b) { return rank(a) < rank(b); });
    if (at != order.begin()) next = static_cast<size_t>(at - order.begin()) - 1;
  } else if (from) {
    const auto at =
        std::upper_bound(order.begin(), order.end(), *from, [&](size_t a, size_t b) { return rank(a) < rank(b); });
    if (at != order.end()) next = static_cast<size_t>(at - order.begin());
  }
  chart_of(f).selected = chart_input(f).rows[v.point(order[next]).row].key;
}

void apply_selected(FrameContext& f, const KeyEvent&) {
  const ChartView v = chart_view(f);
  if (!v.selected) return say(f, {"No point is selected: the arrow keys choose one, Enter applies it.", ""});
  apply_row(f, v.point(*v.selected).row);
}

constexpr PanelKey kKeys[] = {
    {"R", "run or stop the study", run_or_stop},
    {"S", "next study", step_study},
    {"Left Right Up Down", "choose a point (Shift: of the front)", select_next, true},
    {"Enter", "apply it", apply_selected},
    {"X", "cost", step_x},
    {"Y", "error", step_y},
    {"K", "log x", toggle_log_x},
    {"L", "log y", toggle_log_y},
    {"F", "front", toggle_front},
    {"G", "families by", step_family},
    {"1-8", "one of them (Shift: 9-16)", switch_family},
    {"+ -", "zoom", zoom, true},
    {"0", "all", fit_all},
};

void ask(FrameContext& f) {
  ChartState& s = chart_of(f);
  // Opened for the first time: a quick study shows what the chart is for. It waits until its studies are known.
  if (s.open && !s.begun && !chart_input(f).studies.empty()) s.begun = s.run = true;
  f.requests.chart = {s.open, s.study, std::exchange(s.run, false), std::exchange(s.stop, false)};
}

}  // namespace

extern const Panel kChartPanel = {.key = "F3",
                                  .id = "chart",
                                  .help = "speed against accuracy: a study's set-ups as points, live",
                                  .place = Place::beside,
                                  .box = side_box,
                                  .draw = draw_chart,
                                  .keys = kKeys,
                                  .make = make_panel_state<ChartState>,
                                  .update = ask,
                                  .in_words = chart_in_words};

}  // namespace gbl::ui
