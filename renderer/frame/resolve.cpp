#include "renderer/frame/resolve.h"

#include <fmt/format.h>

#include "renderer/gbuffer/layouts.h"

namespace gbl {
namespace {

void append(std::vector<std::string>& to, std::vector<std::string> more) {
  for (std::string& m : more) to.push_back(std::move(m));
}

}  // namespace

MaterialNeeds needs_of(const Scene& scene) {
  MaterialNeeds needs;
  std::vector<bool> used(scene.materials.size());
  for (const Instance& i : scene.instances) used[static_cast<size_t>(i.material)] = true;
  for (size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    if (!used[i] || m.alpha_mode == AlphaMode::blend) continue;  // transparent surfaces are never stored
    needs.metal |= m.metal > 0;
    needs.emission |= m.unlit || m.emissive != glm::vec3(0);
    needs.occlusion |= m.occlusion_texture.texture != kNoTexture && m.occlusion_strength > 0;
  }
  return needs;
}

LayoutChoice choose_layout(const MaterialNeeds& needs) {
  if (!needs.any()) return {Layout::albedo_roughness, {"metal, emission and occlusion: no material has any"}};
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
  if (s.layout == Layout::auto_) {
    LayoutChoice choice = choose_layout(needs_of(scene));
    choose(choice.layout, "");
    append(out.notes, std::move(choice.left_out));
  } else if (const std::optional<Successor>& next = facts(s.layout).successor) {
    const MaterialNeeds needs = needs_of(scene);
    if (next->when == MaterialHas::more && needs.any())
      choose(next->layout, ", since a material has metal, emission or occlusion");
    else if (next->when == MaterialHas::emission && needs.emission)
      choose(next->layout, ", since a material shines");
  }
  return out;
}

}  // namespace gbl
