#include "renderer/resolve.h"

#include <fmt/format.h>

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
  choice.left_out.push_back("the finer steps of metal and occlusion: 6 bits each are kept");
  if (needs.emission) choice.left_out.push_back("emission above 1, and its finer steps: 20 bits are kept");
  return choice;
}

Resolved resolve(const Settings& s, const Scene& scene) {
  Resolved out{s, {}};
  if (s.layout != Layout::auto_ && s.layout != Layout::compact) return out;
  const MaterialNeeds needs = needs_of(scene);
  if (s.layout == Layout::auto_) {
    LayoutChoice choice = choose_layout(needs);
    out.settings.layout = choice.layout;
    out.notes.push_back(fmt::format("layout: {}", row(choice.layout).label));
    append(out.notes, std::move(choice.left_out));
  } else if (needs.any()) {
    out.settings.layout = Layout::compact_metal;
    out.notes.push_back("layout: compact with a word more, since a material has metal, emission or occlusion");
  }
  return out;
}

}  // namespace gbl
