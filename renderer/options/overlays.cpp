#include "renderer/options/overlays.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/number.h"

namespace gbl {
namespace {

auto place_of(const Overlays& overlays, std::string_view view) {
  return std::find_if(overlays.begin(), overlays.end(), [&](const Overlay& o) { return o.view == view; });
}

}  // namespace

const Overlay* find_overlay(const Overlays& overlays, std::string_view view) {
  const auto at = place_of(overlays, view);
  return at == overlays.end() ? nullptr : &*at;
}

void set_overlay(Overlays& overlays, std::string_view view, double opacity) {
  const auto at = place_of(overlays, view);
  if (opacity <= 0) {
    if (at != overlays.end()) overlays.erase(at);
  } else if (at != overlays.end()) {
    overlays[static_cast<size_t>(at - overlays.begin())].opacity = opacity;
  } else {
    overlays.push_back({std::string(view), opacity});
  }
}

std::string text_of(const Overlay& o) {
  return o.opacity == kOverlayOpacity ? o.view : fmt::format("{}:{}", o.view, o.opacity);
}

Overlay parse_overlay(std::string_view text, std::string_view where) {
  const size_t colon = text.find(':');
  Overlay out{std::string(text.substr(0, colon)), kOverlayOpacity};
  if (colon == std::string_view::npos) return out;
  const std::optional<double> opacity = decimal(text.substr(colon + 1));
  if (!opacity || !(*opacity > 0) || *opacity > 1)
    throw Error(ExitCode::bad_input, where, fmt::format("'{}' of '{}' is no opacity", text.substr(colon + 1), text),
                "write VIEW or VIEW:OPACITY with 0 < OPACITY <= 1; as wire:0.5");
  out.opacity = *opacity;
  return out;
}

}  // namespace gbl
