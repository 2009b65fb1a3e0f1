#include "renderer/base/error.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace gbl {
namespace {

std::string one_line(std::string_view where, std::string_view what, std::string_view fix) {
  std::string line = where.empty() ? std::string(what) : fmt::format("{}: {}", where, what);
  if (!fix.empty()) line += fmt::format("; {}", fix);
  return line;
}

// Edit distance (Levenshtein 1966, "Binary codes capable of correcting deletions, insertions and reversals").
size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

Error::Error(ExitCode code, std::string_view where, std::string_view what, std::string_view fix)
    : std::runtime_error(one_line(where, what, fix)), code_(code) {}

std::string suggest(std::string_view given, const std::string_view* known, size_t count) {
  if (count == 0) return "no value is built yet";
  const auto* nearest = std::min_element(
      known, known + count, [&](auto a, auto b) { return edit_distance(given, a) < edit_distance(given, b); });
  // Further than half the word is no misspelling: then the list alone helps more.
  const bool close = edit_distance(given, *nearest) <= std::max<size_t>(2, nearest->size() / 2);
  return fmt::format("{}known: {}", close ? fmt::format("did you mean '{}'? ", *nearest) : "",
                     fmt::join(known, known + count, ", "));
}

}  // namespace gbl
