#include "ui/plot.h"

#include <algorithm>
#include <cmath>

#include "ui/style.h"

namespace gbl::ui {
namespace {

constexpr double kClosest = 1e-4, kWidest = 3;  // zoom, as shares of the whole

// Corners on the unit circle's square, y downwards.
using Corners = std::vector<ImVec2>;
Corners corners_of(Mark mark) {
  switch (mark) {
    case Mark::disc: return {};
    case Mark::square: return {{-0.85f, -0.85f}, {0.85f, -0.85f}, {0.85f, 0.85f}, {-0.85f, 0.85f}};
    case Mark::triangle: return {{0, -1.1f}, {1.05f, 0.8f}, {-1.05f, 0.8f}};
    case Mark::diamond: return {{0, -1.25f}, {0.95f, 0}, {0, 1.25f}, {-0.95f, 0}};
    case Mark::triangle_down: return {{-1.05f, -0.8f}, {1.05f, -0.8f}, {0, 1.1f}};
    case Mark::cross:
    case Mark::plus:
      return {{-0.35f, -1.1f}, {0.35f, -1.1f}, {0.35f, -0.35f}, {1.1f, -0.35f}, {1.1f, 0.35f},   {0.35f, 0.35f},
              {0.35f, 1.1f},   {-0.35f, 1.1f}, {-0.35f, 0.35f}, {-1.1f, 0.35f}, {-1.1f, -0.35f}, {-0.35f, -0.35f}};
    case Mark::hourglass: return {{-1, -1.05f}, {1, -1.05f}, {0.2f, 0}, {1, 1.05f}, {-1, 1.05f}, {-0.2f, 0}};
  }
  return {};
}

ImVec2 turned_by_45(ImVec2 p) { return {0.7071f * (p.x - p.y), 0.7071f * (p.x + p.y)}; }

// Plus and hourglass are not convex, which ImGui's fill asks for: these parts are.
std::vector<std::vector<int>> parts_of(Mark mark) {
  if (mark == Mark::cross || mark == Mark::plus) return {{0, 1, 6, 7}, {3, 4, 9, 10}};
  if (mark == Mark::hourglass) return {{0, 1, 2, 5}, {5, 2, 3, 4}};
  return {};
}

}  // namespace

SeriesLook series_look(size_t n) {
  return {static_cast<Mark>(n % kMarks), theme().series[n % theme().series.size()], (n / kMarks) % 2 == 1};
}

void draw_mark(ImDrawList& list, ImVec2 centre, float radius, const SeriesLook& look) {
  const ImU32 inside = look.hollow ? theme().edge : look.colour, border = look.hollow ? look.colour : theme().edge;
  const float thickness = look.hollow ? std::max(1.5f, radius * 0.35f) : 1;
  if (look.mark == Mark::disc) {
    list.AddCircleFilled(centre, radius, inside, 16);
    list.AddCircle(centre, radius, border, 16, thickness);
    return;
  }
  Corners all = corners_of(look.mark);
  for (ImVec2& p : all) {
    if (look.mark == Mark::cross) p = turned_by_45(p);
    p = {centre.x + radius * p.x, centre.y + radius * p.y};
  }
  const std::vector<std::vector<int>> parts = parts_of(look.mark);
  if (parts.empty()) list.AddConvexPolyFilled(all.data(), static_cast<int>(all.size()), inside);
  for (const std::vector<int>& part : parts) {
    Corners some;
    for (const int i : part) some.push_back(all[static_cast<size_t>(i)]);
    list.AddConvexPolyFilled(some.data(), static_cast<int>(some.size()), inside);
  }
  list.AddPolyline(all.data(), static_cast<int>(all.size()), border, ImDrawFlags_Closed, thickness);
}

double PlotAxis::along(double value) const {
  const double placed = scale.place(value);
  return scale.logarithmic ? std::log10(placed) : placed;
}

Span PlotAxis::span() const { return {along(scale.low), along(scale.high)}; }

float PlotAxis::place(double value) const {
  const Span s = span();
  const double share = std::clamp((along(value) - s.low) / s.width(), -1e3, 1e3);  // far outside: still a float
  return from + static_cast<float>(share) * (to - from);
}

double PlotAxis::value(float at) const {
  const Span s = span();
  const double along_axis = s.low + double(at - from) / double(to - from) * s.width();
  return scale.logarithmic ? std::pow(10, along_axis) : along_axis;
}

bool PlotAxis::shows(double value) const {
  const double placed = scale.place(value);
  return placed >= scale.low && placed <= scale.high;
}

void PlotAxis::look_at(const Span& s) {
  scale.low = scale.logarithmic ? std::pow(10, s.low) : s.low;
  scale.high = scale.logarithmic ? std::pow(10, s.high) : s.high;
}

Span zoomed(const Span& s, double at, double factor, const Span& whole) {
  const double width = std::clamp(s.width() / factor, kClosest * whole.width(), kWidest * whole.width());
  const double share = (at - s.low) / s.width();
  return {at - share * width, at + (1 - share) * width};
}

Span moved(const Span& s, double by, const Span& whole) {
  const double middle = (s.low + s.high) / 2;
  by = std::clamp(middle + by, whole.low, whole.high) - middle;
  return {s.low + by, s.high + by};
}

std::vector<ChartTick> ticks_seen(const ChartAxis& axis) {
  ChartAxis seen = axis;
  if (seen.zero_at && (*seen.zero_at < seen.low || *seen.zero_at > seen.high)) seen.zero_at.reset();
  std::vector<ChartTick> ticks = ticks_of(seen);
  std::erase_if(ticks, [&](const ChartTick& t) { return t.at < axis.low || t.at > axis.high; });
  return ticks;
}

Plot::Plot(Painter& painter, const Box& room, const ChartAxis& x, const ChartAxis& y, float px)
    : painter_(painter), x_{x}, y_{y}, px_(px) {
  float widest = px;
  for (const ChartTick& t : ticks_seen(y)) widest = std::max(widest, text_size(t.label, px).x);
  const float gap = std::round(px * 0.5f);
  frame_ = {{std::round(room.min.x + widest + gap), std::round(room.min.y + px / 2)},
            {std::round(room.max.x - px), std::round(room.max.y - line_height(px) - gap)}};
  x_.from = frame_.min.x, x_.to = frame_.max.x;
  y_.from = frame_.max.y, y_.to = frame_.min.y;
}

namespace {

// A line of dashes: where a logarithmic axis puts its zeros, no distance means anything.
void draw_dashes(ImDrawList& list, ImVec2 from, ImVec2 to, float dash) {
  const float length = std::max(to.x - from.x, from.y - to.y);
  const ImVec2 step{(to.x - from.x) / length, (to.y - from.y) / length};
  const int dashes = static_cast<int>(std::ceil(length / (2 * dash)));
  for (int i = 0; i < dashes; ++i) {
    const float at = 2 * dash * static_cast<float>(i);
    const float end = std::min(at + dash, length);
    list.AddLine({from.x + at * step.x, from.y + at * step.y}, {from.x + end * step.x, from.y + end * step.y},
                 theme().dim, 1);
  }
}

bool is_zero_place(const ChartAxis& axis, const ChartTick& t) { return axis.zero_at && t.at == *axis.zero_at; }

}  // namespace

void Plot::draw_x_ticks() {
  float free_from = frame_.min.x - 2 * px_;  // a label that would touch the one before is left out
  for (const ChartTick& t : ticks_seen(x_.scale)) {
    const float at = std::round(x_.place(t.at));
    if (is_zero_place(x_.scale, t))
      draw_dashes(painter_.list(), {at, frame_.max.y}, {at, frame_.min.y}, px_ / 2);
    else
      painter_.list().AddLine({at, frame_.min.y}, {at, frame_.max.y}, theme().raised, 1);
    const float width = text_size(t.label, px_).x;
    if (at - width / 2 < free_from) continue;
    painter_.text({at - width / 2, frame_.max.y + px_ * 0.35f}, px_, theme().text, t.label);
    free_from = at + width / 2 + px_ * 0.6f;
  }
}

void Plot::draw_y_ticks() {
  float free_below = frame_.max.y + px_;
  for (const ChartTick& t : ticks_seen(y_.scale)) {
    const float at = std::round(y_.place(t.at));
    if (is_zero_place(y_.scale, t))
      draw_dashes(painter_.list(), {frame_.min.x, at}, {frame_.max.x, at}, px_ / 2);
    else
      painter_.list().AddLine({frame_.min.x, at}, {frame_.max.x, at}, theme().raised, 1);
    const ImVec2 size = text_size(t.label, px_);
    if (at + size.y / 2 > free_below) continue;
    painter_.text({frame_.min.x - size.x - px_ * 0.5f, at - size.y / 2}, px_, theme().text, t.label);
    free_below = at - size.y / 2;
  }
}

void Plot::draw_axes() {
  painter_.fill(frame_, theme().background);
  draw_x_ticks();
  draw_y_ticks();
  painter_.outline(frame_, theme().line, 1);
}

void Plot::draw_line(const std::vector<glm::dvec2>& points, ImU32 colour, float thickness) {
  std::vector<ImVec2> places;
  for (const glm::dvec2& p : points) {
    const ImVec2 place = at(p);  // a line of no length would get a corner of any direction
    if (places.empty() || place.x != places.back().x || place.y != places.back().y) places.push_back(place);
  }
  ImDrawList& list = painter_.list();
  list.PushClipRect(frame_.min, frame_.max, true);
  list.AddPolyline(places.data(), static_cast<int>(places.size()), colour, 0, thickness);
  list.PopClipRect();
}

void Plot::draw_steps(const std::vector<glm::dvec2>& points, ImU32 colour, float thickness) {
  std::vector<glm::dvec2> corners;
  for (const glm::dvec2& p : points) {
    if (!corners.empty()) corners.emplace_back(p.x, corners.back().y);
    corners.push_back(p);
  }
  draw_line(corners, colour, thickness);
}

void Plot::draw_marks(const std::vector<glm::dvec2>& points, const SeriesLook& look, float radius) {
  for (const glm::dvec2& p : points)
    if (shows(p)) draw_mark(painter_.list(), at(p), radius, look);
}

void Plot::cross_out(const glm::dvec2& p, ImU32 colour, float radius) {
  if (!shows(p)) return;
  const ImVec2 c = at(p);
  for (const float side : {-1.0f, 1.0f})
    painter_.list().AddLine({c.x - radius, c.y - side * radius}, {c.x + radius, c.y + side * radius}, colour, 1.5f);
}

// ---- legend ------------------------------------------------------------------------------------------------
namespace {

struct LegendColumns {
  float px, width;
  size_t columns, lines;
};

LegendColumns legend_columns(const std::vector<LegendRow>& rows, float width, float px) {
  float widest = 1;
  for (const LegendRow& r : rows)
    widest = std::max(widest, (r.key.empty() ? 0 : key_cap_width(r.key, px)) + 2.4f * px + text_size(r.name, px).x);
  widest += px;
  const auto columns = std::max<size_t>(1, static_cast<size_t>(width / widest));
  const size_t used = std::max<size_t>(1, std::min(columns, rows.size()));
  return {px, width / static_cast<float>(used), used, (rows.size() + used - 1) / used};
}

float legend_line(float px) { return std::round(line_height(px) * 1.15f); }

void draw_legend_row(Painter& p, const Box& box, const LegendRow& r, float px) {
  float x = box.min.x;
  if (!r.key.empty()) x += p.key_cap({x, box.min.y}, px, r.key);
  const ImVec2 mark{x + px * 1.1f, box.min.y + line_height(px) / 2};
  if (r.on) draw_mark(p.list(), mark, px * 0.42f, r.look);
  const Box words{{x + px * 2.1f, box.min.y + above_text(px)}, {box.max.x, box.max.y + px}};
  const float size = p.fit(r.name, words.size(), px, false);
  const ImVec2 taken = p.text(words.min, size, r.on ? theme().text : theme().dim, r.name);
  const float middle = std::floor(words.min.y + taken.y / 2);
  if (!r.on) p.list().AddLine({words.min.x, middle}, {words.min.x + taken.x, middle}, theme().dim, 1);
}

}  // namespace

float series_legend_height(const std::vector<LegendRow>& rows, float width, float px) {
  return static_cast<float>(legend_columns(rows, width, px).lines) * legend_line(px);
}

std::vector<Box> draw_series_legend(Painter& p, const Box& box, const std::vector<LegendRow>& rows, float px) {
  while (px > kSmallestPx && series_legend_height(rows, box.width(), px) > box.height()) px -= 1;
  const LegendColumns c = legend_columns(rows, box.width(), px);
  std::vector<Box> places;
  for (size_t i = 0; i < rows.size(); ++i) {  // down each column, as it is read
    const size_t nth_column = i / c.lines;
    const auto column = static_cast<float>(nth_column), line = static_cast<float>(i % c.lines);
    const ImVec2 min{box.min.x + column * c.width, std::round(box.min.y + line * legend_line(px))};
    places.push_back({min, {min.x + c.width - px * 0.5f, min.y + legend_line(px)}});
    draw_legend_row(p, places.back(), rows[i], px);
  }
  return places;
}

}  // namespace gbl::ui
