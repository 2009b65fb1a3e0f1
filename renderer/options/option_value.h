#pragma once
// What an option is set to: a number, a text (ids among them), or a list of these. JSON becomes one, and one becomes
// JSON, in settings_json.cpp; nothing in between knows of it.
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace gbl {

// Equal by its value; `whole` says how it is written: 64, not 64.0.
struct Number {
  Number() = default;
  template <class T>
  requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) Number(T v)
      : value(static_cast<double>(v)), whole(std::is_integral_v<T>) {}
  bool operator==(const Number& other) const { return value == other.value; }
  double value = 0;
  bool whole = false;
};

// What no option takes (true, null, an object), as it was written: for the refusal.
struct Unfit {
  std::string written;
  bool operator==(const Unfit&) const = default;
};

struct OptionValue;
using OptionList = std::vector<OptionValue>;
struct OptionValue : std::variant<Number, std::string, Unfit, OptionList> {
  using variant::variant;
};

// As a settings file has it: "volumes" in quotes, 64, 0.5, [1.0, 2.0]. Bytes that are not UTF-8 are replaced.
std::string written(const OptionValue&);
std::string plain(const OptionValue&);  // a text without its quotes
bool writable(const std::string&);      // false: not UTF-8, and no file of settings could hold it

}  // namespace gbl
