#include "renderer/options/view_look.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/number.h"

namespace gbl {
namespace {

constexpr const char* kForm =
    "write VIEW and any of :fit or :BLACK..WHITE, :CHANNELS of r g b, a colour map (:grey :viridis :magma :turbo "
    ":diverging), :srgb or :linear, or :raw alone; as depth:400..600:viridis";

// Of r, g, b, each once and in this order.
bool names_channels(std::string_view text) {
  size_t from = 0;
  for (const char c : text) {
    const size_t at = std::string_view("rgb").find(c, from);
    if (at == std::string_view::npos) return false;
    from = at + 1;
  }
  return !text.empty();
}

std::optional<glm::dvec2> range_of(std::string_view text) {
  const size_t dots = text.find("..");
  if (dots == std::string_view::npos) return {};
  const std::optional<double> black = decimal(text.substr(0, dots)), white = decimal(text.substr(dots + 2));
  if (!black || !white) return {};
  return glm::dvec2(*black, *white);
}

std::optional<ColourMap> map_of(std::string_view text) {
  for (const ValueRow& r : rows<ColourMap>())
    if (r.value != static_cast<int>(ColourMap::own) && text == r.id) return static_cast<ColourMap>(r.value);
  return {};
}

// False: the part means nothing, or what it says was said before.
bool take_part(std::string_view part, ViewLook& look) {
  if (look.raw) return false;  // the codes are shown as they are
  if (part == "raw") return look.raw = look.plain();
  const bool ranged = look.fit || look.range;
  if (part == "fit") return !std::exchange(look.fit, true) && !ranged;
  if (const std::optional<glm::dvec2> range = range_of(part)) {
    look.range = range;
    return !ranged && range->x != range->y;
  }
  if (part == "srgb" || part == "linear") return !std::exchange(look.coded, part == "srgb").has_value();
  if (names_channels(part)) return std::exchange(look.channels, std::string(part)) == "rgb";
  if (const std::optional<ColourMap> map = map_of(part)) return std::exchange(look.map, *map) == ColourMap::own;
  return false;
}

auto place_of(Looks& looks, std::string_view view) {
  return std::lower_bound(looks.begin(), looks.end(), view,
                          [](const LookOf& l, std::string_view id) { return l.view < id; });
}

}  // namespace

ViewLook look_of(const Looks& looks, std::string_view view) {
  for (const LookOf& l : looks)
    if (l.view == view) return l.look;
  return {};
}

void set_look(Looks& looks, std::string_view view, ViewLook look) {
  auto at = place_of(looks, view);
  const bool there = at != looks.end() && at->view == view;
  if (look.plain()) {
    if (there) looks.erase(at);
  } else if (there) {
    at->look = std::move(look);
  } else {
    looks.insert(at, {std::string(view), std::move(look)});
  }
}

std::string text_of(const LookOf& l) {
  std::string text = l.view;
  if (l.look.fit) text += ":fit";
  if (l.look.range) text += fmt::format(":{}..{}", l.look.range->x, l.look.range->y);
  if (l.look.channels != "rgb") text += ":" + l.look.channels;
  if (l.look.map != ColourMap::own) text += fmt::format(":{}", row(l.look.map).id);
  if (l.look.raw) text += ":raw";
  if (l.look.coded) text += *l.look.coded ? ":srgb" : ":linear";
  return text;
}

LookOf parse_look(std::string_view text, std::string_view where) {
  const std::string_view all = text;
  LookOf out;
  out.view = text.substr(0, text.find(':'));
  text.remove_prefix(out.view.size());
  while (!text.empty()) {
    text.remove_prefix(1);
    const std::string_view part = text.substr(0, text.find(':'));
    if (!take_part(part, out.look))
      throw Error(ExitCode::bad_input, where, fmt::format("'{}' of '{}' is no look of a view", part, all), kForm);
    text.remove_prefix(part.size());
  }
  return out;
}

}  // namespace gbl
