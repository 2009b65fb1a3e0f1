#include "renderer/study/advice/advice_page.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/made_by.h"
#include "renderer/study/advice/axis_values.h"
#include "renderer/study/rows/row_words.h"

namespace gbl {
namespace {

std::string words_of(const std::vector<Assignment>& values) {
  std::string text;
  for (const Assignment& a : values) text += (text.empty() ? "" : " · ") + coordinate_words(a.path, a.value);
  return text.empty() ? "nothing lost" : text;
}

// The answer, the runner-up, and what else was measured.
std::vector<AdvisedSetup> setups_of(const Advice& advice) {
  std::vector<AdvisedSetup> out;
  const auto add = [&](const AdvisedSetup& s) {
    const auto is_it = [&](const AdvisedSetup& o) { return o.settings == s.settings; };
    if (std::none_of(out.begin(), out.end(), is_it)) out.push_back(s);
  };
  if (advice.best) add(*advice.best);
  if (advice.runner_up) add(*advice.runner_up);
  for (const AdvisedSetup& s : advice.measured) add(s);
  return out;
}

class AdviceRows {
 public:
  AdviceRows(const AdviceAsked& asked, const std::function<std::string(const Settings&)>& command, Page& page)
      : asked_(asked), command_(command), page_(page) {}

  void add(const AdvisedSetup& s, const std::string& what, bool chosen) {
    add({.words = words_of(setup_values(s.settings)), .command = command_(s.settings), .marked = chosen}, what, s.proof,
        std::isnan(s.cost) ? std::nullopt : std::optional(s.cost), s.bytes_per_pixel);
  }
  void add(const Tried& t, const std::string& what) {
    Settings s = lossless(asked_.truth, asked_.features);
    apply_values(s, t.values);
    add({.words = words_of(t.values), .unsound = unsound_words(s), .command = command_(s)}, what, t, {}, {});
  }

 private:
  static PageCell number(const std::optional<double>& v) {
    return v ? PageCell{fmt::format("{:.4g}", *v), *v} : PageCell{"–"};
  }
  void add(PageRow row, const std::string& what, const Tried& proof, std::optional<double> cost,
           std::optional<double> bytes) {
    row.cells = {{what},
                 number(cost),
                 number(bytes),
                 number(100 * proof.worst.share_over()),
                 number(255 * proof.worst.worst),
                 number(double(proof.camera))};
    for (const PageCell& c : row.cells) row.details.push_back(c.text);
    page_.rows.push_back(std::move(row));
  }
  const AdviceAsked& asked_;
  const std::function<std::string(const Settings&)>& command_;
  Page& page_;
};

// ---- the chart ------------------------------------------------------------------------------------------------------

// What decides how fast it is, or else how large.
const OptionValue* method_of(const std::vector<Assignment>& values) {
  for (const Assignment& a : values)
    if (a.path == "lights.method") return &a.value;
  return nullptr;
}

PageChart chart_of(const std::vector<AdvisedSetup>& setups, const Advice& advice, const AdviceAsked& asked) {
  const AdviceCostRow& cost = row(asked.cost);
  PageChart chart{.title = "The set-ups that were measured",
                  .note = "All of them hold the budget from every camera; the chosen one is ringed.",
                  .marked = "chosen"};
  std::vector<double> costs, shares;
  for (size_t i = 0; i < setups.size(); ++i) {
    const AdvisedSetup& s = setups[i];
    if (!std::isfinite(s.cost)) continue;
    const std::vector<Assignment> values = setup_values(s.settings);
    const OptionValue* method = method_of(values);
    const std::string family = method ? plain(*method) : "set-up";
    const auto known = std::find(chart.families.begin(), chart.families.end(), family);
    const auto index = static_cast<size_t>(known - chart.families.begin());
    if (known == chart.families.end()) chart.families.push_back(family);
    const bool chosen = advice.best && advice.best->settings == s.settings;
    costs.push_back(s.cost), shares.push_back(s.proof.worst.share_over());
    chart.points.push_back(
        {.x = s.cost,
         .y = shares.back(),
         .family = index,
         .words = fmt::format(
             "{}\ncost: {:.4g} {}\n{} bytes per pixel\n{:.3g} % of the pixels over, the worst by {:.3g} codes",
             words_of(values), s.cost, cost.unit, s.bytes_per_pixel, 100 * shares.back(), 255 * s.proof.worst.worst),
         .row = i,
         .label = chosen ? "chosen" : "",
         .sound = sound(s.settings),
         .marked = chosen});
  }
  chart.x = page_axis({.unit = cost.unit, .label = "cost"}, costs);
  chart.y = page_axis({.label = "pixels over the budget, from the worst camera", .share_of = "pixels"}, shares);
  return chart;
}

std::string budget_words(const ErrorBudget& b) {
  const std::string pixels =
      b.share_over > 0 ? fmt::format("{:.3g} % of the pixels", 100 * (1 - b.share_over)) : "all pixels";
  return fmt::format("{} within {:.3g}/255 of the reference as displayed", pixels, 255 * b.display_difference);
}

}  // namespace

Page advice_page(const Advice& advice, const AdviceAsked& asked, const Machine& machine,
                 const std::function<std::string(const Settings&)>& command) {
  Page page{.title = fmt::format("The cheapest set-up for {}", asked.truth.scene),
            .how_to_read =
                fmt::format("Asked for: {}. Cheapest by {}. Looked at from {} cameras.{}", budget_words(asked.budget),
                            row(asked.cost).id, kAdviceCameras, advice.stopped ? " Stopped before the answer." : ""),
            .rows_are = "What was tried",
            .marked = "chosen"};
  page.machine = {{"device", machine.device}, {"driver", machine.driver}, {"gbufferlab", made_by()}};
  page.columns = {{"what"},
                  {fmt::format("cost [{}]", row(asked.cost).unit)},
                  {"stored [bytes per pixel]"},
                  {"over the budget [%]", "share of the pixels, from the worst camera"},
                  {"worst pixel [codes of 255]"},
                  {"worst camera", "0: its own"}};
  for (const PageColumn& c : page.columns) page.details.push_back(c.title);
  const std::vector<AdvisedSetup> setups = setups_of(advice);
  AdviceRows rows(asked, command, page);
  for (const AdvisedSetup& s : setups) {
    const bool best = advice.best && s.settings == advice.best->settings;
    const bool second = advice.runner_up && s.settings == advice.runner_up->settings;
    rows.add(s, best ? "the answer" : second ? "the runner-up" : "measured", best);
  }
  for (const Tried& t : advice.rejected) rows.add(t, "does not hold together");
  for (const Tried& t : advice.values) rows.add(t, t.holds ? "alone, holds" : "alone, does not hold");
  page.charts.push_back(chart_of(setups, advice, asked));
  for (const std::string& l : advice.left_out) page.machine.emplace_back("left out", l);
  return page;
}

}  // namespace gbl
