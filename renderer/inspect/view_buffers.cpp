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
  const Stores in_order[] = {facts(s.layout).shows_stored, Stores::material};
  return in_first_of(in_order, s);
}

// Not part of the frame: a counter that is drawn only while somebody looks at it.
ViewSource in_counter(const Settings&) { return {{}, "counted apart, R32F 4 B"}; }

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
  const LayoutRow& layout = facts(s.layout);
  const bool stored = shading_of(s.lights.method) != Shading::deferred || layout.shows != MaterialView::nothing;
  return stored ? surface_missing(s) : layout.roughness_missing;
}

std::string split_light_missing(const Settings& s) {
  if (shading_of(s.lights.method) == Shading::forward) return surface_missing(s);
  if (s.accumulation.targets == AccumulationTargets::split) return {};
  return "all light goes into one target; accumulation.targets=split keeps diffuse and specular apart";
}

std::string error_missing(const Settings& s) {
  const bool no_roughness = s.view.error.of == ErrorOf::roughness && !facts(s.layout).stores_roughness();
  return no_roughness ? facts(s.layout).roughness_missing : why_missing(shown_by(s.view.error.of), s);
}

}  // namespace gbl
