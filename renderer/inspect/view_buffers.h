#pragma once
// Which buffers the views show, and why some cannot be shown: what the rows of views.inc name.
#include <span>
#include <string>

#include "renderer/inspect/views.h"

namespace gbl {

// The first of these that is stored; else the sum of light, or what it became.
ViewSource in_first_of(std::span<const Stores>, const Settings&);
template <Stores... kInOrder>
ViewSource in_attachment(const Settings& s) {
  constexpr Stores kOrder[] = {kInOrder...};
  return in_first_of(kOrder, s);
}
ViewSource in_layouts_attachment(const Settings&);  // where the layout keeps what key 5 shows
ViewSource in_counter(const Settings&);
ViewSource in_ids(const Settings&);
ViewSource in_redrawn(const Settings&);
ViewSource in_no_buffer(const Settings&);
ViewSource in_shadow_maps(const Settings&);
ViewSource in_reference(const Settings&);
ViewSource in_comparison(const Settings&);

// Empty: nothing is missing.
std::string surface_missing(const Settings&);
std::string albedo_missing(const Settings&);
std::string material_missing(const Settings&);
std::string reflectance_missing(const Settings&);
std::string metal_missing(const Settings&);
std::string emission_missing(const Settings&);
std::string occlusion_missing(const Settings&);
std::string ambient_missing(const Settings&);
std::string exponent_missing(const Settings&);
std::string pixel_pairs_missing(const Settings&);
std::string cells_missing(const Settings&);
std::string split_light_missing(const Settings&);
std::string error_missing(const Settings&);
std::string shadows_missing(const Settings&);
std::string visibility_missing(const Settings&);  // of the picked light

// Why it cannot be laid over another view under these settings; empty: it can.
std::string why_not_over(View, const Settings&);

}  // namespace gbl
