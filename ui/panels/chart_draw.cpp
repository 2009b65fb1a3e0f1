// The chart's panel: a study's set-ups as points, their errors up and their costs to the right, and the settings at hand among them.
#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/size_text.h"
#include "ui/panels/chart_view.h"
#include "ui/plot.h"

namespace gbl::ui {
namespace {

struct Places {
  Box head, study, y_title, plot, x_title, counts, family, legend, words, keys;
};

// How much of the panel the texts below the plot may take; in large type they shrink rather than the plot.
struct Shares {
  float words, legend, key_lines;
};
constexpr Shares kShares{0.20f, 0.14f, 2.6f}, kLargeShares{0.20f, 0.10f, 2.2f};
constexpr float kLargeType = 18;  // pixels of the 1600x900 design

// Lines of text at the top and at the bottom, as high as they need but for the legend; the plot takes the rest.
Places lay_out(const Box& room, const Type& t, float family_width, const std::vector<LegendRow>& legend, bool note,
               bool large) {
  Places p;
  const Shares& share = large ? kLargeShares : kShares;
  const float body = line_height(t.body), small = line_height(t.small), gap = std::round(t.small * 0.4f);
  const float legend_height = series_legend_height(legend, room.width() - family_width - 2 * gap, t.small);
  Shelf shelf{room, gap};
  p.head = shelf.below(line_height(t.large));
  p.study = shelf.below(body);
  p.y_title = shelf.below(body);
  p.keys = shelf.above(share.key_lines * small);
  p.words = shelf.above(std::min(6.6f * body, share.words * room.height()));
  p.legend = p.family = shelf.above(std::clamp(legend_height, small, share.legend * room.height()));
  p.family.max = {p.legend.min.x + family_width, p.legend.min.y + small};
  p.legend.min.x += family_width + 2 * gap;
  p.counts = shelf.above(note ? 3 * small : small);
  p.x_title = shelf.above(body);
  p.plot = shelf.room;
  return p;
}

// Without what follows a colon: that tells of the study's own scene.
std::string label_of_study(const ChartInput& in, const std::string& id) {
  for (const ChartInput::Study& s : in.studies)
    if (s.id == id) return s.label.substr(0, s.label.find(':'));
  return "";
}

void draw_head(FrameContext& f, Painter& p, const Places& at) {
  const ChartInput& in = chart_input(f);
  const ChartState& s = f.state.of<ChartState>();
  const std::string progress = progress_text(in);
  const float right = at.head.max.x - text_size(progress, f.type.body).x;
  const bool other = !in.running.empty() && in.running != s.study;
  p.text_in({at.head.min, {right - f.type.body, at.head.max.y}}, f.type.large, theme().accent,
            "Speed against accuracy");
  p.text({right, at.head.min.y + (at.head.height() - f.type.body) / 2}, f.type.body, theme().text, progress);
  if (in.total > 0) {  // a bar below it: how far the study has come
    const float y = at.head.max.y + 1, share = static_cast<float>(in.done) / static_cast<float>(in.total);
    p.fill({{at.head.min.x, y}, {at.head.max.x, y + 2}}, theme().raised);
    p.fill({{at.head.min.x, y}, {at.head.min.x + share * at.head.width(), y + 2}}, theme().accent);
  }
  std::string words = fmt::format("study “{}”", s.study);
  if (const std::string label = label_of_study(in, s.study); !label.empty()) words += fmt::format(": {}", label);
  words += fmt::format("; in this scene, at {}", size_text(in.size));
  if (other) words += fmt::format("   (“{}” is running)", in.running);
  draw_keyed(p, at.study, f.type.body, "S", theme().text, words);
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

void use_legend(FrameContext& f, const ChartView& v, const std::vector<Box>& places) {
  for (size_t i = 0; i < places.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (hit_area("family", places[i])) toggle_family(f.state.of<ChartState>(), v.families[i].name);
    ImGui::PopID();
  }
}

// Error and cost, and whether it is sound; beside them what they come from.
void draw_two_columns(Painter& p, const Box& box, const std::vector<Field>& fields, float px) {
  if (fields.size() < 5) return draw_fields(p, box, fields, px);
  const float middle = std::round(box.min.x + box.width() * 0.5f);
  draw_fields(p, {box.min, {middle - px, box.max.y}}, {fields[0], fields[1], fields[4]}, px);
  draw_fields(p, {{middle, box.min.y}, box.max}, {fields[2], fields[3]}, px);
}

void draw_words(FrameContext& f, Painter& p, const Box& box, const ChartView& v) {
  const ChartInput& in = chart_input(f);
  p.fill(box, theme().surface, 4);
  const Box room = box.inset(std::round(f.type.small * 0.6f));
  std::optional<size_t> row = in.current;
  std::string title = "Now";
  if (v.selected && v.selected != v.current) row = v.point(*v.selected).row, title = "Selected; Enter applies it";
  if (!row || *row >= in.rows.size()) {
    const char* text = in.measuring ? "The settings at hand are being measured."
                                    : "Point at a point, or choose one with the arrow keys, to read it here.";
    p.text_in(room, f.type.body, theme().text, text, true);
    return;
  }
  title += ":  " + row_title(in, *row);
  const bool now = row == in.current;
  const float height = std::min(room.height() * 0.34f, text_size(title, f.type.body, room.width()).y);
  p.text_in({room.min, {room.max.x, room.min.y + height}}, f.type.body, now ? theme().accent : theme().text, title,
            true);
  draw_two_columns(p, {{room.min.x, room.min.y + height + f.type.small * 0.3f}, room.max}, row_fields(in, v, *row),
                   f.type.body);
}

void draw_counts(FrameContext& f, Painter& p, const Box& box, const ChartView& v) {
  const ChartInput& in = chart_input(f);
  std::vector<Paragraph> lines{{counts_text(in, v), theme().text, f.type.small}};
  if (!in.note.empty()) lines.push_back({in.note, theme().accent, f.type.small});
  draw_paragraphs(p, box, lines, 1);
}

}  // namespace

void draw_chart(FrameContext& f, Painter& p, const Box& box) {
  const Box room = box.inset(std::round(12 * f.layout.unit));
  ChartView v = chart_view(f);
  const std::vector<LegendRow> legend = legend_rows(f.state.of<ChartState>(), v);
  const std::string family = fmt::format("by {}", family_paths()[f.state.of<ChartState>().family].label);
  const float family_width = key_cap_width("G", f.type.small) + text_size(family, f.type.small).x + f.type.small;
  const Places at = lay_out(room, f.type, family_width, legend, !chart_input(f).note.empty(),
                            f.type.body / f.layout.unit > kLargeType);
  Plot plot(p, at.plot, v.x, v.y, f.type.small);
  use_chart_mouse(f, plot, v);
  draw_head(f, p, at);
  draw_keyed(p, at.y_title, f.type.body, "Y", theme().text, fmt::format("↑ {}", axis_title(v.chart.y)));
  draw_chart_points(f, p, plot, v);
  draw_keyed(p, at.x_title, f.type.body, "X", theme().text, fmt::format("→ {}", axis_title(v.chart.x)));
  draw_counts(f, p, at.counts, v);
  draw_keyed(p, at.family, f.type.small, "G", theme().text, family);
  use_legend(f, v, draw_series_legend(p, at.legend, legend, f.type.small));
  draw_words(f, p, at.words, v);
  draw_panel_keys(f, p, at.keys, panel("chart").keys);
}

}  // namespace gbl::ui
