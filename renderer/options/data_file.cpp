#include "renderer/options/data_file.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/json.h"
#include "renderer/base/resources.h"

namespace gbl {
namespace {
constexpr std::string_view kEnding = ".json";
}

std::string data_file_name(std::string_view folder, std::string_view id) {
  return fmt::format("{}{}{}", folder, id, kEnding);
}

std::vector<std::string> data_file_ids(std::string_view folder) {
  std::vector<std::string> ids;
  for (std::string_view name : resource_names(folder)) {
    if (!name.ends_with(kEnding)) continue;
    name.remove_prefix(folder.size());
    name.remove_suffix(kEnding.size());
    ids.emplace_back(name);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

void only_members(const Json& node, std::initializer_list<std::string_view> known, std::string_view where) {
  if (!node.is_object()) throw Error(ExitCode::bad_input, where, "must be a JSON object");
  for (const auto& [key, value] : node.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw Error(ExitCode::bad_input, where, fmt::format("unknown member \"{}\"", key),
                  suggest(key, known.begin(), known.size()));
}

std::string text_member(const Json& node, const char* member, std::string_view where) {
  if (!node.contains(member)) return {};
  const Json& value = node[member];
  if (!value.is_string())
    throw Error(ExitCode::bad_input, where, fmt::format("\"{}\" is {}, not a text in quotes", member, value.dump()));
  return value.get<std::string>();
}

std::string needed_text_member(const Json& node, const char* member, std::string_view where) {
  std::string value = text_member(node, member, where);
  if (value.empty()) throw Error(ExitCode::bad_input, where, fmt::format("\"{}\" is missing or empty", member));
  return value;
}

int order_member(const Json& node, const char* member, int otherwise, std::string_view where) {
  if (!node.contains(member)) return otherwise;
  const Json& order = node[member];
  if (!order.is_number_integer() || order.get<long long>() < 1 || order.get<long long>() > 9999)
    throw Error(ExitCode::bad_input, where,
                fmt::format("\"{}\" is {}, not a whole number from 1 to 9999", member, order.dump()));
  return order.get<int>();
}

void check_file_version(const Json& json, int newest, std::string_view kind, std::string_view where) {
  if (!json.contains("version")) throw Error(ExitCode::bad_input, where, fmt::format("no \"version\": not a {}", kind));
  const Json& version = json["version"];
  if (!version.is_number_integer() || version.get<long long>() < 1)
    throw Error(ExitCode::bad_input, where, fmt::format("version {} is not a whole number from 1", version.dump()));
  if (version.get<long long>() > newest)
    throw Error(ExitCode::bad_input, where,
                fmt::format("written for a newer program: version {}, this one reads up to {}", version.dump(), newest),
                "update the program");
}

}  // namespace gbl
