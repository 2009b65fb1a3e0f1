#include "renderer/gbuffer/gbuffer_layout.h"

#include <span>

#include "renderer/gbuffer/normal_encoding.h"

namespace gbl {
namespace {

struct LayoutRow {
  Layout layout;
  LayoutFacts facts;
  std::span<const Attachment> material;
};

constexpr Attachment of_geometry(const char* name, Stores stores, Format format, const char* contents) {
  return {name, Pass::geometry, stores, format, contents};
}

// clang-format off
constexpr Attachment kAlbedoRoughness[] = {
  of_geometry("gbuffer.albedo_roughness", Stores::material, Format::rgba8, "rgb: albedo, sRGB-coded; a: roughness")};
constexpr Attachment kNclgl[] = {
  of_geometry("gbuffer.colour", Stores::material, Format::rgba8, "rgb: colour, sRGB-coded; a: 1, unused")};
constexpr Attachment kStereo[] = {
  of_geometry("gbuffer.diffuse", Stores::material, Format::rgba8, "rgb: diffuse colour, sRGB-coded; a: padding of RGB8"),
  of_geometry("gbuffer.specular_rough", Stores::reflectance, Format::rgba8, "rgb: specular colour; a: roughness")};
constexpr Attachment kLearnopengl[] = {
  of_geometry("gbuffer.albedo_spec", Stores::material, Format::rgba8, "rgb: albedo, sRGB-coded; a: specular strength")};
constexpr Attachment kObjectid[] = {
  of_geometry("gbuffer.ambient", Stores::ambient, Format::rgba8, "rgb: Ka, sRGB-coded; a: 1"),
  of_geometry("gbuffer.diffuse", Stores::material, Format::rgba8, "rgb: Kd, sRGB-coded; a: 1"),
  of_geometry("gbuffer.specular", Stores::reflectance, Format::rgba8, "rgb: Ks; a: 1"),
  of_geometry("gbuffer.shininess", Stores::shininess, Format::r32f, "r: Ns, the highlight's exponent"),
  of_geometry("gbuffer.object_id", Stores::id, Format::r32ui, "r: number of the object, from 1 (0: none)")};
constexpr Attachment kViewspace[] = {
  of_geometry("gbuffer.ambient", Stores::ambient, Format::rgba8, "rgb: ambient colour, sRGB-coded; a: 1 where a surface is"),
  of_geometry("gbuffer.diffuse", Stores::material, Format::rgba8, "rgb: diffuse colour, sRGB-coded; a: 1"),
  of_geometry("gbuffer.specular", Stores::reflectance, Format::rgba8, "rgb: specular colour; a: exponent / 256")};
constexpr Attachment kCompact[] = {
  of_geometry("gbuffer.material", Stores::material, Format::rg32ui,
              "r: normal 28, roughness bits 6-9; g: albedo 9 9 8 sRGB-coded, roughness bits 0-5")};
constexpr Attachment kCompactMetal[] = {
  of_geometry("gbuffer.material", Stores::material, Format::rg32ui,
              "r: normal 28, roughness bits 6-9; g: base colour 9 9 8 sRGB-coded, roughness bits 0-5"),
  of_geometry("gbuffer.reflectance", Stores::reflectance, Format::r32ui, "bit 31: it shines. Then emission 8 8 8 sRGB-coded as displayed, metal 3, occlusion 4; else metal 10, occlusion 10")};
constexpr Attachment kExact[] = {
  of_geometry("gbuffer.material", Stores::material, Format::rg32ui,
              "r: base colour 10 10 10 sRGB-coded, roughness bits 0-1; g: roughness bits 2-13, metal 10, occlusion 10")};
constexpr Attachment kExactEmission[] = {
  kExact[0],
  of_geometry("gbuffer.emission", Stores::emission, Format::r32ui, "emission 11 11 10, sRGB-coded as displayed")};
constexpr Attachment kFloat32[] = {
  of_geometry("gbuffer.albedo_roughness", Stores::material, Format::rgba32f, "rgb: albedo, linear; a: roughness"),
  of_geometry("gbuffer.reflectance", Stores::reflectance, Format::rgba32f, "rgb: F0; a: occlusion"),
  of_geometry("gbuffer.emission", Stores::emission, Format::rgba32f, "rgb: radiance it sends out itself; a: metal")};

constexpr LayoutRow kLayouts[] = {
  {Layout::albedo_roughness, {.shows = MaterialView::roughness, .srgb_coded_albedo = true, .roughness_missing = ""}, kAlbedoRoughness},
  {Layout::nclgl, {.shows = MaterialView::nothing, .srgb_coded_albedo = true,
     .roughness_missing = "the nclgl layout stores no roughness: the exponent is one constant for all surfaces", .alpha_marks = true}, kNclgl},
  {Layout::stereo, {.shows = MaterialView::roughness, .srgb_coded_albedo = true, .roughness_missing = "", .keeps_emission = true}, kStereo},
  {Layout::learnopengl, {.shows = MaterialView::specular, .srgb_coded_albedo = true,
     .roughness_missing = "the learnopengl layout stores a specular strength and no roughness"}, kLearnopengl},
  {Layout::objectid, {.shows = MaterialView::roughness, .srgb_coded_albedo = true, .roughness_missing = "", .alpha_marks = true}, kObjectid},
  {Layout::viewspace, {.shows = MaterialView::roughness, .srgb_coded_albedo = true, .roughness_missing = "", .alpha_marks = true}, kViewspace},
  {Layout::compact, {.shows = MaterialView::roughness, .srgb_coded_albedo = true, .roughness_missing = "", .words = true}, kCompact},
  {Layout::compact_metal, {.shows = MaterialView::roughness, .srgb_coded_albedo = true, .roughness_missing = "", .words = true, .keeps_emission = true}, kCompactMetal},
  {Layout::exact, {.shows = MaterialView::roughness, .srgb_coded_albedo = true, .roughness_missing = "", .words = true}, kExact},
  {Layout::exact_emission, {.shows = MaterialView::roughness, .srgb_coded_albedo = true, .roughness_missing = "", .words = true, .keeps_emission = true}, kExactEmission},
  {Layout::float32, {.shows = MaterialView::roughness, .srgb_coded_albedo = false, .roughness_missing = "", .keeps_emission = true}, kFloat32},
  {Layout::auto_, {.shows = MaterialView::roughness, .srgb_coded_albedo = true, .roughness_missing = ""}, {}},
};
// clang-format on
static_assert([] {
  for (size_t i = 0; i < std::size(kLayouts); ++i)
    if (kLayouts[i].layout != static_cast<Layout>(i)) return false;
  return true;
}());

constexpr int kNormalBitsInMaterial = 28;  // of the first word of the compact layouts

// What lighting needs when the materials come later: deferred lighting's thin G-buffer.
constexpr Attachment kThin =
    of_geometry("gbuffer.specular_rough", Stores::material, Format::rgba8, "rgb: specular colour; a: roughness");
constexpr Attachment kThinFloat =
    of_geometry("gbuffer.specular_rough", Stores::material, Format::rgba32f, kThin.contents);

Attachment position_attachment(PositionSource source) {
  constexpr Format kFormats[] = {Format::r32f,    Format::r32f,    Format::rgba16f, Format::rgba32f,
                                 Format::rgba16f, Format::rgba32f, Format::rgba32f};
  return {"gbuffer.position", Pass::geometry, Stores::position, kFormats[static_cast<int>(source)], row(source).help};
}

// D16 has no variant with a stencil buffer; validate() says so.
Format depth_format(const Settings& s) {
  constexpr Format kDepth[] = {Format::d16, Format::d24, Format::d32f, Format::d32f};
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

bool split(const Settings& s) { return s.accumulation.targets == AccumulationTargets::split; }

void append_material(const Settings& s, std::vector<Attachment>& all) {
  if (shading_of(s.lights.method) == Shading::light_prepass) {
    all.push_back(s.layout == Layout::float32 ? kThinFloat : kThin);
    return;
  }
  for (const Attachment& a : kLayouts[static_cast<int>(s.layout)].material) all.push_back(a);
  if (s.layout == Layout::stereo) {
    const Format sum = accumulation_format(s.accumulation.format);
    all.push_back(sum_begins_in_geometry(s)
                      ? of_geometry("light.sum", Stores::light, sum, "rgb: ambient + emission, then all light")
                      : of_geometry("gbuffer.accumulation", Stores::emission, sum, "rgb: ambient + emission"));
  }
}

void append_light(const Settings& s, std::vector<Attachment>& all) {
  const Format sum = accumulation_format(s.accumulation.format);
  if (split(s)) {
    all.push_back({"light.diffuse", Pass::lighting, Stores::diffuse_light, sum, "rgb: diffuse light without albedo"});
    all.push_back({"light.specular", Pass::lighting, Stores::specular_light, sum, "rgb: specular light"});
  } else if (!sum_begins_in_geometry(s)) {
    all.push_back({"light.sum", Pass::lighting, Stores::light, sum, "rgb: albedo x diffuse + specular"});
  }
  if (lighting_has_depth(s))
    all.push_back({"light.depth", Pass::lighting, Stores::light_depth, depth_format(s),
                   needs_stencil(s) ? "a copy of the depth; stencil: marks" : "a copy of the depth"});
}

}  // namespace

Shading shading_of(LightMethod m) {
  switch (m) {
    case LightMethod::forward:
    case LightMethod::forward_prepass:
    case LightMethod::forward_multipass: return Shading::forward;
    case LightMethod::prepass: return Shading::light_prepass;
    default: return Shading::deferred;
  }
}

bool sum_begins_in_geometry(const Settings& s) {
  return s.layout == Layout::stereo && !split(s) && shading_of(s.lights.method) == Shading::deferred;
}

bool normal_in_material(const Settings& s) {
  return (s.layout == Layout::compact || s.layout == Layout::compact_metal) &&
         shading_of(s.lights.method) == Shading::deferred && row_of(s.normal.encoding).format == Format::r32ui &&
         row_of(s.normal.encoding).bits() <= kNormalBitsInMaterial;
}

std::vector<Attachment> attachments(const Settings& s) {
  std::vector<Attachment> all;
  const bool forward = shading_of(s.lights.method) == Shading::forward;
  if (!forward) {
    append_material(s, all);
    if (!normal_in_material(s))
      all.push_back({"gbuffer.normal", Pass::geometry, Stores::normal, row_of(s.normal.encoding).format,
                     row(s.normal.encoding).label});
    if (s.position.source != PositionSource::depth) all.push_back(position_attachment(s.position.source));
  }
  all.push_back({"gbuffer.depth", Pass::geometry, Stores::depth, depth_format(s),
                 s.depth.format == DepthFormat::d32f_reversed ? "window depth 1..0, near to far"
                                                              : "window depth 0..1, near to far"});
  if (!forward) append_light(s, all);
  all.push_back(
      {"lit", Pass::combine, Stores::lit, Format::rgba32f, "rgb: linear radiance, unclamped; a: 1 where a surface is"});
  return all;
}

bool needs_stencil(const Settings& s) {
  return s.lights.method == LightMethod::volumes_stencil ||
         (s.background.skip == BackgroundSkip::stencil && shading_of(s.lights.method) != Shading::forward);
}

bool lighting_has_depth(const Settings& s) { return lighting_tests_depth(s) || needs_stencil(s); }

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

const LayoutFacts& facts(Layout l) { return kLayouts[static_cast<int>(l)].facts; }

}  // namespace gbl
