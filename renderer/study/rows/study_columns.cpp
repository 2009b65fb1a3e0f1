#include "renderer/study/rows/study_columns.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/size_text.h"

namespace gbl {
namespace {

template <class T>
ColumnValue or_empty(const std::optional<T>& value) {
  return value ? ColumnValue(Number(*value)) : ColumnValue();
}

StudyColumn column_of(const ErrorColumn& e) {
  const bool judges = e.kind != ErrorKind::basis;  // else it says how many were judged, not how
  return {.id = e.id,
          .unit = e.unit,
          .label = fmt::format("{}: {}", e.id, e.help),
          .axis = judges ? Axis::error : Axis::none,
          .more_is_better = e.kind == ErrorKind::quality,
          .magnitude = e.kind == ErrorKind::bias,
          .share_of = e.kind == ErrorKind::share ? "compared_pixels" : "",
          .of_row = [value = e.value](const Measurement& m) { return or_empty(m.errors.*value); }};
}

#define FRAME(expr) .of_frame = [](const FrameReport& r, const Machine&) -> ColumnValue { return expr; }
#define PAIRS(expr) FRAME(r.pairs ? ColumnValue(expr) : ColumnValue())
#define LISTS(expr) FRAME(r.lists ? ColumnValue(expr) : ColumnValue())
#define MACHINE(member) .of_frame = [](const FrameReport&, const Machine& m) -> ColumnValue { return m.member; }

// The times of every pass are in the rows, whatever the passes are; those with a row here can be on an axis.
StudyColumn time_column(const char* pass, const char* label, int place) {
  return {.id = fmt::format("time_ms_{}_median", pass),
          .unit = "ms",
          .label = label,
          .axis = Axis::cost,
          .place = place,
          .p10 = fmt::format("time_ms_{}_p10", pass),
          .p90 = fmt::format("time_ms_{}_p90", pass)};
}

// clang-format off
const StudyColumn kCosts[] = {
    time_column("total", "time of a frame, median", 1),
    time_column("lighting", "time of the lighting, median", 2),
    {.id = "frames", .of_row = [](const Measurement& m) -> ColumnValue { return m.timing.frames; }},
    {.id = "size", .unit = "pixels", FRAME(size_text(r.size))},
    {.id = "time_source", FRAME(r.time_source)},
    {.id = "pairs_tested", .label = "pairs of pixel and light tested", .axis = Axis::cost, .place = 7, PAIRS(Number(r.pairs->tested))},
    {.id = "pairs_shaded", .label = "pairs of pixel and light shaded", .axis = Axis::cost, .place = 6, PAIRS(Number(r.pairs->shaded))},
    {.id = "pairs_lit", PAIRS(or_empty(r.pairs->lit))},
    {.id = "shaded_per_lit", .label = "pairs shaded for each one that is lit", .axis = Axis::cost, .place = 8, .numerator = "pairs_shaded", .denominator = "pairs_lit"},
    {.id = "tested_per_lit", .label = "pairs tested for each one that is lit", .axis = Axis::cost, .place = 10, .numerator = "pairs_tested", .denominator = "pairs_lit"},
    {.id = "tile_px", .unit = "pixels", LISTS(r.lists->tile_px)},
    {.id = "light_px", .unit = "pixels", LISTS(r.lists->light_px)},
    {.id = "list_entries", LISTS(Number(r.lists->entries))},
    {.id = "lists_ms", .unit = "ms", LISTS(r.lists->ms)},
    {.id = "bytes_per_pixel", .unit = "bytes per pixel", .label = "G-buffer", .axis = Axis::cost, .place = 3, FRAME(r.gbuffer_bytes_per_pixel)},
    {.id = "accumulation_bytes_per_pixel", .unit = "bytes per pixel", .label = "light targets", .axis = Axis::cost, .place = 4, FRAME(r.accumulation_bytes_per_pixel)},
    {.id = "mib", .unit = "MiB", .label = "all targets of a frame", .axis = Axis::cost, .place = 5, FRAME(r.mib)},
    {.id = "draw_calls", .label = "draw calls", .axis = Axis::cost, .place = 9, FRAME(r.draw_calls)},
    {.id = "driver", MACHINE(driver)},
    {.id = "device", MACHINE(device)},
};
// clang-format on
#undef MACHINE
#undef LISTS
#undef PAIRS
#undef FRAME

std::vector<StudyColumn> make_columns() {
  std::vector<StudyColumn> all;
  for (const ErrorColumn& e : error_columns()) all.push_back(column_of(e));
  all.insert(all.end(), std::begin(kCosts), std::end(kCosts));
  return all;
}

void append(std::vector<Cell>& cells, std::span<const StudyColumn> columns, const Measurement& m) {
  for (const StudyColumn& c : columns) {
    if (c.of_row) cells.push_back({c.id, c.of_row(m)});
    if (c.of_frame) cells.push_back({c.id, c.of_frame(m.report, m.machine)});
  }
}

std::vector<StudyColumn> columns_for(Axis axis) {
  std::vector<StudyColumn> found;
  for (const StudyColumn& c : study_columns())
    if (c.axis == axis) found.push_back(c);
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
  return found;
}

const StudyColumn& column_called(std::string_view id, std::span<const StudyColumn> columns, std::string_view what) {
  std::vector<std::string_view> known;
  for (const StudyColumn& c : columns) {
    if (c.id == id) return c;
    known.emplace_back(c.id);
  }
  throw Error(ExitCode::bad_input, what, fmt::format("unknown column '{}'", id), suggest(id, known));
}

void append_times(std::vector<Cell>& cells, const Timing& timing) {
  for (const auto& [pass, ms] : timing.pass_ms) {
    if (ms.empty()) continue;
    const TimeSpread t = spread_of(ms);
    cells.push_back({fmt::format("time_ms_{}_median", pass), Number(t.median)});
    cells.push_back({fmt::format("time_ms_{}_p10", pass), Number(t.p10)});
    cells.push_back({fmt::format("time_ms_{}_p90", pass), Number(t.p90)});
  }
}

void append_traffic(std::vector<Cell>& cells, const FrameReport& report) {
  for (const PassTraffic& t : report.traffic) {
    cells.push_back({fmt::format("bytes_read_{}", t.pass), Number(t.read)});
    cells.push_back({fmt::format("bytes_written_{}", t.pass), Number(t.written)});
  }
}

}  // namespace

TimeSpread spread_of(std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double share) {
    const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(ms.size())));
    return ms[std::max<size_t>(rank, 1) - 1];
  };
  return {at(0.5), at(0.1), at(0.9)};
}

std::span<const StudyColumn> study_columns() {
  static const std::vector<StudyColumn> kColumns = make_columns();
  return kColumns;
}

std::vector<Cell> cells_of(const Measurement& m) {
  std::vector<Cell> cells;
  append(cells, study_columns().first(error_columns().size()), m);
  append_times(cells, m.timing);
  append_traffic(cells, m.report);
  append(cells, study_columns().subspan(error_columns().size()), m);
  return cells;
}

std::vector<Cell> cells_of(const FrameReport& report, const Machine& machine) {
  std::vector<Cell> cells;
  for (const StudyColumn& c : study_columns())
    if (c.of_frame) cells.push_back({c.id, c.of_frame(report, machine)});
  return cells;
}

std::span<const StudyColumn> cost_columns() {
  static const std::vector<StudyColumn> kColumns = columns_for(Axis::cost);
  return kColumns;
}

std::span<const StudyColumn> chart_error_columns() {
  static const std::vector<StudyColumn> kColumns = columns_for(Axis::error);
  return kColumns;
}

const StudyColumn& cost_column(std::string_view id) { return column_called(id, cost_columns(), "x"); }
const StudyColumn& chart_error_column(std::string_view id) { return column_called(id, chart_error_columns(), "y"); }

}  // namespace gbl
