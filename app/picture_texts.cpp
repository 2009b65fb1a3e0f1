#include "app/picture_texts.h"

#include <fmt/format.h>

#include "renderer/base/made_by.h"
#include "renderer/options/options.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

// A text that would be read as a number or a list is written as JSON.
std::string as_typed(const OptionValue& value) {
  const std::string text = plain(value);
  return !text.empty() && parse_value(text, "value") == value ? text : written(value);
}

}  // namespace

std::string shell_quoted(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+.,:/@%";
  if (word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
  return out + "'";
}

std::string command_line(const std::string& command, const Settings& s) {
  const Settings loaded = setup_of({}).settings;
  std::string line = command;
  for (const Option& o : options())
    if (o.get(s) != o.get(loaded)) line += " --set " + shell_quoted(fmt::format("{}={}", o.path, as_typed(o.get(s))));
  return line;
}

PngText picture_texts(const std::string& command, const Settings& s, const Machine& machine) {
  return {{kSettingsKey, settings_text(s) + "\n"},
          {kVersionKey, made_by()},
          {kDriverKey, fmt::format("{}, OpenGL {}", machine.device, machine.driver)},
          {kCommandKey, command_line(command, s)}};
}

}  // namespace gbl
