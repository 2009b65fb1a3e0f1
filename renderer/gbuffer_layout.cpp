#include "renderer/gbuffer_layout.h"

namespace gbl {
namespace {

struct MaterialRow {
  Layout layout;
  Attachment attachment;
  LayoutFacts facts;
};

constexpr MaterialRow kMaterials[] = {
    {Layout::albedo_roughness,
     {"gbuffer.albedo_roughness", Pass::geometry, Stores::material, Format::rgba8,
      "rgb: albedo, sRGB-coded; a: roughness"},
     {true, true, ""}},
    {Layout::nclgl,
     {"gbuffer.colour", Pass::geometry, Stores::material, Format::rgba8, "rgb: colour, sRGB-coded; a: 1, unused"},
     {false, true, "the nclgl layout stores no roughness: the exponent is one constant for all surfaces"}},
    {Layout::float32,
     {"gbuffer.albedo_roughness", Pass::geometry, Stores::material, Format::rgba32f,
      "rgb: albedo, linear; a: roughness"},
     {true, false, ""}},
};

Format normal_format(NormalEncoding e) {
  switch (e) {
    case NormalEncoding::oct16: return Format::rg16ui;
    case NormalEncoding::oct8: return Format::rg8;
    case NormalEncoding::xyz8: return Format::rgba8;
    case NormalEncoding::stereo16f: return Format::rg16f;
  }
  return Format::rgba8;
}

// D16 has no variant with a stencil buffer; validate() says so.
Format depth_format(const Settings& s) {
  constexpr Format kDepth[] = {Format::d16, Format::d24, Format::d32f};
  const Format plain = kDepth[static_cast<int>(s.depth.format)];
  if (!needs_stencil(s)) return plain;
  return plain == Format::d24 ? Format::d24s8 : plain == Format::d32f ? Format::d32fs8 : plain;
}

Format accumulation_format(AccumulationFormat f) {
  constexpr Format kAccumulation[] = {Format::rgba8, Format::r11g11b10f, Format::rgba16f, Format::rgba32f};
  return kAccumulation[static_cast<int>(f)];
}

int bytes_per_pixel(const Settings& s, Pass pass) {
  int bytes = 0;
  for (const Attachment& a : attachments(s))
    if (a.written_by == pass) bytes += row(a.format).bytes;
  return bytes;
}

}  // namespace

std::vector<Attachment> attachments(const Settings& s) {
  std::vector<Attachment> all;
  all.push_back(kMaterials[static_cast<int>(s.layout)].attachment);
  all.push_back({"gbuffer.normal", Pass::geometry, Stores::normal, normal_format(s.normal.encoding),
                 row(s.normal.encoding).label});
  if (s.layout == Layout::float32) {
    all.push_back(
        {"gbuffer.reflectance", Pass::geometry, Stores::reflectance, Format::rgba32f, "rgb: F0; a: occlusion"});
    all.push_back(
        {"gbuffer.emission", Pass::geometry, Stores::emission, Format::rgba32f, "rgb: radiance it sends out itself"});
  }
  all.push_back({"gbuffer.depth", Pass::geometry, Stores::depth, depth_format(s), "window depth 0..1, near to far"});
  const Format sum = accumulation_format(s.accumulation.format);
  if (s.accumulation.targets == AccumulationTargets::split) {
    all.push_back({"light.diffuse", Pass::lighting, Stores::diffuse_light, sum, "rgb: diffuse light without albedo"});
    all.push_back({"light.specular", Pass::lighting, Stores::specular_light, sum, "rgb: specular light"});
  } else {
    all.push_back({"light.sum", Pass::lighting, Stores::light, sum, "rgb: albedo x diffuse + specular"});
  }
  if (lighting_tests_depth(s))
    all.push_back({"light.depth", Pass::lighting, Stores::light_depth, depth_format(s),
                   needs_stencil(s) ? "a copy of the depth; stencil: marks of the light at work, 0 when it is done"
                                    : "a copy of the depth"});
  all.push_back(
      {"lit", Pass::combine, Stores::lit, Format::rgba32f, "rgb: linear radiance, unclamped; a: 1 where a surface is"});
  return all;
}

bool needs_stencil(const Settings& s) { return s.lights.method == LightMethod::volumes_stencil; }

bool lighting_tests_depth(const Settings& s) {
  return s.lights.method == LightMethod::volumes_stencil ||
         (draws_chosen_faces(s.lights.method) && s.lights.volume.depth != VolumeDepth::none);
}

const Attachment* find(const std::vector<Attachment>& all, Stores what) {
  for (const Attachment& a : all)
    if (a.stores == what) return &a;
  return nullptr;
}

int gbuffer_bytes_per_pixel(const Settings& s) { return bytes_per_pixel(s, Pass::geometry); }
int accumulation_bytes_per_pixel(const Settings& s) { return bytes_per_pixel(s, Pass::lighting); }

const LayoutFacts& facts(Layout l) { return kMaterials[static_cast<int>(l)].facts; }

}  // namespace gbl
