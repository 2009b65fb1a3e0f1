// expand(): a spec's products, laid out as cases with whole settings each.
#include <fmt/format.h>
#include <unordered_map>

#include "renderer/study/study_spec.h"

namespace gbl {
namespace {

// The n-th case of a product; its last path is the fastest.
std::vector<Coordinate> coordinates(const std::vector<PathValues>& product, size_t n) {
  std::vector<Coordinate> at(product.size());
  for (size_t i = product.size(); i-- > 0;) {
    const std::vector<OptionValue>& values = product[i].values;
    at[i] = {product[i].path, values[n % values.size()]};
    n /= values.size();
  }
  return at;
}

size_t size_of(const std::vector<PathValues>& product) {
  size_t cases = 1;
  for (const PathValues& axis : product) cases *= axis.values.size();
  return cases;
}

// A user's file stands in the place of a layout: whichever of the two varies takes the other's place in the base.
bool one_place(std::string_view a, std::string_view b) {
  const auto is_layout = [](std::string_view path) { return path == "layout" || path == "layout-file"; };
  return a == b || (is_layout(a) && is_layout(b));
}

// What varies goes over the base.
std::vector<Coordinate> over_base(const std::vector<Coordinate>& base, const std::vector<Coordinate>& at) {
  std::vector<Coordinate> all = at;
  for (const Coordinate& c : base) {
    bool given = false;
    for (const Coordinate& own : at) given |= one_place(own.path, c.path);
    if (!given) all.push_back(c);
  }
  return all;
}

std::string id_of(const std::vector<Coordinate>& at) {
  std::string id;
  for (const Coordinate& c : at) id += (id.empty() ? "" : " ") + text_of(c);
  return id.empty() ? "base" : id;
}

bool matches(const std::vector<PathValues>& rule, const std::vector<Coordinate>& all, const Settings& s) {
  for (const PathValues& member : rule) {
    const std::optional<OptionValue> value = value_at(member.path, all, s);
    bool one = false;
    for (const OptionValue& v : member.values) one |= v == value;
    if (!one) return false;
  }
  return true;
}

// Everything that has a say in the picture, as one text.
std::string drawn_as(const Settings& s) {
  std::string text;
  for (const Option& o : options())
    if (o.group != Group::view && in_use(o, s)) text += fmt::format("{}={};", o.path, written(o.get(s)));
  return text;
}

class Expansion {
 public:
  Expansion(const StudySpec& spec, const SceneFn& open, const DeviceLimits& limits)
      : spec_(spec), scenes_(open), limits_(limits) {
    plan_.study = spec.name;
  }
  void add(const std::vector<Coordinate>& at) {
    const std::vector<Coordinate> all = over_base(spec_.base, at);
    StudyCase c{id_of(at), gbl::settings_of(all, scenes_), at};
    for (size_t i = 0; i < spec_.skip.size(); ++i)
      if (matches(spec_.skip[i], all, c.settings))
        return leave_out(c, LeftOutBy::rule, fmt::format("rule {} of skip", i + 1));
    const std::vector<Problem> problems = validate(c.settings, limits_);
    if (!problems.empty())
      return leave_out(c, LeftOutBy::invalid,
                       fmt::format("{}: {} [{}]", problems[0].path, problems[0].sentence, gbl::id_of(problems[0].id)));
    const auto [first, is_new] = first_.emplace(drawn_as(c.settings), plan_.cases.size());
    if (!is_new)
      return leave_out(c, LeftOutBy::duplicate, fmt::format("it is drawn as '{}' is", plan_.cases[first->second].id));
    plan_.cases.push_back(std::move(c));
  }
  StudyPlan take() { return std::move(plan_); }

 private:
  void leave_out(const StudyCase& c, LeftOutBy by, std::string reason) {
    plan_.left_out.push_back({c.id, by, std::move(reason)});
  }
  const StudySpec& spec_;
  SceneCache scenes_;
  const DeviceLimits& limits_;
  std::unordered_map<std::string, size_t> first_;  // by drawn_as(): looked up only, so its order is in no result
  StudyPlan plan_;
};

}  // namespace

StudyPlan expand(const StudySpec& spec, const SceneFn& open, const DeviceLimits& limits) {
  Expansion expansion(spec, open, limits);
  if (spec.permute.empty()) expansion.add({});
  for (const std::vector<PathValues>& product : spec.permute)
    for (size_t n = 0; n < size_of(product); ++n) expansion.add(coordinates(product, n));
  return expansion.take();
}

}  // namespace gbl
