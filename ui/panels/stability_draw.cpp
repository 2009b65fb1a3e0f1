// The stability panel: one parameter moved through the place where a method breaks: a curve per method, and what is stated of each.
#include <algorithm>
#include <fmt/format.h>

#include "ui/panels/stability_view.h"

namespace gbl::ui {
namespace {

struct Places {
  Box head, sweep, help, y_title, plot, x_title, legend, stated, note, keys;
};

Places lay_out(const Box& room, const Type& t, const std::vector<LegendRow>& legend, const std::string& help,
               bool note) {
  Places p;
  const float body = line_height(t.body), small = line_height(t.small), gap = std::round(t.small * 0.4f);
  Shelf shelf{room, gap};
  p.head = shelf.below(line_height(t.large));
  p.sweep = shelf.below(body);
  p.help = shelf.below(std::min(text_size(help, t.small, room.width()).y, 0.1f * room.height()));
  p.y_title = shelf.below(body);
  p.keys = shelf.above(1.3f * small);
  if (note) p.note = shelf.above(small);
  p.stated = shelf.above(std::max(0.22f * room.height(), std::min(9 * small, 0.3f * room.height())));
  const float legend_height = series_legend_height(legend, room.width(), t.small);
  p.legend = legend.empty() ? Box{} : shelf.above(std::clamp(legend_height, small, 0.16f * room.height()));
  p.x_title = shelf.above(body);
  p.plot = shelf.room;
  return p;
}

std::string titled(const std::string& words, const char* unit) {
  return *unit ? fmt::format("{} ({})", words, unit) : words;
}

// Columns' help stands beside other columns elsewhere; alone it must say of what.
std::string metric_title(const SweepMetric& m) {
  const bool largest = std::string_view(m.help) == "largest";
  return fmt::format("↑ {}: {}{}", titled(m.id, m.unit), m.help, largest ? " of all pixels" : "");
}

std::string progress_text(const StabilityInput& in) {
  if (in.total == 0) return "";
  std::string text = fmt::format("{}/{} points", in.done, in.total);
  if (!in.running) return text;
  return text + (in.seconds_left ? fmt::format(", {:.0f} s left", *in.seconds_left + 0.5) : ", running");
}

// Is there a statement that does not hold? Only a sweep that is complete can say.
std::string outcome(const StabilityInput& in) {
  if (!in.result || in.done < in.total || in.total == 0) return "";
  size_t all = 0, holding = 0;
  for (const CurveResult& c : in.result->curves)
    for (const Judged& j : c.judged) ++all, holding += j.verdict.holds;
  return holding == all ? fmt::format("all {} statements hold", all)
                        : fmt::format("{} {} of {} statements DO NOT HOLD", kUnsoundSign, all - holding, all);
}

void draw_head(FrameContext& f, Painter& p, const Places& at) {
  const StabilityInput& in = stability_input(f);
  const Sweep& s = chosen_sweep(f);
  const std::string out = outcome(in), progress = progress_text(in) + (out.empty() ? "" : "; " + out);
  const bool fails = out.starts_with(kUnsoundSign);
  const float px = p.fit(progress, {at.head.width() * 0.7f, at.head.height()}, f.type.body, false);
  const float right = at.head.max.x - text_size(progress, px).x;
  p.text_in({at.head.min, {right - f.type.body, at.head.max.y}}, f.type.large, theme().accent, "Stability");
  p.text({right, at.head.min.y + (at.head.height() - px) / 2}, px, fails ? theme().unsound : theme().text, progress);
  if (in.total > 0) {
    const float y = at.head.max.y + 1, share = static_cast<float>(in.done) / static_cast<float>(in.total);
    p.fill({{at.head.min.x, y}, {at.head.max.x, y + 2}}, theme().raised);
    p.fill({{at.head.min.x, y}, {at.head.min.x + share * at.head.width(), y + 2}}, theme().accent);
  }
  draw_keyed(p, at.sweep, f.type.body, "S", theme().text,
             fmt::format("{}/{} “{}”: {}", f.state.of<StabilityState>().sweep + 1, sweeps().size(), s.id, s.label));
}

std::vector<LegendRow> legend_rows(const FrameContext& f) {
  std::vector<LegendRow> rows;
  const SweepResult* result = stability_input(f).result;
  if (!result || has_families(chosen_sweep(f))) return rows;
  for (size_t i = 0; i < result->curves.size(); ++i) {
    const std::string key = i < 8 ? std::to_string(i + 1) : i < 16 ? fmt::format("⇧{}", i - 7) : "";
    const CurveResult& c = result->curves[i];
    rows.push_back({key, c.curve, curve_look(i), curve_on(f.state.of<StabilityState>(), i) && c.not_drawn.empty()});
  }
  return rows;
}

// A click chooses a curve, as the arrow keys do; the chosen one is framed.
void use_legend(FrameContext& f, Painter& p, const std::vector<Box>& places) {
  for (size_t i = 0; i < places.size(); ++i) {
    if (i == f.state.of<StabilityState>().curve)
      p.outline({{places[i].min.x - 3, places[i].min.y - 1}, places[i].max}, theme().accent, 1);
    ImGui::PushID(static_cast<int>(i));
    if (hit_area("curve", places[i])) f.state.of<StabilityState>().curve = i;
    ImGui::PopID();
  }
}

// A statement's word and its colour.
std::pair<std::string, ImU32> mark_of(StatedLine::Mark m) {
  switch (m) {
    case StatedLine::Mark::holds: return {"✓ holds", theme().text};
    case StatedLine::Mark::fails: return {fmt::format("{} fails", kUnsoundSign), theme().unsound};
    case StatedLine::Mark::not_drawn: return {"– absent", theme().dim};
    case StatedLine::Mark::open: break;
  }
  return {"? stated", theme().dim};
}

// As many as there is room for, whole ones; of the others their number.
void draw_stated(FrameContext& f, Painter& p, const Box& box) {
  const std::vector<StatedLine> lines = stated_lines(f);
  p.fill(box, theme().surface, 4);
  const Box room = box.inset(std::round(f.type.small * 0.6f));
  const SweepResult* result = stability_input(f).result;
  if (!result) return;
  float px = f.type.small, left = 0;
  const auto text_of_line = [&](const StatedLine& l) {
    return fmt::format("{}: {}", result->curves[l.curve].curve, l.text);
  };
  const auto height = [&](const StatedLine& l) { return text_size(text_of_line(l), px, room.width() - left).y; };
  const auto measure = [&] {
    left = text_size("✓ stated", px).x + px * 0.8f;
    float sum = 0;  // of the selected curve's: they must fit
    for (const StatedLine& l : lines)
      if (l.curve == f.state.of<StabilityState>().curve) sum += height(l) + 2;
    return sum + line_height(px);
  };
  while (measure() > room.height() && px > kSmallestPx) px -= 1;
  float y = room.min.y;
  size_t drawn = 0;
  for (; drawn < lines.size(); ++drawn) {
    const StatedLine& l = lines[drawn];
    const bool selected = l.curve == f.state.of<StabilityState>().curve, last = drawn + 1 == lines.size();
    if (y + height(l) + (last ? 0 : line_height(px)) > room.max.y && !selected) break;
    const auto [word, colour] = mark_of(l.mark);
    p.text({room.min.x, y}, px, colour, word);
    const ImU32 ink = l.mark == StatedLine::Mark::fails ? theme().unsound : selected ? theme().accent : colour;
    y += p.text_in({{room.min.x + left, y}, room.max}, px, ink, text_of_line(l), true).y + 2;
  }
  if (drawn == lines.size()) return;
  size_t failing = 0;
  for (size_t i = drawn; i < lines.size(); ++i) failing += lines[i].mark == StatedLine::Mark::fails;
  const std::string more = fmt::format("{} more{}; ↑ ↓ bring a curve's to the top", lines.size() - drawn,
                                       failing > 0 ? fmt::format(", {} of them FAIL", failing) : "");
  p.text_in({{room.min.x + left, y}, {room.max.x, room.max.y + px}}, px, failing > 0 ? theme().unsound : theme().dim,
            more);
}

}  // namespace

void draw_stability(FrameContext& f, Painter& p, const Box& box) {
  const Box room = box.inset(std::round(12 * f.layout.unit));
  const Sweep& sweep = chosen_sweep(f);
  const std::vector<LegendRow> legend = legend_rows(f);
  const std::string& note = stability_input(f).note;
  const Places at = lay_out(room, f.type, legend, sweep.help, !note.empty());
  const SweepMetric& metric = sweep_metric(sweep.metric);
  draw_head(f, p, at);
  p.text_in(at.help, f.type.small, theme().dim, sweep.help, true);
  if (has_families(sweep)) {
    p.text_in(at.y_title, f.type.body, theme().text,
              "random configurations wrong (any pixel over 1/255), and of their lit pixels the share lost");
    draw_sweep_families(f, p, {at.plot.min, at.x_title.max});
  } else {
    p.text_in(at.y_title, f.type.body, theme().text, metric_title(metric));
    const SweepAxes axes = sweep_axes(f);
    Plot plot(p, at.plot, axes.x, axes.y, f.type.small);
    draw_sweep_curves(f, p, plot);
    p.text_in(at.x_title, f.type.body, theme().text, fmt::format("→ {}", titled(sweep.parameter, sweep.unit)));
    use_legend(f, p, draw_series_legend(p, at.legend, legend, f.type.small));
  }
  draw_stated(f, p, at.stated);
  if (!note.empty()) p.text_in(at.note, f.type.small, theme().accent, note);
  draw_panel_keys(f, p, at.keys, panel("stability").keys);
}

}  // namespace gbl::ui
