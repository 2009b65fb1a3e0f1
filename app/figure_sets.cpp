#include "app/figure_sets.h"

#include <fmt/format.h>

#include "renderer/base/json.h"
#include "renderer/inspect/views.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/pitfalls/catalogue.h"

namespace gbl {
namespace {

constexpr const char *kPitfalls = "pitfalls", *kPitfallsTitle = "Where methods fail, broken and fixed";

Json patch_json(const std::vector<Assignment>& patch) {
  Json out = Json::object();
  for (const Assignment& a : patch) out[a.path] = to_json(a.value);
  return out;
}

// One after the other; a later value stands in the place of an earlier one.
Json merged(std::initializer_list<const std::vector<Assignment>*> patches) {
  Json out = Json::object();
  for (const auto* patch : patches) out.update(patch_json(*patch));
  return out;
}

FigureSpec figure_of(const PitfallEntry& e) {
  Json panels = Json::array();
  for (const auto& [words, side] : {std::pair("broken", &e.broken), std::pair("fixed", &e.fixed)})
    panels.push_back({{"view", e.view}, {"words", words}, {"set", merged({&e.set, side})}});
  return parse_figure({{"id", e.id},
                       {"title", e.title},
                       {"caption", fmt::format("{} {} {}", e.symptom, e.cause, e.do_this)},
                       {"source", e.source},
                       {"size", {640, 360}},
                       {"preset", e.preset},
                       {"panels", std::move(panels)}},
                      kPitfalls);
}

FigureSet pitfall_figures() {
  FigureSet set{kPitfalls, kPitfalls, kPitfallsTitle, {}};
  for (const PitfallEntry& e : load_pitfalls()) set.figures.push_back(figure_of(e));
  return set;
}

// The views that the window's mosaic shows, by their keys.
Json mosaic(const Settings& s) {
  Json panels = Json::array();
  for (const ViewRow& v : views())
    if (std::string_view(v.key).size() == 1 && why_missing(v.view, s).empty())
      panels.push_back({{"view", v.id}, {"words", v.label}});
  return panels;
}

FigureSpec figure_of(const Lesson& lesson, size_t k) {
  const LessonStep& step = lesson.steps[k];
  const Settings s = settings_at(lesson, k);
  Json set = Json::object();
  const std::string view = view_at(lesson, k);
  for (size_t i = 0; i <= k; ++i) set.update(patch_json(lesson.steps[i].set));
  const bool large = step.large || needs_truth(view_by_id(view).view);
  return parse_figure({{"id", fmt::format("{}-{}", lesson.id, k + 1)},
                       {"title", fmt::format("{}, step {}", lesson.title, k + 1)},
                       {"caption", step.say},
                       {"size", large ? Json{960, 540} : Json{480, 270}},
                       {"columns", large ? 1 : 3},
                       {"letters", false},
                       {"preset", lesson.preset},
                       {"set", std::move(set)},
                       {"panels", large ? Json::array({{{"view", view}}}) : mosaic(s)}},
                      lesson.id);
}

}  // namespace

std::vector<FigureSetRow> figure_sets() {
  std::vector<FigureSetRow> out;
  for (const BuiltinFigures& b : builtin_figures()) out.push_back({b.id, b.title});
  out.push_back({kPitfalls, kPitfallsTitle});
  return out;
}

FigureSet figures_named(const std::string& name) {
  if (name == kPitfalls) return pitfall_figures();
  std::vector<std::string> names;
  for (const FigureSetRow& r : figure_sets()) names.push_back(r.name);
  return load_figures(name, names);
}

FigureSet figures_of(const Lesson& lesson) {
  FigureSet set{lesson.id, lesson.id, lesson.title, {}};
  for (size_t k = 0; k < lesson.steps.size(); ++k) set.figures.push_back(figure_of(lesson, k));
  return set;
}

}  // namespace gbl
