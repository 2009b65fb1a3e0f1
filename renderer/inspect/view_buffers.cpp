#include "renderer/inspect/view_buffers.h"

#include <fmt/format.h>

#include "renderer/frame/attachments.h"
#include "renderer/gbuffer/layouts.h"
#include "renderer/inspect/views.h"
#include "renderer/light/light_methods.h"

namespace gbl {
namespace {

// The buffer that an error is the error of.
View shown_by(ErrorOf of) {
  switch (of) {
    case ErrorOf::final: return View::final;
    case ErrorOf::lit: return View::lit;
    case ErrorOf::diffuse_light: return View::diffuse_light;
    case ErrorOf::specular_light: return View::specular_light;
    case ErrorOf::normal: return View::normal;
    case ErrorOf::position: return View::position;
    case ErrorOf::depth: return View::depth;
    case ErrorOf::albedo: return View::albedo;
    case ErrorOf::roughness: return View::material;
  }
  return View::lit;
}

}  // namespace

ViewSource in_first_of(std::span<const Stores> in_order, const Settings& s) {
  const std::vector<Attachment> all = attachments(s);
  const Attachment* a = nullptr;
  for (size_t i = 0; i < in_order.size() && !a; ++i) a = find(all, in_order[i]);
  if (!a) a = find(all, Stores::light);
  if (!a) a = find(all, Stores::lit);
  return {*a, ""};
}

ViewSource in_layouts_attachment(const Settings& s) {
  const Stores in_order[] = {layout_of(s).shows_stored, Stores::material};
  return in_first_of(in_order, s);
}

// Not part of the frame: a counter that is drawn only while somebody looks at it.
ViewSource in_counter(const Settings&) { return {{}, "counted apart, R32F 4 B"}; }

// Of the frame where the layout stores it, else drawn while somebody looks.
ViewSource in_ids(const Settings& s) {
  if (const std::vector<Attachment> all = attachments(s); const Attachment* a = find(all, Stores::id)) return {*a, ""};
  return {{}, "drawn apart, R32UI 4 B"};
}

ViewSource in_redrawn(const Settings&) { return {{}, "drawn apart, RGBA32F 16 B"}; }
ViewSource in_no_buffer(const Settings&) { return {{}, "drawn as it is"}; }

ViewSource in_shadow_maps(const Settings& s) {
  return {{}, fmt::format("shadow.depth {}", row(s.shadow.format).label)};
}

ViewSource in_reference(const Settings&) { return {{}, "worked out on the CPU, double"}; }

ViewSource in_comparison(const Settings& s) {
  return {{}, fmt::format("of {} against the reference", row(s.view.error.of).label)};
}

std::string surface_missing(const Settings& s) {
  if (shading_of(s.lights.method) != Shading::forward) return {};
  return "forward shading keeps no G-buffer and no light apart: surfaces are shaded as they are drawn";
}

std::string albedo_missing(const Settings& s) {
  if (shading_of(s.lights.method) == Shading::light_prepass)
    return "deferred lighting stores no albedo: materials are read when the geometry is drawn again";
  return surface_missing(s);
}

std::string material_missing(const Settings& s) {
  const LayoutRow& layout = layout_of(s);
  const bool stored = shading_of(s.lights.method) != Shading::deferred || layout.shows != MaterialView::nothing;
  return stored ? surface_missing(s) : layout.roughness_missing;
}

namespace {
// Of what a layout may keep or not: why it cannot be read back.
std::string unless_kept(const Settings& s, bool kept, std::string_view what) {
  if (std::string none = albedo_missing(s); !none.empty()) return none;
  return kept ? "" : fmt::format("the {} layout {}", layout_of(s).axis.id, what);
}
}  // namespace

std::string reflectance_missing(const Settings& s) {
  if (shading_of(s.lights.method) == Shading::light_prepass) return {};  // what its first pass keeps
  return unless_kept(s, layout_of(s).keeps.reflectance, "stores none: every surface reflects alike");
}
std::string metal_missing(const Settings& s) { return unless_kept(s, layout_of(s).keeps.metal, "stores no metal"); }
std::string emission_missing(const Settings& s) {
  return unless_kept(s, layout_of(s).keeps_emission, "stores no emission: nothing shines by itself");
}
std::string occlusion_missing(const Settings& s) {
  return unless_kept(s, layout_of(s).keeps.occlusion, "stores no occlusion: all ambient light arrives");
}
std::string ambient_missing(const Settings& s) {
  return unless_kept(s, layout_of(s).keeps.ambient, "stores no ambient colour: it follows from the albedo");
}
std::string exponent_missing(const Settings& s) {
  return unless_kept(s, layout_of(s).keeps.exponent,
                     "stores no exponent: it follows from the roughness, or is one for all");
}

std::string pixel_pairs_missing(const Settings& s) {
  if (shading_of(s.lights.method) != Shading::forward) return {};
  return "forward shading counts surfaces, hidden ones too: its count of a pixel says nothing of the one that is seen";
}

std::string cells_missing(const Settings& s) {
  if (s.lights.method == LightMethod::tiled || s.lights.method == LightMethod::clustered) return {};
  return fmt::format("the method '{}' has neither tiles nor clusters", row(s.lights.method).label);
}

std::string split_light_missing(const Settings& s) {
  if (shading_of(s.lights.method) == Shading::forward) return surface_missing(s);
  if (s.accumulation.targets == AccumulationTargets::split) return {};
  if (folds_light(s))
    return "the light pass finishes the picture and keeps no sums; accumulation.targets=split keeps diffuse and "
           "specular";
  return "all light goes into one target; accumulation.targets=split keeps diffuse and specular apart";
}

std::string why_not_over(View v, const Settings& s) {
  if (needs_truth(v))
    return fmt::format("{} is not laid over others: it needs the reference; compare A with the truth instead",
                       row(v).label);
  if (v == View::shadow_maps) return "shadow maps are not of the picture's pixels";
  return why_missing(v, s);
}

std::string shadows_missing(const Settings& s) {
  return s.shadows == Shadows::off ? "no light has a shadow: the option shadows is off" : "";
}
std::string visibility_missing(const Settings& s) {
  const std::string none = shadows_missing(s);
  return none.empty() ? surface_missing(s) : none;
}

std::string error_missing(const Settings& s) {
  const bool no_roughness = s.view.error.of == ErrorOf::roughness && !layout_of(s).stores_roughness();
  return no_roughness ? layout_of(s).roughness_missing : why_missing(shown_by(s.view.error.of), s);
}

}  // namespace gbl
