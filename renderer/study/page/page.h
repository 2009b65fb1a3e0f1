#pragma once
// A page that explains measurements: charts, a table and a machine, in one file that needs no network and can be read
// without its script. Data in, page out: studies, stability curves and advice fill the same Page.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/study/charts/chart.h"
#include "renderer/study/page/thumbnails.h"

namespace gbl {

struct PageAxis {
  std::string title;               // with its unit
  ChartAxis shown;                 // at first
  std::optional<ChartAxis> other;  // logarithmic instead of linear, or the reverse; empty: there is no other
};
PageAxis page_axis(const StudyColumn&, const std::vector<double>& values);

struct PagePoint {
  double x = 0, y = 0;  // not finite: at the upper end
  size_t family = 0;
  std::string words;               // what it is and its numbers, a line each
  std::optional<size_t> row = {};  // of the table
  std::string label = {};          // a name that stands beside it; "" = none
  bool sound = true;
  bool noisy = false;   // crossed out
  bool marked = false;  // ringed: a preset, the one that was chosen
  bool on_front = false;
};

struct PageChart {
  std::string title, note;
  PageAxis x, y;
  std::vector<std::string> families;
  std::vector<PagePoint> points;
  std::string front;        // what the line through the points on it is called; "" = no such line
  std::string marked = {};  // what a ring means
  bool joined = false;      // the points of a family by a line, in their order
};

struct PageColumn {
  std::string title;
  std::string help = {};  // of the heading, when the mouse is on it
};
struct PageCell {
  std::string text;
  std::optional<double> number = {};  // by which it is sorted; empty: by its text
};
struct PageRow {
  std::string words;    // what it is
  std::string unsound;  // the failures it is known for; "" = sound
  std::string failed;   // why nothing was measured; "" = it was
  std::string command;  // that measures it again
  bool marked = false;
  Thumbnails thumbnails = {};
  std::vector<PageCell> cells;       // of Page::columns
  std::vector<std::string> details;  // of Page::details; "" = not known
};

struct Page {
  std::string title;
  std::string how_to_read;                                   // a sentence or two
  std::vector<std::pair<std::string, std::string>> machine;  // names and values: driver, device, version, command
  std::vector<PageChart> charts;
  std::string rows_are;     // heading of the table: "The set-ups"
  std::string marked = {};  // what a marked row is: "chosen"
  std::vector<PageColumn> columns;
  std::vector<std::string> details;  // names of what is compared side by side
  std::vector<PageRow> rows;
  bool pictures = false;  // rows have thumbnails, or should
  std::string commands_are = "The command measures that row again.";
};

std::string page_html(const Page&);

// The chart as an <svg> element: dots with what the script needs to know of them, readable as it is.
// `number`: of the chart in its page.
std::string page_svg(const PageChart&, size_t number);
// The table with its rows, and what they are filtered by.
std::string page_table(const Page&);

}  // namespace gbl
