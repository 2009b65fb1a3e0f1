#include "ui/key_spec.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gbl::ui {
namespace {

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const size_t space = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, space));
    text.remove_prefix(std::min(space + 1, text.size()));
  }
  return words;
}

// What is printed on the key of an event.
std::string printed(const std::string& key) {
  if (key == "=") return "+";  // the same key on most keyboards, without Shift
  if (key == "_") return "-";
  if (key.size() != 1) return key;
  return {static_cast<char>(std::toupper(static_cast<unsigned char>(key[0])))};
}

}  // namespace

KeySpec key_spec(std::string_view text) {
  constexpr std::string_view kCtrl = "Ctrl+";
  KeySpec out;
  out.ctrl = text.starts_with(kCtrl);
  if (out.ctrl) text.remove_prefix(kCtrl.size());
  for (const std::string_view word : words_of(text)) {
    if (word == "Shift")
      out.shift = true;
    else if (word.size() == 3 && word[1] == '-')
      for (char c = word[0]; c <= word[2]; ++c) out.keys.emplace_back(1, c);
    else
      out.keys.emplace_back(word);
  }
  return out;
}

std::optional<size_t> which_key(const KeySpec& spec, const KeyEvent& e) {
  if (e.ctrl != spec.ctrl || (spec.shift && !e.shift)) return {};
  const auto at = std::find(spec.keys.begin(), spec.keys.end(), printed(e.key));
  if (at == spec.keys.end()) return {};
  return static_cast<size_t>(at - spec.keys.begin());
}

KeyEvent as_in_table(const KeySpec& spec, size_t which, const KeyEvent& e) {
  return {spec.keys[which], e.shift, e.ctrl, e.repeat};
}

std::vector<std::string> key_caps(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> kArrows[] = {
      {"Left", "←"}, {"Right", "→"}, {"Up", "↑"}, {"Down", "↓"}};
  std::vector<std::string> caps;
  for (std::string_view cap : words_of(text)) {
    for (const auto& [name, arrow] : kArrows)
      if (cap == name) cap = arrow;
    caps.emplace_back(cap);
  }
  return caps;
}

std::string printed_keys(std::string_view text) { return fmt::format("{}", fmt::join(key_caps(text), " ")); }

}  // namespace gbl::ui
