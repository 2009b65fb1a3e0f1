#pragma once
// Which buffers the views show, and why some cannot be shown: what the rows of views.inc name.
#include <span>
#include <string>

#include "renderer/gbuffer/attachment.h"
#include "renderer/options/settings.h"

namespace gbl {

// The first of these that is stored, by name with format; else the sum of light, or what it became.
std::string in_first_of(std::span<const Stores>, const Settings&);
template <Stores... kInOrder>
std::string in_attachment(const Settings& s) {
  constexpr Stores kOrder[] = {kInOrder...};
  return in_first_of(kOrder, s);
}
std::string in_layouts_attachment(const Settings&);  // where the layout keeps what key 5 shows
std::string in_counter(const Settings&);
std::string in_reference(const Settings&);
std::string in_comparison(const Settings&);

// Empty: nothing is missing.
std::string surface_missing(const Settings&);
std::string albedo_missing(const Settings&);
std::string material_missing(const Settings&);
std::string split_light_missing(const Settings&);
std::string error_missing(const Settings&);

}  // namespace gbl
