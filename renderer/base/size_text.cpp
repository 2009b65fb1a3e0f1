#include "renderer/base/size_text.h"

#include <fmt/format.h>

#include "renderer/base/number.h"

namespace gbl {
namespace {

std::optional<int> whole_number(std::string_view text) {
  const std::optional<long long> n = whole_decimal(text);
  return n && *n == static_cast<int>(*n) ? std::optional(static_cast<int>(*n)) : std::nullopt;
}

// `from` … `to`: the place of what stands between them.
std::optional<glm::ivec2> pair_of(std::string_view text, size_t from, size_t to) {
  if (from >= text.size() || to >= text.size()) return {};
  const std::optional<int> x = whole_number(text.substr(0, from)), y = whole_number(text.substr(to));
  return x && y ? std::optional(glm::ivec2(*x, *y)) : std::nullopt;
}

}  // namespace

std::string size_text(glm::ivec2 size) { return fmt::format("{}x{}", size.x, size.y); }

std::optional<glm::ivec2> size_of(std::string_view text) {
  const size_t cross = text.find('x');
  return cross == std::string_view::npos ? std::nullopt : pair_of(text, cross, cross + 1);
}

std::optional<glm::ivec2> pixel_of(std::string_view text) {
  constexpr std::string_view kBetween = " ,;x";
  const size_t first = std::min(text.find_first_not_of(' '), text.size());
  text = text.substr(first, text.find_last_not_of(' ') + 1 - first);
  const size_t from = text.find_first_of(kBetween);
  return pair_of(text, from, text.find_first_not_of(kBetween, from));
}

}  // namespace gbl
