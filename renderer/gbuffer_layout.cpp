#include "renderer/gbuffer_layout.h"

#include "renderer/normal_encoding.h"

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

Format depth_format(DepthFormat f) {
  constexpr Format kDepth[] = {Format::d16, Format::d24, Format::d32f};
  return kDepth[static_cast<int>(f)];
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
  all.push_back({"gbuffer.normal", Pass::geometry, Stores::normal, row_of(s.normal.encoding).format,
                 row(s.normal.encoding).label});
  if (s.layout == Layout::float32) {
    all.push_back(
        {"gbuffer.reflectance", Pass::geometry, Stores::reflectance, Format::rgba32f, "rgb: F0; a: occlusion"});
    all.push_back(
        {"gbuffer.emission", Pass::geometry, Stores::emission, Format::rgba32f, "rgb: radiance it sends out itself"});
  }
  all.push_back(
      {"gbuffer.depth", Pass::geometry, Stores::depth, depth_format(s.depth.format), "window depth 0..1, near to far"});
  const Format sum = accumulation_format(s.accumulation.format);
  if (s.accumulation.targets == AccumulationTargets::split) {
    all.push_back({"light.diffuse", Pass::lighting, Stores::diffuse_light, sum, "rgb: diffuse light without albedo"});
    all.push_back({"light.specular", Pass::lighting, Stores::specular_light, sum, "rgb: specular light"});
  } else {
    all.push_back({"light.sum", Pass::lighting, Stores::light, sum, "rgb: albedo x diffuse + specular"});
  }
  all.push_back(
      {"lit", Pass::combine, Stores::lit, Format::rgba32f, "rgb: linear radiance, unclamped; a: 1 where a surface is"});
  return all;
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
