#pragma once
// Points and curves in a frame with two axes: where a value stands on the screen, ticks, marks that differ in colour
// and in shape, lines, steps and a legend. Knows nothing of what the numbers mean.
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "renderer/study/charts/chart.h"
#include "ui/text.h"

namespace gbl::ui {

// ---- marks -------------------------------------------------------------------------------------------------
enum class Mark { disc, square, triangle, diamond, triangle_down, cross, plus, hourglass };
inline constexpr size_t kMarks = 8;

struct SeriesLook {
  Mark mark;
  ImU32 colour;
  bool hollow = false;
};
// Of the n-th series: sixteen differ without their colours, 112 with them.
SeriesLook series_look(size_t n);
void draw_mark(ImDrawList&, ImVec2 centre, float radius, const SeriesLook&);

// ---- axes --------------------------------------------------------------------------------------------------
// The values themselves on a linear axis, their decadic logarithms on a logarithmic one.
struct Span {
  double low, high;
  double width() const { return high - low; }
  bool operator==(const Span&) const = default;
};

struct PlotAxis {
  ChartAxis scale;
  float from = 0, to = 1;  // where its ends are on the screen

  double along(double value) const;  // as a Span counts
  float place(double value) const;
  double value(float at) const;
  bool shows(double value) const;  // is it between the ends?
  Span span() const;
  void look_at(const Span&);
};

// About the place `at` that stays where it is; factor > 1 looks closer. Not closer than a ten-thousandth of `whole` and
// not wider than three times it.
Span zoomed(const Span&, double at, double factor, const Span& whole);
// As far as the middle of what is seen stays in `whole`.
Span moved(const Span&, double by, const Span& whole);

std::vector<ChartTick> ticks_seen(const ChartAxis&);  // of the part that is looked at

// ---- the plot ----------------------------------------------------------------------------------------------
class Plot {
 public:
  // The frame is what `room` leaves when the ticks' labels stand left of it and below it.
  Plot(Painter&, const Box& room, const ChartAxis& x, const ChartAxis& y, float px);

  const Box& frame() const { return frame_; }
  const PlotAxis& x() const { return x_; }
  const PlotAxis& y() const { return y_; }
  ImVec2 at(const glm::dvec2& value) const { return {x_.place(value.x), y_.place(value.y)}; }
  bool shows(const glm::dvec2& value) const { return x_.shows(value.x) && y_.shows(value.y); }

  void draw_axes();
  void draw_line(const std::vector<glm::dvec2>&, ImU32 colour, float thickness);
  void draw_steps(const std::vector<glm::dvec2>&, ImU32 colour, float thickness);    // across, then up or down
  void draw_marks(const std::vector<glm::dvec2>&, const SeriesLook&, float radius);  // of those that it shows
  void cross_out(const glm::dvec2&, ImU32 colour, float radius);                     // what lies there is still seen

 private:
  void draw_x_ticks();
  void draw_y_ticks();
  Painter& painter_;
  Box frame_;
  PlotAxis x_, y_;
  float px_;
};

// ---- legend ------------------------------------------------------------------------------------------------
struct LegendRow {
  std::string key;  // that switches it; "" = none
  std::string name;
  SeriesLook look;
  bool on = true;  // off: hollow words
};
// As large as fits, up to px; returns where each row stands.
std::vector<Box> draw_series_legend(Painter&, const Box&, const std::vector<LegendRow>&, float px);
// The lines that it takes at this size.
float series_legend_height(const std::vector<LegendRow>&, float width, float px);

}  // namespace gbl::ui
