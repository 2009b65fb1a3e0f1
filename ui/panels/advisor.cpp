// F7: the cheapest set-up that holds an error budget: the question, the answer, and what it leaves out and why.
#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "renderer/base/size_text.h"
#include "ui/panels/side_panel.h"

namespace gbl::ui {
namespace {

struct AdvisorState : PanelState {
  double codes = 1;  // of 255
  bool every_pixel = false;
  size_t cost = 1;                 // of the costs' table: bytes
  size_t first = 0, shown = 0;     // of what is left out: the first on screen, and how many in the last frame
  bool run = false, stop = false;  // asked for in this frame
};

constexpr double kLeastCodes = 0.125, kMostCodes = 16;
constexpr double kShareOver = 0.001;

const AdvisorInput& advisor_input(const FrameContext& f) {
  static const AdvisorInput kNone;
  return f.input.advisor ? *f.input.advisor : kNone;
}

ErrorBudget budget_of(const AdvisorState& s) { return {s.codes / 255, s.every_pixel ? 0 : kShareOver}; }

// ---- keys ----------------------------------------------------------------------------------------------------------
void step_codes(FrameContext& f, const KeyEvent& e) {
  double& codes = f.state.of<AdvisorState>().codes;
  codes = std::clamp(codes * (e.key == "[" ? 0.5 : 2), kLeastCodes, kMostCodes);
}

void toggle_pixels(FrameContext& f, const KeyEvent&) {
  f.state.of<AdvisorState>().every_pixel = !f.state.of<AdvisorState>().every_pixel;
}

void step_cost(FrameContext& f, const KeyEvent& e) {
  const size_t n = std::size(kAdviceCosts);
  f.state.of<AdvisorState>().cost = (f.state.of<AdvisorState>().cost + (e.shift ? n - 1 : 1)) % n;
}

void run_or_stop(FrameContext& f, const KeyEvent&) {
  AdvisorState& s = f.state.of<AdvisorState>();
  s.stop = advisor_input(f).running, s.run = !s.stop;
  if (s.run) s.first = 0;
}

// How it is drawn, and nothing of what is true: camera, scene and lights stay.
void apply_method(Settings& s, const Settings& from) {
  for (const Option& o : options())
    if (o.group == Group::method) o.set(s, o.get(from), o);
}

void apply_advice(FrameContext& f, const KeyEvent& e) {
  const std::optional<Advice>& a = advisor_input(f).advice;
  const std::optional<AdvisedSetup>& wanted = !a ? std::nullopt : e.shift ? a->runner_up : a->best;
  if (!wanted) return say(f, {a ? "There is no such set-up." : "There is no advice yet: R looks for it.", ""});
  edit(f, [&](Settings& s) { apply_method(s, wanted->settings); });
}

void scroll(FrameContext& f, const KeyEvent& e) {
  AdvisorState& s = f.state.of<AdvisorState>();
  const std::optional<Advice>& a = advisor_input(f).advice;
  const size_t by = std::max<size_t>(1, s.shown), n = a ? a->left_out.size() : 0;
  if (e.key == "PgUp")
    s.first -= std::min(s.first, by);
  else if (s.first + by < n)
    s.first += by;
}

constexpr PanelKey kKeys[] = {
    {"R", "look for it, or stop", run_or_stop},
    {"[ ]", "budget", step_codes, true},
    {"B", "in how many pixels", toggle_pixels},
    {"X", "cost", step_cost},
    {"Enter", "apply the best (Shift: the runner-up)", apply_advice},
    {"PgUp PgDn", "what is left out", scroll, true},
    {"F7", "close", nullptr},
};

// ---- words ---------------------------------------------------------------------------------------------------------
std::string budget_words(const ErrorBudget& b) {
  const double codes = 255 * b.display_difference;
  return fmt::format("at most {:g} code{} of 255 off in {}", codes, codes > 1 ? "s" : "",
                     b.share_over > 0 ? "99.9 % of the pixels" : "every pixel");
}

const char* cost_words(AdviceCost c) {
  switch (c) {
    case AdviceCost::time: return "time of a frame";
    case AdviceCost::bytes: return "bytes per pixel";
    case AdviceCost::pairs: break;
  }
  return "pairs of pixel and light, shaded or tested";
}

// As the options are called: "Layout: Split;  Normal: oct8".
std::string setup_words(const Settings& s) {
  std::string out;
  for (const Assignment& a : setup_values(s)) {
    const Option& o = option(a.path);
    out += fmt::format("{}{}: {}", out.empty() ? "" : ";  ", o.label, value_text(o, s));
  }
  return out;
}

std::string proof_words(const Tried& t) {
  const BoundCheck& b = t.worst;
  return fmt::format("worst from {}: {:.2f} codes at pixel {}, {}; {} of {} pixels are over the bound",
                     t.camera == 0 ? "this camera" : fmt::format("seeded camera {}", t.camera), 255 * b.worst,
                     b.worst_pixel.x, b.worst_pixel.y, b.over, b.compared);
}

// ---- panel ---------------------------------------------------------------------------------------------------------
void draw_head(FrameContext& f, Painter& p, Box& room) {
  const AdvisorState& s = f.state.of<AdvisorState>();
  const AdvisorInput& in = advisor_input(f);
  const float body = line_height(f.type.body), gap = std::round(f.type.small * 0.4f);
  Shelf shelf{room, gap};
  p.text_in(shelf.below(line_height(f.type.large)), f.type.large, theme().accent,
            "Advisor: the cheapest set-up within a budget");
  const auto keyed = [&](const char* key, ImU32 colour, const std::string& words) {
    draw_keyed(p, shelf.below(body), f.type.body, key, colour, words);
  };
  keyed("[ ]", theme().text,
        fmt::format("at most {:g} code{} of 255 off, as displayed", s.codes, s.codes > 1 ? "s" : ""));
  keyed("B", theme().text, s.every_pixel ? "in every pixel" : "in 99.9 % of the pixels");
  keyed("X", theme().text, fmt::format("cheapest by {}", cost_words(kAdviceCosts[s.cost].cost)));
  const std::string scope =
      fmt::format("Scene, camera and lights stay as they are; judged from this camera and {} seeded ones at {}.",
                  kAdviceCameras - 1, size_text(in.size));
  const auto wrapped = [&](ImU32 colour, const std::string& text) {
    const float height = std::min(text_size(text, f.type.small, room.width()).y, 2.6f * line_height(f.type.small));
    p.text_in(shelf.below(height), f.type.small, colour, text, true);
  };
  wrapped(theme().dim, scope);
  if (in.running) {
    keyed("R", theme().accent, fmt::format("looking: {} tried; R stops", in.tried));
    wrapped(theme().text, "now: " + in.progress);
  } else {
    keyed("R", theme().accent, in.advice ? "looks again" : "looks for it: a minute or two, and the window goes on");
  }
  if (!in.note.empty()) wrapped(theme().accent, in.note);
  room = shelf.room;
}

bool is_applied(const FrameContext& f, const AdvisedSetup& a) {
  Settings s = f.settings;
  apply_method(s, a.settings);
  return s == f.settings;
}

// What the box of a set-up would like to have.
float setup_height(const FrameContext& f, const AdvisedSetup& a, float width) {
  const float inset = std::round(f.type.small * 0.6f), room = width - 2 * inset;
  return 2 * inset + line_height(f.type.body) + 2 + text_size(setup_words(a.settings), f.type.body, room).y +
         text_size(proof_words(a.together.value_or(a.proof)), f.type.small, room).y + f.type.small;
}

void draw_setup(FrameContext& f, Painter& p, const Box& box, const char* title, const char* key,
                const AdvisedSetup& a) {
  const AdviceCostRow& cost = row(advisor_input(f).cost);
  p.fill(box, theme().surface, 4);
  const Box room = box.inset(std::round(f.type.small * 0.6f));
  std::string head = fmt::format("{}: {:.4g} {}", title, a.cost, cost.unit);
  if (cost.cost != AdviceCost::bytes) head += fmt::format(", {} bytes per pixel", a.bytes_per_pixel);
  const bool applied = is_applied(f, a);
  const std::string how = applied ? "✓ applied" : fmt::format("{} applies it", key);
  const float right = text_size(how, f.type.small).x, line = line_height(f.type.body);
  p.text_in({room.min, {room.max.x - right - f.type.body, room.min.y + line}}, f.type.body, theme().accent, head);
  p.text({room.max.x - right, room.min.y + 1}, f.type.small, applied ? theme().text : theme().dim, how);
  draw_paragraphs(p, {{room.min.x, room.min.y + line + 2}, room.max},
                  {{setup_words(a.settings), theme().text, f.type.body},
                   {proof_words(a.together.value_or(a.proof)), theme().dim, f.type.small}},
                  f.type.small * 0.3f);
}

// Whole sentences from the first chosen one on, as many as there is room for.
void draw_left_out(FrameContext& f, Painter& p, const Box& room, const std::vector<std::string>& all) {
  AdvisorState& s = f.state.of<AdvisorState>();
  s.first = std::min(s.first, all.empty() ? 0 : all.size() - 1);
  const float head = line_height(f.type.body), px = f.type.small;
  float y = room.min.y + head + 2;
  size_t end = s.first;
  for (; end < all.size(); ++end) {
    const float height = text_size(all[end], px, room.width() - px).y;
    if (y + height > room.max.y && end > s.first) break;
    p.text({room.min.x, y}, px, theme().dim, "•");
    p.text_in({{room.min.x + px, y}, {room.max.x, std::max(room.max.y, y + px * 3)}}, px, theme().text, all[end], true);
    y += height + 3;
  }
  s.shown = end - s.first;
  std::string title = "Left out, and why";
  if (s.shown < all.size()) title += fmt::format("  ({}–{} of {}; PgUp PgDn)", s.first + 1, end, all.size());
  p.text_in({room.min, {room.max.x, room.min.y + head}}, f.type.body, theme().accent, title);
}

void draw_answer(FrameContext& f, Painter& p, Box room) {
  const AdvisorInput& in = advisor_input(f);
  const float gap = std::round(f.type.small * 0.5f), line = line_height(f.type.small);
  const std::string asked = fmt::format("Answer for {}, by {}:", budget_words(in.budget), cost_words(in.cost));
  const bool other = in.budget.display_difference != budget_of(f.state.of<AdvisorState>()).display_difference ||
                     in.budget.share_over != budget_of(f.state.of<AdvisorState>()).share_over ||
                     in.cost != kAdviceCosts[f.state.of<AdvisorState>().cost].cost;
  p.text_in({room.min, {room.max.x, room.min.y + line}}, f.type.small, other ? theme().accent : theme().dim, asked);
  room.min.y += line + gap;
  const auto box = [&](float share, const AdvisedSetup& a) {
    const float height = std::min(share * room.height(), setup_height(f, a, room.width()));
    const Box b{room.min, {room.max.x, room.min.y + height}};
    room.min.y = b.max.y + gap;
    return b;
  };
  if (in.advice->best) draw_setup(f, p, box(0.33f, *in.advice->best), "Cheapest", "Enter", *in.advice->best);
  if (in.advice->runner_up)
    draw_setup(f, p, box(0.48f, *in.advice->runner_up), "Runner-up", "Shift+Enter", *in.advice->runner_up);
  if (!in.advice->left_out.empty()) draw_left_out(f, p, room, in.advice->left_out);
}

void draw_advisor(FrameContext& f, Painter& p, const Box& box) {
  Box room = box.inset(std::round(12 * f.layout.unit));
  const float keys = 2.6f * line_height(f.type.small);
  draw_panel_keys(f, p, {{room.min.x, room.max.y - keys}, room.max}, kKeys);
  room.max.y -= keys + f.type.small * 0.4f;
  draw_head(f, p, room);
  if (advisor_input(f).advice) draw_answer(f, p, room);
}

void ask(FrameContext& f) {
  AdvisorState& s = f.state.of<AdvisorState>();
  f.requests.advisor = {s.open, budget_of(s), kAdviceCosts[s.cost].cost, std::exchange(s.run, false),
                        std::exchange(s.stop, false)};
}

}  // namespace

extern const Panel kAdvisorPanel = {.key = "F7",
                                    .id = "advisor",
                                    .help = "the cheapest set-up that holds an error budget",
                                    .place = Place::beside,
                                    .box = side_box,
                                    .draw = draw_advisor,
                                    .keys = kKeys,
                                    .make = make_panel_state<AdvisorState>,
                                    .update = ask};

}  // namespace gbl::ui
