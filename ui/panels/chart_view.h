#pragma once
// What the chart shows in a frame: the rows as points on the chosen axes, without the families that are switched off.
#include <set>

#include "ui/panels/side_panel.h"
#include "ui/plot.h"

namespace gbl::ui {

struct ChartState : PanelState {
  std::string study = "quick";
  bool begun = false;  // that study, when the chart was opened for the first time
  std::string x = "time_ms_total_median", y = "over_1_255_display";  // columns
  size_t family = 0;                                                 // of the family paths
  std::optional<bool> log_x, log_y;                                  // empty: as the column asks for
  bool front = true;
  std::set<std::string> hidden;        // families
  std::optional<Span> zoom_x, zoom_y;  // empty: everything
  std::string selected;                // a row's key; empty = none
  bool run = false, stop = false;      // asked for in this frame
};

struct FamilyPath {
  const char* path;
  const char* label;
};
std::span<const FamilyPath> family_paths();

// Keeps its number, and with it its key, colour and shape, whatever else is measured: that of its row in the options
// table.
struct ChartFamily {
  std::string name;
  size_t number;
};

struct ChartView {
  Chart chart;                        // every point
  std::vector<ChartFamily> families;  // by their numbers
  std::vector<size_t> shown;          // of them: their family is on
  std::vector<size_t> front;          // of the shown: none of them is better in both; by cost
  ChartAxis whole_x, whole_y;         // of what is shown
  ChartAxis x, y;                     // of them the part that is looked at
  std::optional<size_t> selected;     // a shown point
  std::optional<size_t> current;      // the settings at hand; shown or not
  const ChartPoint& point(size_t i) const { return chart.points[i]; }
  SeriesLook look(size_t i) const;  // of a point
};
const ChartInput& chart_input(const FrameContext&);  // an empty one where nothing is ever measured
ChartView chart_view(const FrameContext&);

bool family_on(const ChartState&, const std::string& family);
void toggle_family(ChartState&, const std::string& family);
void apply_row(FrameContext&, size_t index);  // of the input: all that is no size, view, time, nor this scene's camera

// A row in words, for the box below the plot.
std::vector<Field> row_fields(const ChartInput&, const ChartView&, size_t index);
std::string row_title(const ChartInput&, size_t index);
std::string progress_text(const ChartInput&);  // "37/272, 4 min left"; "" = nothing to count
std::string counts_text(const ChartInput&, const ChartView&);
std::string chart_in_words(const FrameContext&);  // how far it is, and its chosen point, else the settings at hand

void draw_chart_points(FrameContext&, Painter&, Plot&, const ChartView&);
void use_chart_mouse(FrameContext&, const Plot&, const ChartView&);  // point, click, drag, wheel

void draw_chart(FrameContext&, Painter&, const Box&);

}  // namespace gbl::ui
