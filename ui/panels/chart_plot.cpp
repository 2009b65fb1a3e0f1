// The chart's points, its front, the ring around the settings at hand, and the mouse among them.
#include <algorithm>
#include <cmath>

#include "ui/panels/chart_view.h"

namespace gbl::ui {
namespace {

constexpr double kWheelStep = 1.25;

float mark_radius(const Type& t) { return std::round(t.small * 0.45f); }

glm::dvec2 value_of(const ChartPoint& p) { return {p.cost, p.error}; }

// The front as a staircase, up to the right edge: what more cost buys.
void draw_front(Plot& plot, const ChartView& v) {
  std::vector<glm::dvec2> corners;
  for (const size_t i : v.front) corners.push_back(value_of(v.point(i)));
  if (corners.empty()) return;
  corners.emplace_back(std::max(plot.x().scale.high, corners.back().x), corners.back().y);
  plot.draw_steps(corners, theme().dim, 2);
}

void draw_points(Plot& plot, const ChartView& v, float radius) {
  for (const bool presets : {false, true})  // those with names on top
    for (const size_t i : v.shown)
      if (v.point(i).preset == presets) plot.draw_marks({value_of(v.point(i))}, v.look(i), radius);
  for (const size_t i : v.shown)
    if (v.point(i).noisy) plot.cross_out(value_of(v.point(i)), theme().unsound, 1.4f * radius);
}

bool overlap(const Box& a, const Box& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

// Labels beside their points. They never touch each other, and cover a mark only where every other side is worse.
class Labels {
 public:
  Labels(Painter& p, const Box& frame, float px) : painter_(p), frame_(frame), px_(px) {}
  void avoid(ImVec2 centre, float radius) {
    marks_.push_back({{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}});
  }
  void keep_free(ImVec2 centre, float radius) {
    labels_.push_back({{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}});
  }
  void draw(ImVec2 point, float away, ImU32 colour, const std::string& text) {
    const std::optional<Box> box = place(point, away, text_size(text, px_));
    if (!box) return;  // none is free: pointing at the mark tells its name
    labels_.push_back(*box);
    painter_.fill(*box, theme().backing, 2);
    painter_.text({box->min.x + 2, box->min.y + 1}, px_, colour, text);
  }

 private:
  static long touched(const std::vector<Box>& list, const Box& box) {
    return std::count_if(list.begin(), list.end(), [&](const Box& other) { return overlap(other, box); });
  }
  std::optional<Box> place(ImVec2 point, float away, ImVec2 size) const {
    constexpr glm::vec2 kSides[] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
    std::optional<Box> best;
    long fewest = 0;
    for (const glm::vec2 side : kSides) {
      const ImVec2 half{size.x / 2 + 2, size.y / 2 + 1};
      const ImVec2 centre{point.x + side.x * (away + half.x), point.y + side.y * (away + half.y)};
      const Box box{{centre.x - half.x, centre.y - half.y}, {centre.x + half.x, centre.y + half.y}};
      if (!frame_.contains(box) || touched(labels_, box) > 0) continue;
      const long covered = touched(marks_, box);
      if (!best || covered < fewest) best = box, fewest = covered;
    }
    return best;
  }
  Painter& painter_;
  Box frame_;
  float px_;
  std::vector<Box> labels_, marks_;
};

// Round and thick, dark on both sides: no mark looks like it, whatever it stands on.
void draw_ring(Painter& p, ImVec2 at, float radius, ImU32 colour, float thickness) {
  p.list().AddCircle(at, radius, theme().edge, 32, thickness + 3);
  p.list().AddCircle(at, radius, colour, 32, thickness);
}

// Lines from a point to its values on the axes.
void draw_cross_hair(Painter& p, const Plot& plot, ImVec2 at) {
  p.list().AddLine({plot.frame().min.x, at.y}, at, theme().text, 1);
  p.list().AddLine(at, {at.x, plot.frame().max.y}, theme().text, 1);
}

void draw_selected(Painter& p, const Plot& plot, const ChartView& v, float radius) {
  if (!v.selected || v.selected == v.current || !plot.shows(value_of(v.point(*v.selected)))) return;
  const ChartPoint& point = v.point(*v.selected);
  const ImVec2 at = plot.at(value_of(point));
  draw_cross_hair(p, plot, at);
  draw_mark(p.list(), at, radius * 1.3f, v.look(*v.selected));
  draw_ring(p, at, radius * 2.1f, theme().text, 2);
}

void draw_current(Painter& p, const Plot& plot, const ChartView& v, float radius, Labels& labels) {
  if (!v.current || !plot.shows(value_of(v.point(*v.current)))) return;
  const ChartPoint& point = v.point(*v.current);
  const ImVec2 at = plot.at(value_of(point));
  draw_mark(p.list(), at, radius * 1.3f, v.look(*v.current));
  draw_ring(p, at, radius * 2.8f, theme().accent, 3.5f);
  labels.keep_free(at, radius * 2.6f);
  labels.draw(at, radius * 2.8f + 4, theme().accent, "now");
}

void draw_empty(FrameContext& f, Painter& p, const Box& frame) {
  const ChartInput& in = chart_input(f);
  std::string text = "No rows on these axes yet. R runs the study here.";
  if (!in.running.empty() || in.measuring) text = "Measuring: the first point is about to appear …";
  const float width = frame.width() * 0.8f;
  const float px = p.fit(text, {width, frame.height() * 0.5f}, f.type.large, true);
  const ImVec2 size = text_size(text, px, width);
  p.text({frame.min.x + (frame.width() - size.x) / 2, frame.min.y + (frame.height() - size.y) / 2}, px, theme().text,
         text, width);
}

std::optional<size_t> nearest(const Plot& plot, const ChartView& v, ImVec2 mouse, float within) {
  std::optional<size_t> found;
  float best = within * within;
  for (const size_t i : v.shown) {
    if (!plot.shows(value_of(v.point(i)))) continue;
    const ImVec2 at = plot.at(value_of(v.point(i)));
    const float d2 = (at.x - mouse.x) * (at.x - mouse.x) + (at.y - mouse.y) * (at.y - mouse.y);
    if (d2 <= best) best = d2, found = i;
  }
  return found;
}

void wheel(FrameContext& f, const Plot& plot, const ChartView& v) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel == 0) return;
  const double factor = std::pow(kWheelStep, double(io.MouseWheel));
  const auto one = [&](const PlotAxis& axis, const ChartAxis& whole, float mouse) {
    return zoomed(axis.span(), axis.along(axis.value(mouse)), factor, PlotAxis{whole}.span());
  };
  f.state.of<ChartState>().zoom_x = one(plot.x(), v.whole_x, io.MousePos.x);
  f.state.of<ChartState>().zoom_y = one(plot.y(), v.whole_y, io.MousePos.y);
}

void pan(FrameContext& f, const Plot& plot, const ChartView& v) {
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  if (by.x == 0 && by.y == 0) return;
  const auto one = [](const PlotAxis& axis, const ChartAxis& whole, float pixels) {
    const Span s = axis.span();
    return moved(s, -double(pixels) / double(axis.to - axis.from) * s.width(), PlotAxis{whole}.span());
  };
  f.state.of<ChartState>().zoom_x = one(plot.x(), v.whole_x, by.x);
  f.state.of<ChartState>().zoom_y = one(plot.y(), v.whole_y, by.y);
}

}  // namespace

void draw_chart_points(FrameContext& f, Painter& p, Plot& plot, const ChartView& v) {
  const float radius = mark_radius(f.type);
  plot.draw_axes();
  if (v.shown.empty() && !v.current) return draw_empty(f, p, plot.frame());
  if (f.state.of<ChartState>().front) draw_front(plot, v);
  draw_points(plot, v, radius);
  Labels labels(p, plot.frame(), f.type.small);
  std::vector<size_t> presets;
  for (const size_t i : v.shown)
    if (v.point(i).preset && plot.shows(value_of(v.point(i)))) presets.push_back(i);
  for (const size_t i : v.shown) labels.avoid(plot.at(value_of(v.point(i))), radius);
  draw_selected(p, plot, v, radius);
  draw_current(p, plot, v, radius, labels);
  for (const size_t i : presets)
    labels.draw(plot.at(value_of(v.point(i))), (i == v.current ? 2.8f * radius : radius) + 3, theme().text,
                v.point(i).label);
}

// Point: read it. Click: apply it. Drag: move the plot. Wheel: zoom.
void use_chart_mouse(FrameContext& f, const Plot& plot, const ChartView& v) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool clicked = hit_area("plot", plot.frame());
  const bool dragged = io.MouseDragMaxDistanceSqr[0] > 9;
  if (ImGui::IsItemActive() && dragged) return pan(f, plot, v);
  if (!ImGui::IsItemHovered()) return;
  wheel(f, plot, v);
  const std::optional<size_t> at = nearest(plot, v, io.MousePos, 2 * mark_radius(f.type) + 4);
  const bool moved_mouse =
      io.MouseDelta.x != 0 || io.MouseDelta.y != 0;  // at rest it leaves the arrow keys' choice alone
  if (at && (moved_mouse || clicked)) f.state.of<ChartState>().selected = chart_input(f).rows[v.point(*at).row].key;
  if (at && clicked && !dragged) apply_row(f, v.point(*at).row);
}

}  // namespace gbl::ui
