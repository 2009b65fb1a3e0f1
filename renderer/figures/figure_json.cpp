#include "renderer/figures/figure_json.h"

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/json.h"

namespace gbl {
namespace {

[[noreturn]] void refuse(std::string_view where, const char* member, const Json& value, const std::string& wanted) {
  throw Error(ExitCode::bad_input, where, fmt::format("\"{}\" is {}, not {}", member, value.dump(), wanted));
}

}  // namespace

bool flag_member(const Json& node, const char* member, bool otherwise, std::string_view where) {
  if (!node.contains(member)) return otherwise;
  if (!node[member].is_boolean()) refuse(where, member, node[member], "true or false");
  return node[member].get<bool>();
}

double number_member(const Json& node, const char* member, double otherwise, double least, double most,
                     std::string_view where) {
  if (!node.contains(member)) return otherwise;
  const Json& value = node[member];
  if (!value.is_number() || !(value.get<double>() >= least && value.get<double>() <= most))
    refuse(where, member, value, fmt::format("a number from {} to {}", least, most));
  return value.get<double>();
}

int whole_member(const Json& node, const char* member, int otherwise, int least, int most, std::string_view where) {
  if (node.contains(member) && !node[member].is_number_integer())
    refuse(where, member, node[member], fmt::format("a whole number from {} to {}", least, most));
  return static_cast<int>(number_member(node, member, otherwise, least, most, where));
}

glm::dvec2 place_member(const Json& node, const char* member, glm::dvec2 otherwise, std::string_view where) {
  if (!node.contains(member)) return otherwise;
  const Json& value = node[member];
  const auto inside = [](const Json& n) { return n.is_number() && n.get<double>() >= 0 && n.get<double>() <= 1; };
  if (!value.is_array() || value.size() != 2 || !inside(value[0]) || !inside(value[1]))
    refuse(where, member, value, "two numbers from 0 to 1, across and down");
  return {value[0].get<double>(), value[1].get<double>()};
}

}  // namespace gbl
