#include "renderer/base/error.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace gbl {
namespace {

// Bytes of the UTF-8 character at the front of the text; 0: it is none (RFC 3629).
size_t utf8_length(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const size_t length = first < 0x80 ? 1 : first >= 0xc2 && first < 0xe0 ? 2 : (first & 0xf0) == 0xe0 ? 3 : 0;
  const size_t wanted = first >= 0xf0 && first < 0xf5 ? 4 : length;
  if (wanted == 0 || text.size() < wanted) return 0;
  for (size_t i = 1; i < wanted; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  return wanted;
}

constexpr size_t kMostOfAPart = 300;  // bytes: a screen's width twice over; what a file holds can be of any length

std::string one_line(std::string_view place, std::string_view trouble, std::string_view fix) {
  const std::string where = printable(place, kMostOfAPart), what = printable(trouble, kMostOfAPart);
  std::string line = where.empty() ? what : fmt::format("{}: {}", where, what);
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

std::string printable(std::string_view text, size_t most) {
  std::string out;
  while (!text.empty()) {
    const size_t length = utf8_length(text);
    if (out.size() + std::max<size_t>(length, 1) > most) return out + "…";
    if (length == 0)
      out += '?';
    else if (length == 1 && (static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7f))
      out += ' ';
    else
      out += text.substr(0, length);
    text.remove_prefix(std::max<size_t>(length, 1));
  }
  return out;
}

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
