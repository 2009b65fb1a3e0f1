#include "renderer/study/study_axes.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <sstream>

#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/base/limits.h"
#include "renderer/base/number.h"
#include "renderer/options/presets.h"

namespace gbl {
namespace {

constexpr const char* kWhere = "--axes";

struct AxisValues {
  std::string path;
  std::vector<std::string> ids;
};

std::vector<std::string> preset_ids() {
  std::vector<std::string> ids;
  for (const Preset& p : presets()) ids.emplace_back(p.id);
  return ids;
}

// Options with a list of values, and presets.
std::vector<std::string> values_of(const std::string& path) {
  if (path == "preset") return preset_ids();
  std::vector<std::string> ids;
  for (const Option& o : options())
    if (path == o.path && o.kind == Kind::choice)
      for (const ValueRow& r : o.values) ids.emplace_back(r.id);
  return ids;
}

AxisValues axis_of(const std::string& path) {
  try {
    check_path(path);
  } catch (const Error& e) {
    throw Error(e.code(), kWhere, e.what());
  }
  AxisValues axis{path, values_of(path)};
  if (axis.ids.empty())
    throw Error(ExitCode::bad_input, kWhere, fmt::format("{} has no list of values", path),
                "name options that are choices (list options), or write a spec with the values you want");
  return axis;
}

std::vector<AxisValues> parse_axes(std::string_view text) {
  std::vector<AxisValues> axes;
  std::istringstream parts{std::string(text)};
  for (std::string part; std::getline(parts, part, ',');) {
    const auto is_it = [&](const AxisValues& a) { return a.path == part; };
    if (std::any_of(axes.begin(), axes.end(), is_it))
      throw Error(ExitCode::bad_input, kWhere, fmt::format("{} stands twice", part), "leave one out");
    axes.push_back(axis_of(part));
  }
  if (axes.empty())
    throw Error(ExitCode::bad_input, kWhere, "names no option",
                "write names with commas, e.g. normal.encoding,depth.format");
  if (axes.size() > kMostStudyAxes)
    throw Error(ExitCode::bad_input, kWhere, fmt::format("names {} options", axes.size()),
                fmt::format("name at most {}", kMostStudyAxes));
  return axes;
}

Json product_of(const std::vector<AxisValues>& axes, size_t members) {
  Json product = Json::object();
  for (size_t i = 0; i < axes.size(); ++i)
    if (members >> i & 1) product[axes[i].path] = axes[i].ids;
  return product;
}

size_t size_of(size_t members) { return static_cast<size_t>(std::popcount(members)); }

// Subsets as bits: by their size, and of a size those with the first axes first.
std::vector<size_t> subsets(size_t axes) {
  std::vector<size_t> all;
  for (size_t members = 1; members < size_t{1} << axes; ++members) all.push_back(members);
  std::stable_sort(all.begin(), all.end(), [](size_t a, size_t b) { return size_of(a) < size_of(b); });
  return all;
}

std::string joined(const std::vector<AxisValues>& axes, const char* between) {
  std::string text;
  for (const AxisValues& a : axes) text += (text.empty() ? "" : between) + a.path;
  return text;
}

double seconds_in(char unit) { return unit == 's' ? 1 : unit == 'm' ? 60 : unit == 'h' ? 3600 : 0; }

}  // namespace

StudySpec study_of_axes(std::string_view comma_separated) {
  const std::vector<AxisValues> axes = parse_axes(comma_separated);
  Json permute = Json::array();
  for (const size_t members : subsets(axes.size())) permute.push_back(product_of(axes, members));
  const Json json = {
      {"version", 1},       {"name", joined(axes, "+")}, {"label", "Every value of " + joined(axes, ", ")},
      {"permute", permute}, {"y", "over_1_255_display"}, {"family", axes.front().path}};
  return parse_study(json.dump(), kWhere);
}

double parse_duration(std::string_view text, std::string_view where) {
  double seconds = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const size_t end = rest.find_first_of("smh");
    const std::optional<double> n = end == std::string_view::npos ? std::nullopt : decimal(rest.substr(0, end));
    if (!n || *n < 0) {
      seconds = 0;
      break;
    }
    seconds += *n * seconds_in(rest[end]);
    rest.remove_prefix(end + 1);
  }
  if (!(seconds > 0))
    throw Error(ExitCode::bad_input, where, fmt::format("'{}' is not a time", text), "write e.g. 90s, 10m or 1h30m");
  return seconds;
}

}  // namespace gbl
