// F3: a study's set-ups as points, their errors up and their costs to the right, and the settings at hand among them.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "ui/chart_view.h"
#include "ui/plot.h"

namespace gbl::ui {
namespace {

constexpr ImU32 kDark = IM_COL32(10, 12, 15, 255);
constexpr double kWheelStep = 1.25;

struct Places {
  Box head, study, y_title, plot, x_title, counts, family, legend, words, keys;
};

// Lines of text at the top and at the bottom, as high as they need but for the legend; the plot takes the rest.
Places lay_out(const Box& room, const Type& t, float legend_height, bool note) {
  Places p;
  const float body = line_height(t.body), small = line_height(t.small), gap = std::round(t.small * 0.4f);
  float top = room.min.y, bottom = room.max.y;
  const auto below = [&](float height) {
    const Box box{{room.min.x, top}, {room.max.x, top + height}};
    top = box.max.y + gap;
    return box;
  };
  const auto above = [&](float height) {
    const Box box{{room.min.x, bottom - height}, {room.max.x, bottom}};
    bottom = box.min.y - gap;
    return box;
  };
  p.head = below(line_height(t.large));
  p.study = below(body);
  p.y_title = below(body);
  p.keys = above(2.6f * small);
  p.words = above(std::min(8.4f * body, 0.26f * room.height()));
  p.legend = above(std::min(legend_height, 0.16f * room.height()));
  p.family = above(small);
  p.counts = above(note ? 3 * small : small);
  p.x_title = above(body);
  p.plot = {{room.min.x, top}, {room.max.x, bottom}};
  return p;
}

// ---- lines with keys in them ---------------------------------------------------------------------------------
// A cap and words beside it, in one line.
void draw_keyed(Painter& p, const Box& box, float px, std::string_view key, ImU32 colour, std::string_view words) {
  const float left = box.min.x + p.key_cap(box.min, px, key) + px * 0.5f;
  p.text_in({{left, box.min.y + above_text(px)}, {box.max.x, box.max.y + px}}, px, colour, words);
}

struct Hint {
  Box box;
  const ChartKey* row;
};

// The keys with their words, line after line, as large as they fit.
std::vector<Hint> flow_of_hints(const Box& box, float px) {
  std::vector<Hint> hints;
  ImVec2 at = box.min;
  for (const ChartKey& k : chart_keys()) {
    const float width = key_cap_width(k.key, px) + px * 0.4f + text_size(k.words, px).x;
    if (at.x > box.min.x && at.x + width > box.max.x) at = {box.min.x, at.y + std::round(line_height(px) * 1.12f)};
    hints.push_back({{at, {at.x + width, at.y + line_height(px)}}, &k});
    at.x += width + px;
  }
  return hints;
}

void draw_hints(Frame& f, Painter& p, const Box& box) {
  float px = f.type.small;
  std::vector<Hint> hints = flow_of_hints(box, px);
  while (px > kSmallestPx && hints.back().box.max.y > box.max.y) hints = flow_of_hints(box, px -= 1);
  if (hints.back().box.max.y > box.max.y + 1) f.state.cut_texts.emplace_back("the chart's keys");
  for (const Hint& h : hints) {
    const float cap = p.key_cap(h.box.min, px, h.row->key);
    p.text({h.box.min.x + cap + px * 0.4f, h.box.min.y + above_text(px)}, px, kDim, h.row->words);
    if (std::string_view(h.row->key).size() > 1) continue;  // several keys: the mouse has ways of its own
    ImGui::SetCursorScreenPos(h.box.min);
    if (ImGui::InvisibleButton(h.row->words, h.box.size())) h.row->run(f, {h.row->key});
  }
}

// Without what follows a colon: that tells of the study's own scene.
std::string label_of_study(const ChartInput& in, const std::string& id) {
  for (const ChartInput::Study& s : in.studies)
    if (s.id == id) return s.label.substr(0, s.label.find(':'));
  return "";
}

void draw_head(Frame& f, Painter& p, const Places& at) {
  const ChartInput& in = chart_input(f);
  const ChartState& s = f.state.chart;
  const std::string progress = progress_text(in);
  const float right = at.head.max.x - text_size(progress, f.type.body).x;
  const bool other = !in.running.empty() && in.running != s.study;
  p.text_in({at.head.min, {right - f.type.body, at.head.max.y}}, f.type.large, kAccent, "Speed against accuracy");
  p.text({right, at.head.min.y + (at.head.height() - f.type.body) / 2}, f.type.body, kText, progress);
  if (in.total > 0) {  // a bar below it: how far the study has come
    const float y = at.head.max.y + 1, share = static_cast<float>(in.done) / static_cast<float>(in.total);
    p.fill({{at.head.min.x, y}, {at.head.max.x, y + 2}}, kRaised);
    p.fill({{at.head.min.x, y}, {at.head.min.x + share * at.head.width(), y + 2}}, kAccent);
  }
  std::string words = fmt::format("study “{}”", s.study);
  if (const std::string label = label_of_study(in, s.study); !label.empty()) words += fmt::format(": {}", label);
  words += fmt::format("; in this scene, at {}x{}", in.size.x, in.size.y);
  if (other) words += fmt::format("   (“{}” is running)", in.running);
  draw_keyed(p, at.study, f.type.body, "S", kText, words);
}

// ---- the plot ------------------------------------------------------------------------------------------------
float mark_radius(const Type& t) { return std::round(t.small * 0.42f); }

glm::dvec2 value_of(const ChartPoint& p) { return {p.cost, p.error}; }

// The front as a staircase, up to the right edge: what more cost buys.
void draw_front(Plot& plot, const ChartView& v) {
  std::vector<glm::dvec2> corners;
  for (const size_t i : v.front) corners.push_back(value_of(v.point(i)));
  if (corners.empty()) return;
  corners.push_back({std::max(plot.x().scale.high, corners.back().x), corners.back().y});
  plot.draw_steps(corners, kDim, 2);
}

void draw_points(Plot& plot, const ChartView& v, float radius) {
  for (const size_t i : v.shown) plot.draw_marks({value_of(v.point(i))}, v.look(i), radius);
}

bool overlap(const Box& a, const Box& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

// A label beside its point, on the first of eight sides where it touches no other; none is free: no label.
class Labels {
 public:
  Labels(Painter& p, const Box& frame, float px) : painter_(p), frame_(frame), px_(px) {}
  void keep_free(ImVec2 centre, float radius) {
    taken_.push_back({{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}});
  }
  void draw(ImVec2 point, float away, ImU32 colour, const std::string& text) {
    const ImVec2 size = text_size(text, px_);
    constexpr glm::vec2 kSides[] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
    for (const glm::vec2 side : kSides) {
      const ImVec2 centre{point.x + side.x * (away + size.x / 2), point.y + side.y * (away + size.y / 2)};
      const Box box{{centre.x - size.x / 2 - 2, centre.y - size.y / 2 - 1},
                    {centre.x + size.x / 2 + 2, centre.y + size.y / 2 + 1}};
      if (!frame_.contains(box)) continue;
      if (std::any_of(taken_.begin(), taken_.end(), [&](const Box& t) { return overlap(t, box); })) continue;
      taken_.push_back(box);
      painter_.fill(box, kBacking, 2);
      painter_.text({box.min.x + 2, box.min.y + 1}, px_, colour, text);
      return;
    }
  }

 private:
  Painter& painter_;
  Box frame_;
  float px_;
  std::vector<Box> taken_;
};

// Round and thick, dark on both sides: no mark looks like it, whatever it stands on.
void draw_ring(Painter& p, ImVec2 at, float radius, ImU32 colour, float thickness) {
  p.list().AddCircle(at, radius, kDark, 32, thickness + 3);
  p.list().AddCircle(at, radius, colour, 32, thickness);
}

// Lines from a point to its values on the axes.
void draw_cross_hair(Painter& p, const Plot& plot, ImVec2 at) {
  p.list().AddLine({plot.frame().min.x, at.y}, at, kText, 1);
  p.list().AddLine(at, {at.x, plot.frame().max.y}, kText, 1);
}

void draw_selected(Painter& p, const Plot& plot, const ChartView& v, float radius) {
  if (!v.selected || v.selected == v.current || !plot.shows(value_of(v.point(*v.selected)))) return;
  const ChartPoint& point = v.point(*v.selected);
  const ImVec2 at = plot.at(value_of(point));
  draw_cross_hair(p, plot, at);
  draw_mark(p.list(), at, radius * 1.3f, v.look(*v.selected));
  draw_ring(p, at, radius * 2.1f, kText, 2);
}

void draw_current(Painter& p, const Plot& plot, const ChartView& v, float radius, Labels& labels) {
  if (!v.current || !plot.shows(value_of(v.point(*v.current)))) return;
  const ChartPoint& point = v.point(*v.current);
  const ImVec2 at = plot.at(value_of(point));
  draw_mark(p.list(), at, radius * 1.3f, v.look(*v.current));
  draw_ring(p, at, radius * 2.8f, kAccent, 3.5f);
  labels.draw(at, radius * 2.8f + 4, kAccent, "now");
}

void draw_empty(Frame& f, Painter& p, const Box& frame) {
  const ChartInput& in = chart_input(f);
  std::string text = "No rows on these axes yet. R runs the study here.";
  if (!in.running.empty() || in.measuring) text = "Measuring: the first point is about to appear …";
  const float width = frame.width() * 0.8f;
  const float px = p.fit(text, {width, frame.height() * 0.5f}, f.type.large, true);
  const ImVec2 size = text_size(text, px, width);
  p.text({frame.min.x + (frame.width() - size.x) / 2, frame.min.y + (frame.height() - size.y) / 2}, px, kText, text,
         width);
}

void draw_plot(Frame& f, Painter& p, Plot& plot, const ChartView& v) {
  const float radius = mark_radius(f.type);
  plot.draw_axes();
  if (v.shown.empty() && !v.current) return draw_empty(f, p, plot.frame());
  if (f.state.chart.front) draw_front(plot, v);
  draw_points(plot, v, radius);
  Labels labels(p, plot.frame(), f.type.small);
  std::vector<size_t> presets;
  for (const size_t i : v.shown)
    if (v.point(i).preset && plot.shows(value_of(v.point(i)))) presets.push_back(i);
  for (const size_t i : presets) labels.keep_free(plot.at(value_of(v.point(i))), radius);
  draw_selected(p, plot, v, radius);
  draw_current(p, plot, v, radius, labels);
  for (const size_t i : presets) labels.draw(plot.at(value_of(v.point(i))), radius + 3, kText, v.point(i).label);
}

// ---- the mouse -----------------------------------------------------------------------------------------------
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

void wheel(Frame& f, const Plot& plot, const ChartView& v) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel == 0) return;
  const double factor = std::pow(kWheelStep, double(io.MouseWheel));
  const auto one = [&](const PlotAxis& axis, const ChartAxis& whole, float mouse) {
    return zoomed(axis.span(), axis.along(axis.value(mouse)), factor, PlotAxis{whole}.span());
  };
  f.state.chart.zoom_x = one(plot.x(), v.whole_x, io.MousePos.x);
  f.state.chart.zoom_y = one(plot.y(), v.whole_y, io.MousePos.y);
}

void pan(Frame& f, const Plot& plot, const ChartView& v) {
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  if (by.x == 0 && by.y == 0) return;
  const auto one = [](const PlotAxis& axis, const ChartAxis& whole, float pixels) {
    const Span s = axis.span();
    return moved(s, -double(pixels) / double(axis.to - axis.from) * s.width(), PlotAxis{whole}.span());
  };
  f.state.chart.zoom_x = one(plot.x(), v.whole_x, by.x);
  f.state.chart.zoom_y = one(plot.y(), v.whole_y, by.y);
}

// Point: read it. Click: apply it. Drag: move the plot. Wheel: zoom.
void use_mouse(Frame& f, const Plot& plot, const ChartView& v) {
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetCursorScreenPos(plot.frame().min);
  const bool clicked = ImGui::InvisibleButton("plot", plot.frame().size());
  const bool dragged = io.MouseDragMaxDistanceSqr[0] > 9;
  if (ImGui::IsItemActive() && dragged) return pan(f, plot, v);
  if (!ImGui::IsItemHovered()) return;
  wheel(f, plot, v);
  const std::optional<size_t> at = nearest(plot, v, io.MousePos, 2 * mark_radius(f.type) + 4);
  const bool moved_mouse =
      io.MouseDelta.x != 0 || io.MouseDelta.y != 0;  // at rest it leaves the arrow keys' choice alone
  if (at && (moved_mouse || clicked)) f.state.chart.selected = row_key_of(chart_input(f).rows[v.point(*at).row]);
  if (at && clicked && !dragged) apply_row(f, v.point(*at).row);
}

// ---- below the plot --------------------------------------------------------------------------------------------
std::vector<LegendRow> legend_rows(const ChartState& s, const ChartView& v) {
  std::vector<LegendRow> rows;
  for (const ChartFamily& family : v.families) {
    const size_t n = family.number;
    const std::string key = n < 8 ? std::to_string(n + 1) : n < 16 ? fmt::format("⇧{}", n - 7) : "";
    rows.push_back({key, family.name.empty() ? "other" : family.name, series_look(n), family_on(s, family.name)});
  }
  return rows;
}

void use_legend(Frame& f, const ChartView& v, const std::vector<Box>& places) {
  for (size_t i = 0; i < places.size(); ++i) {
    ImGui::SetCursorScreenPos(places[i].min);
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("family", places[i].size())) toggle_family(f.state.chart, v.families[i].name);
    ImGui::PopID();
  }
}

void draw_words(Frame& f, Painter& p, const Box& box, const ChartView& v) {
  const ChartInput& in = chart_input(f);
  p.fill(box, kSurface, 4);
  const Box room = box.inset(std::round(f.type.small * 0.6f));
  std::optional<size_t> row = in.current;
  std::string title = "Now";
  if (v.selected && v.selected != v.current) row = v.point(*v.selected).row, title = "Selected; Enter applies it";
  if (!row || *row >= in.rows.size()) {
    const char* text = in.measuring ? "The settings at hand are being measured."
                                    : "Point at a point, or choose one with the arrow keys, to read it here.";
    p.text_in(room, f.type.body, kText, text, true);
    return;
  }
  title += ":  " + row_title(in, *row);
  const bool now = row == in.current;
  const float height = std::min(room.height() * 0.34f, text_size(title, f.type.body, room.width()).y);
  p.text_in({room.min, {room.max.x, room.min.y + height}}, f.type.body, now ? kAccent : kText, title, true);
  draw_fields(p, {{room.min.x, room.min.y + height + f.type.small * 0.3f}, room.max}, row_fields(in, v, *row),
              f.type.body);
}

void draw_counts(Frame& f, Painter& p, const Box& box, const ChartView& v) {
  const ChartInput& in = chart_input(f);
  std::vector<Paragraph> lines{{counts_text(in, v), kText, f.type.small}};
  if (!in.note.empty()) lines.push_back({in.note, kAccent, f.type.small});
  draw_paragraphs(p, box, lines, 1);
}

}  // namespace

Box chart_box(const Frame& f) {
  const Box& canvas = f.layout.canvas;
  return {{canvas.min.x + std::round(800 * f.layout.unit), canvas.min.y}, {canvas.max.x, f.layout.status.min.y}};
}

void draw_chart(Frame& f) {
  ChartState& s = f.state.chart;
  f.requests.chart = {s.open, s.study, std::exchange(s.run, false), std::exchange(s.stop, false)};
  if (!s.open) return;
  const Box box = chart_box(f), room = box.inset(std::round(12 * f.layout.unit));
  begin_overlay("chart", box, kBackground);
  Painter p(*ImGui::GetWindowDrawList(), f.state.cut_texts);
  ChartView v = chart_view(f);
  const std::vector<LegendRow> legend = legend_rows(s, v);
  const Places at =
      lay_out(room, f.type, series_legend_height(legend, room.width(), f.type.small), !chart_input(f).note.empty());
  Plot plot(p, at.plot, v.x, v.y, f.type.small);
  use_mouse(f, plot, v);
  draw_head(f, p, at);
  draw_keyed(p, at.y_title, f.type.body, "Y", kText, fmt::format("↑ {}", axis_title(v.chart.y)));
  draw_plot(f, p, plot, v);
  draw_keyed(p, at.x_title, f.type.body, "X", kText, fmt::format("→ {}", axis_title(v.chart.x)));
  draw_counts(f, p, at.counts, v);
  draw_keyed(p, at.family, f.type.small, "G", kDim,
             fmt::format("colour and shape: {}", family_paths()[s.family].label));
  use_legend(f, v, draw_series_legend(p, at.legend, legend, f.type.small));
  draw_words(f, p, at.words, v);
  draw_hints(f, p, at.keys);
  end_overlay();
}

}  // namespace gbl::ui
