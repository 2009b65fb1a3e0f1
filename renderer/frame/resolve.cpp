#include "renderer/frame/resolve.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/gbuffer/layouts.h"
#include "renderer/reflection/mirrors.h"

namespace gbl {
namespace {

bool has_unlit(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return m.unlit && m.alpha_mode != AlphaMode::blend; });
}

const char* why_of(MaterialHas what) {
  switch (what) {
    case MaterialHas::nothing: break;
    case MaterialHas::emission: return ", since a material shines";
    case MaterialHas::specular: return ", since a material has a reflectance of its own";
    case MaterialHas::more: return ", since a material has metal, emission or occlusion";
  }
  return "";
}

// Of the scene's box along the view axis; negative: behind the camera.
double nearest_of(const Bounds& bounds, const Camera& c) {
  const glm::dvec3 forward = c.forward(), half = bounds.extent() / 2.0;
  return glm::dot(bounds.centre() - c.position, forward) - glm::dot(half, glm::abs(forward));
}

constexpr double kBeforeScene = 0.999;  // of the distance: rounding must not cut the nearest corner off

}  // namespace

MaterialNeeds needs_of(const Scene& scene, bool refraction) {
  MaterialNeeds needs;
  std::vector<bool> used(scene.materials.size());
  for (const Instance& i : scene.instances) used[static_cast<size_t>(i.material)] = true;
  for (size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    if (!used[i] || blends(m, refraction)) continue;  // never stored
    needs.metal |= m.metal > 0;
    needs.emission |= m.unlit || m.emissive != glm::vec3(0);
    needs.occlusion |= m.occlusion_texture.texture != kNoTexture && m.occlusion_strength > 0;
    needs.specular |= !m.unlit && !reflects_as_common(m);
  }
  return needs;
}

bool MaterialNeeds::has(MaterialHas what) const {
  switch (what) {
    case MaterialHas::nothing: return false;
    case MaterialHas::emission: return emission;
    case MaterialHas::specular: return specular;
    case MaterialHas::more: return metal || emission || occlusion;
  }
  return false;
}

LayoutChoice choose_layout(const MaterialNeeds& needs) {
  if (!needs.any()) return {Layout::albedo_roughness, {"metal, emission and occlusion: no material has any"}};
  if (needs.specular)
    return {Layout::exact_specular,
            {"the finer steps of metal and occlusion: 10 bits each are kept", "emission above the display's white"}};
  LayoutChoice choice{Layout::compact_metal, {}};
  choice.left_out.push_back("the finer steps of metal and occlusion: 10 bits each are kept");
  if (needs.emission)
    choice.left_out.push_back(
        "emission above the display's white, and beside it all but 7 bits of metal and occlusion");
  return choice;
}

Resolved resolve(const Settings& s, const Scene& scene) {
  Resolved out{s, {}};
  const auto choose = [&](Layout layout, const char* why) {
    out.settings.layout = layout;
    out.notes.push_back(fmt::format("layout: {}{}", row(layout).label, why));
  };
  if (!s.layout_file.empty()) {
    out.notes.push_back(fmt::format("layout: {}", layout_of(s).axis.label));
  } else if (s.layout == Layout::auto_) {
    LayoutChoice choice = choose_layout(needs_of(scene, s.reflections == Reflections::on));
    choose(choice.layout, "");
    for (const std::string& what : choice.left_out) out.notes.push_back("not stored: " + what);
  } else {
    const MaterialNeeds needs = needs_of(scene, s.reflections == Reflections::on);
    for (const Successor& next : layout_of(s).successors)
      if (needs.has(next.when)) {
        choose(next.layout, why_of(next.when));
        break;
      }
  }
  const LayoutRow& stored = layout_of(out.settings);
  if (!stored.keeps_emission && shading_of(s.lights.method) != Shading::forward && has_unlit(scene))
    out.notes.push_back(
        fmt::format("unlit surfaces are lit like others: the {} layout stores no emission", stored.axis.id));
  return out;
}

void choose_depth(Resolved& r, const Scene& scene, FeatureSet features) {
  Settings& s = r.settings;
  if (s.depth.format != DepthFormat::auto_) return;
  const bool reversed = features.has(Feature::clip_control);
  s.depth.format = reversed ? DepthFormat::d32f_reversed : DepthFormat::d32f;
  std::string note = fmt::format("depth: {}", row(s.depth.format).label);
  const double before = kBeforeScene * nearest_of(scene.bounds, s.camera);
  const bool scene_is_all = s.lights.markers == LightMarkers::off;  // the cubes may stand outside of it
  if (!reversed && scene_is_all && before > s.camera.near && before < s.camera.far) {
    note += fmt::format(", near plane {:.3g} instead of {:.3g}: the scene begins there", before, s.camera.near);
    s.camera.near = before;
  }
  r.notes.push_back(std::move(note));
}

}  // namespace gbl
