#include "renderer/base/number.h"

#include <algorithm>
#include <charconv>

#include "renderer/base/json.h"

namespace gbl {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Takes the digits at the front away; how many.
size_t take_digits(std::string_view& text) {
  const size_t count = static_cast<size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
  text.remove_prefix(count);
  return count;
}

bool take(std::string_view& text, std::string_view any_of) {
  if (text.empty() || any_of.find(text[0]) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

// RFC 8259, section 6; `whole`: its integer part alone.
bool is_decimal(std::string_view text, bool whole) {
  take(text, "-");
  const bool zero = !text.empty() && text[0] == '0';
  const size_t digits = take_digits(text);
  if (digits == 0 || (zero && digits > 1)) return false;
  if (whole) return text.empty();
  if (take(text, ".") && take_digits(text) == 0) return false;
  if (take(text, "eE")) {
    take(text, "+-");
    if (take_digits(text) == 0) return false;
  }
  return text.empty();
}

}  // namespace

// By the JSON library: not every standard library reads a double from characters without regard to the locale.
std::optional<double> decimal(std::string_view text) {
  if (!is_decimal(text, false)) return {};
  const Json number = Json::parse(text, nullptr, false);
  return number.is_number() ? std::optional(number.get<double>()) : std::nullopt;
}

std::optional<long long> whole_decimal(std::string_view text) {
  long long value = 0;
  const bool right =
      is_decimal(text, true) && std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
  return right ? std::optional(value) : std::nullopt;
}

}  // namespace gbl
