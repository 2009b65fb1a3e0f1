#include "renderer/study/rows/row_words.h"

#include <fmt/format.h>
#include <set>

namespace gbl {
namespace {

const Option* option_or_null(std::string_view path) {
  for (const Option& o : options())
    if (o.path == path) return &o;
  return nullptr;
}

}  // namespace

std::string coordinate_words(const std::string& path, const OptionValue& value) {
  const Option* o = option_or_null(path);
  if (!o) return fmt::format("{}: {}", path == "lights" ? "Lights" : path == "preset" ? "Preset" : path, plain(value));
  if (o->kind == Kind::choice)
    for (const ValueRow& r : o->values)
      if (value == OptionValue(r.id)) return fmt::format("{}: {}", o->label, r.label);
  return fmt::format("{}: {}", o->label, plain(value));
}

std::string row_words(const StudyRow& row) {
  std::string text;
  for (const Assignment& a : row.at) text += (text.empty() ? "" : " · ") + coordinate_words(a.path, a.value);
  return text;
}

std::string unsound_words(const Settings& s) {
  std::set<std::string> pitfalls;  // two choices may share one
  for (const Unsound& u : unsound_choices(s)) pitfalls.insert(u.pitfall);
  return fmt::format("{}", fmt::join(pitfalls, ", "));
}

std::string noisy_words(const StudyRow& row, const StudyColumn& c) {
  return fmt::format("noisy: {:.3g} to {:.3g} {}", row.number(c.p10).value_or(0), row.number(c.p90).value_or(0),
                     c.unit);
}

}  // namespace gbl
