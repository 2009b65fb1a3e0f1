#include "renderer/inspect/views.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/gbuffer/layouts.h"
#include "renderer/rows/value_table.h"

namespace gbl {
namespace {

// What the sources call a thing is quoted from their listings, so that a student finds it by name there.
// clang-format off
constexpr ViewRow kViews[] = {
  {.view = View::final, .id = "final", .key = "1", .label = "final",
   .sentence = "The finished picture: lit, after exposure and the display transform.",
   .written_by = Pass::display, .space = "RGB as the display takes it: sRGB-coded, or linear as it is with colour=as-tutorial",
   .unit = "display code", .range = "0..1", .read_by = "nobody; it is the last",
   .decode = "sRGB(clamp(exposure x lit, 0, 1)); as-tutorial: without the sRGB curve",
   .in_sources = "nclgl: the back buffer after CombineBuffers; stereo: v3ColourOut of the post-process shader; learnopengl: FragColor; objectid: m_framebuffertexture, blitted to the screen; viewspace: fragcolor, blended onto the screen",
   .mistake = "no sRGB curve anywhere: mid-tones come out too dark and every falloff too steep"},
  {.view = View::albedo, .id = "albedo", .key = "2", .label = "albedo",
   .sentence = "The surface's own colour, before any light falls on it.",
   .written_by = Pass::geometry, .space = "RGB; linear in the shaders, sRGB-coded where it is stored",
   .unit = "share of light reflected", .range = "0..1", .read_by = "combine; lighting instead when all light goes into one target",
   .decode = "rgb as stored is what is shown; the shaders undo the sRGB curve first",
   .in_sources = "nclgl: bufferColourTex; stereo: g_uiDiffuse (RGB8); learnopengl: gAlbedoSpec.rgb; objectid: GBufferDiffuse (Kd; Ka has a buffer of its own); viewspace: diffuse, already times 1 - ambient",
   .mistake = "linear albedo in 8 bits: 183 of the 256 texel codes survive, and dark surfaces show bands"},
  {.view = View::normal, .id = "normal", .key = "3", .label = "normal",
   .sentence = "Which way the surface faces, along the axes of the world.",
   .written_by = Pass::geometry, .space = "world axes, +Y up",
   .unit = "none: length 1", .range = "-1..1 per axis", .read_by = "lighting",
   .decode = "stored code -> unit vector n as the encoding says; shown as n x 0.5 + 0.5",
   .in_sources = "nclgl: bufferNormalTex, n * 0.5 + 0.5 in RGBA8; stereo: g_uiNormal, RG16F (\"stereoscopic\"); learnopengl: gNormal, RGBA16F; objectid: GBufferNormal, RGBA32F; viewspace: normal, in view space",
   .mistake = "TBN * texel * 2 - 1 for TBN * (texel * 2 - 1): normals tilt everywhere but on flat ground, so flat ground hides it"},
  {.view = View::depth, .id = "depth", .key = "4", .label = "depth",
   .sentence = "How far away the surface is along the view axis: near dark, far light, sky dark blue.",
   .written_by = Pass::geometry, .space = "along the view axis; stored as window depth",
   .unit = "world units", .range = "near..far; the bar ends at the scene's far corner", .read_by = "lighting (position), combine (where no surface is)",
   .decode = "near x far / (far - depth x (far - near))",
   .in_sources = "nclgl: bufferDepthTex, D24; stereo: g_uiDepth, D32F; learnopengl: the depth buffer, tested and blitted, never sampled; objectid: GBufferDepthStencil, D24S8; viewspace: cleared and tested, none of its five buffers",
   .mistake = "taking window depth for distance: with near 1 and far 10000 half of 0..1 is used up 2 units from the camera"},
  {.view = View::material, .id = "material", .key = "5", .label = "specular / roughness",
   .sentence = "How rough the surface is: the darker, the smaller and sharper its highlights.",
   .written_by = Pass::geometry, .space = "perceptual roughness",
   .unit = "none", .range = "0 smooth .. 1 rough", .read_by = "lighting",
   .decode = "alpha as stored; highlight exponent = 2 / roughness^4 - 2, kept within 1..8192",
   .in_sources = "nclgl: none, the exponent is 33 everywhere; stereo: g_uiSpecularRough, specular colour and roughness; learnopengl: gAlbedoSpec.a, specular intensity; objectid: GBufferSpecular (Ks) and GBufferShininess (Ns, R32F); viewspace: specular, shininess / 256 in alpha",
   .mistake = "the exponent itself in 8 bits, as shininess / 256: whole steps only, nothing above 256, 0 below a half",
   .needs = "a layout that stores roughness"},
  {.view = View::diffuse_light, .id = "diffuse-light", .key = "6", .label = "diffuse light",
   .sentence = "The light that arrives, summed over the lights, without the surface's colour.",
   .written_by = Pass::lighting, .space = "linear RGB",
   .unit = "light on a white surface", .range = "0 and up; rgba8 stops at 1", .read_by = "combine",
   .decode = "sum of colour x attenuation x max(N.L, 0); shown as final is",
   .in_sources = "nclgl: lightEmissiveTex (\"emissive\"); the other four keep no light apart: it goes straight into their sum or onto the screen",
   .mistake = "summing in RGBA8: overlapping pools go flat at 1, and lights fainter than half a code vanish",
   .needs = "accumulation.targets=split"},
  {.view = View::specular_light, .id = "specular-light", .key = "7", .label = "specular light",
   .sentence = "The highlights, summed over the lights; combine adds them as they are.",
   .written_by = Pass::lighting, .space = "linear RGB",
   .unit = "radiance", .range = "0 and up; rgba8 stops at 1", .read_by = "combine",
   .decode = "sum of colour x attenuation x specular x max(N.H, 0)^exponent where N.L > 0; shown as final is",
   .in_sources = "nclgl: lightSpecularTex; the other four keep no light apart: it goes straight into their sum or onto the screen",
   .mistake = "no test of N.L: highlights appear on faces that are turned away from the light",
   .needs = "accumulation.targets=split"},
  {.view = View::lights_per_pixel, .id = "lights-per-pixel", .key = "8", .label = "lights per pixel",
   .sentence = "How often a light in range was shaded here: a lost light is missing, a doubled one counts twice.",
   .written_by = Pass::lighting, .space = "a count",
   .unit = "shaded (pixel, light) pairs with distance < range", .range = "0 and up; 5 and more share a colour", .read_by = "nobody; it is counted to be looked at",
   .decode = "the colour of the count",
   .in_sources = "none of the five shows it",
   .mistake = "back faces culled with the camera inside a volume: that light is missing from every pixel; no culling: lights seen from outside count twice"},
  {.view = View::position, .id = "position", .key = "9", .label = "position",
   .sentence = "Where the surface is, worked out from the pixel and its depth: nothing more is stored.",
   .written_by = Pass::geometry, .space = "world axes, +Y up",
   .unit = "world units", .range = "the scene's bounds; colours repeat, as the legend says", .read_by = "lighting",
   .decode = "view-ray: camera + distance x (forward + x right + y up), x and y = -1..1 across the picture; shown as fract(position / cycle)",
   .in_sources = "nclgl: pos, from bufferDepthTex and inverseProjView; stereo: v3PositionIn, from s2DepthTexture and m4InvViewProjection; learnopengl: gPosition, RGBA16F; objectid: GBufferPosition, RGBA32F; viewspace: worldPos, in view space all the same, / 1e6 + 0.5 in RGBA32F",
   .mistake = "inverting view-projection in float: its noise is larger than the depth buffer's own error"},
  {.view = View::lit, .id = "lit", .key = "", .label = "lit",
   .sentence = "The sum that combine writes: linear radiance, not clamped; what accuracy is judged on.",
   .written_by = Pass::combine, .space = "linear RGB",
   .unit = "radiance", .range = "0 and up, not clamped", .read_by = "display, measures",
   .decode = "albedo x (ambient + diffuse light) + specular light; shown cut to 0..1, without exposure or curve",
   .in_sources = "nclgl: none, CombineBuffers writes to the back buffer; stereo: g_uiAccumulation, R11G11B10F; learnopengl: none, FragColor; objectid: m_framebuffertexture, RGBA8; viewspace: none, light is blended onto the screen",
   .mistake = "clamping to 1 here: what overlapping lights add up to is gone before exposure can bring it back"},
  {.view = View::wasted_pairs, .id = "wasted-pairs", .key = "", .label = "wasted pairs",
   .sentence = "How often a light was shaded here that does not reach the surface: work for nothing.",
   .written_by = Pass::lighting, .space = "a count",
   .unit = "shaded (pixel, light) pairs with distance >= range", .range = "0 and up; 21 and more share a colour", .read_by = "nobody; it is counted to be looked at",
   .decode = "pairs shaded - pairs shaded in range",
   .in_sources = "none of the five shows it; nclgl's figure of two cows explains it",
   .mistake = "taking the pixels under a light volume for the pixels in it: from the camera a sphere covers what lies far behind it, too"},
  {.view = View::reference, .id = "reference", .key = "", .label = "reference",
   .sentence = "The truth, worked out on the CPU in double precision: the seen triangle, then every light by brute force.",
   .written_by = Pass::combine, .space = "linear RGB",
   .unit = "radiance", .range = "0 and up; shown as final is", .read_by = "the error view and all measures",
   .decode = "pixel-centre ray x visible triangle -> point, normal, material; ambient + emission + sum over all lights, in double, in light order",
   .in_sources = "none of the five has one: they are judged by eye",
   .mistake = "taking the renderer's own full-screen loop for the truth: it reads the same quantised G-buffer, so what storing loses cannot show"},
  {.view = View::error, .id = "error", .key = "", .label = "error",
   .sentence = "How far the picture, or one of its buffers, is from the reference.",
   .written_by = Pass::combine, .space = "of what view.error.of names",
   .unit = "codes of 255, radiance, degrees or world units", .range = "0 to where 99.9 % of the pixels are within it, or to view.error.range; beyond it the last colour", .read_by = "nobody; the same numbers are measured on the CPU",
   .decode = "shown - true of the channel that is off most; magnitude: magma, signed: red too much, blue too little",
   .in_sources = "none of the five measures one",
   .mistake = "one mean for the whole picture: a light that is lost in one per cent of it hardly moves a mean"},
};
// clang-format on

constexpr bool in_order() {
  for (size_t i = 0; i < std::size(kViews); ++i)
    if (kViews[i].view != static_cast<View>(i)) return false;
  return std::size(kViews) == kViewCount;
}
static_assert(in_order(), "row i must be view i");
constexpr auto kValues =
    values_of<kViews>([](const ViewRow& r) { return ValueRow{.id = r.id, .label = r.label, .help = r.sentence}; });

Stores stored(View v) {
  switch (v) {
    case View::albedo:
    case View::material: return Stores::material;
    case View::normal: return Stores::normal;
    case View::depth:
    case View::position: return Stores::depth;
    case View::diffuse_light: return Stores::diffuse_light;
    case View::specular_light: return Stores::specular_light;
    case View::final:
    case View::lit:
    case View::lights_per_pixel:
    case View::wasted_pairs:
    case View::reference:
    case View::error: return Stores::lit;
  }
  return Stores::lit;
}

glm::vec3 grey(double g) { return glm::vec3(static_cast<float>(g)); }

constexpr int kBarSteps = 4;

Legend depth_legend(const Settings& s, const Bounds& bounds) {
  const glm::dvec2 range = depth_view_range(s.camera, bounds);
  Legend bar{true, {}, {{"sky", kSkyColour}}};
  for (int i = 0; i <= kBarSteps; ++i) {
    const double t = static_cast<double>(i) / kBarSteps;
    bar.entries.push_back(
        {fmt::format("{:g}{}", range.x + t * (range.y - range.x), i < kBarSteps ? "" : " units"), grey(t)});
  }
  return bar;
}

Legend roughness_legend(const Settings& s) {
  if (facts(s.layout).shows == MaterialView::specular && shading_of(s.lights.method) == Shading::deferred)
    return {false, {{"colour of the highlight", grey(0.5)}}, {}};
  Legend bar{true, {}, {}};
  for (int i = 0; i <= kBarSteps; ++i) {
    const double roughness = static_cast<double>(i) / kBarSteps;
    std::string label = fmt::format("{:g}", roughness);
    if (s.shading.exponent == kExponentFromRoughness) {
      const double exponent = std::clamp(2 / std::pow(roughness, 4) - 2, 1.0, 8192.0);
      label += fmt::format(" ({}{:.0f})", i == 0 ? "exponent " : "", exponent);
    }
    bar.entries.push_back({label, grey(roughness)});
  }
  return bar;
}

Legend normal_legend() {
  Legend axes;
  for (const float sign : {1.0f, -1.0f})
    for (int k = 0; k < 3; ++k) {
      glm::vec3 n(0);
      n[k] = sign;
      axes.entries.push_back({fmt::format("{}{}", sign > 0 ? '+' : '-', "XYZ"[k]), n * 0.5f + 0.5f});
    }
  return axes;
}

Legend count_legend() {
  Legend counts;
  for (int i = 0; i < kLightCountColours; ++i)
    counts.entries.push_back({fmt::format("{}{}", i, i + 1 < kLightCountColours ? "" : "+"), kLightCountPalette[i]});
  return counts;
}

Legend wasted_legend() {
  Legend counts;
  for (int i = 0; i < kLightCountColours; ++i) {
    const int from = kWastedFrom[i], to = i + 1 < kLightCountColours ? kWastedFrom[i + 1] - 1 : from;
    const std::string label = i + 1 == kLightCountColours ? fmt::format("{}+", from)
                              : from == to                ? fmt::format("{}", from)
                                                          : fmt::format("{}-{}", from, to);
    counts.entries.push_back({label, kLightCountPalette[i]});
  }
  return counts;
}

Legend position_legend(const Bounds& bounds) {
  return {false,
          {{"red: x", {1, 0, 0}},
           {"green: y", {0, 1, 0}},
           {"blue: z", {0, 0, 1}},
           {fmt::format("one colour cycle = {:g} units", position_cycle(bounds)), grey(0.5)}},
          {}};
}

}  // namespace

// Dark to light with each luminance at least 1.6 times the one before (plus 0.05, the projector's glare): the order
// survives colour blindness, a grey print and a bright room. The hues are there to be named aloud.
const glm::vec3 kLightCountPalette[kLightCountColours] = {
    {0.04f, 0.04f, 0.06f}, {0.16f, 0.22f, 0.62f}, {0.05f, 0.46f, 0.55f},
    {0.30f, 0.68f, 0.25f}, {0.98f, 0.76f, 0.15f}, {1.00f, 1.00f, 1.00f},
};

double round_for_bar(double x) {
  const double decade = std::pow(10, std::floor(std::log10(x)));
  for (const double step : {1.0, 1.2, 1.6, 2.0, 2.4, 3.2, 4.0, 6.0, 8.0})
    if (step * decade >= x) return step * decade;
  return 10 * decade;
}

std::span<const ViewRow> views() { return kViews; }

const ViewRow& row(View v) { return kViews[static_cast<size_t>(v)]; }

GBL_ROWS(View, kValues)

const ViewRow& view_by_id(std::string_view id) {
  return kViews[static_cast<size_t>(parse_id(kValues, id, "view", "view"))];
}

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

std::string why_missing(View v, const Settings& s) {
  if (v == View::error) {
    const bool no_roughness = s.view.error.of == ErrorOf::roughness && !facts(s.layout).stores_roughness();
    return no_roughness ? facts(s.layout).roughness_missing : why_missing(shown_by(s.view.error.of), s);
  }
  const bool one_light = v == View::diffuse_light || v == View::specular_light;
  const bool surface = v == View::albedo || v == View::normal || v == View::material;
  const Shading shading = shading_of(s.lights.method);
  if (shading == Shading::forward && (surface || one_light))
    return "forward shading keeps no G-buffer and no light apart: surfaces are shaded as they are drawn";
  if (shading == Shading::light_prepass && v == View::albedo)
    return "deferred lighting stores no albedo: materials are read when the geometry is drawn again";
  if (v == View::material && shading == Shading::deferred && facts(s.layout).shows == MaterialView::nothing)
    return facts(s.layout).roughness_missing;
  if (one_light && s.accumulation.targets != AccumulationTargets::split)
    return "all light goes into one target; accumulation.targets=split keeps diffuse and specular apart";
  return {};
}

std::string stored_as(View v, const Settings& s) {
  // Not part of the frame: a counter that is drawn only while somebody looks at it.
  if (counted(v)) return "counted apart, R32F 4 B";
  if (v == View::reference) return "worked out on the CPU, double";
  if (v == View::error) return fmt::format("of {} against the reference", row(s.view.error.of).label);
  const std::vector<Attachment> all = attachments(s);
  const Attachment* a = find(all, stored(v));
  const Stores material = facts(s.layout).shows_stored;
  if (v == View::material && find(all, material)) a = find(all, material);
  if (v == View::position && find(all, Stores::position)) a = find(all, Stores::position);
  if (v == View::normal && !a) a = find(all, Stores::material);
  if (!a) a = find(all, Stores::light);
  if (!a) a = find(all, Stores::lit);
  return fmt::format("{} {} {} B", a->name, row(a->format).label, row(a->format).bytes);
}

double position_cycle(const Bounds& bounds) {
  const double extent = std::max(1e-9, glm::length(bounds.extent()));
  return std::pow(10.0, std::floor(std::log10(extent / 10)));
}

glm::dvec2 depth_view_range(const Camera& camera, const Bounds& bounds) {
  double farthest = camera.near;  // a scene behind the camera still needs a bar
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                       corner & 4 ? bounds.max.z : bounds.min.z);
    farthest = std::max(farthest, glm::dot(p - camera.position, camera.forward()));
  }
  return {0, std::min(round_for_bar(farthest), camera.far)};
}

Legend legend(View v, const Settings& s, const Bounds& bounds) {
  if (!why_missing(v, s).empty()) return {};
  switch (v) {
    case View::normal: return normal_legend();
    case View::depth: return depth_legend(s, bounds);
    case View::material: return roughness_legend(s);
    case View::lights_per_pixel: return count_legend();
    case View::wasted_pairs: return wasted_legend();
    case View::position: return position_legend(bounds);
    case View::final:
    case View::albedo:
    case View::diffuse_light:
    case View::specular_light:
    case View::lit:
    case View::reference:
    case View::error: break;  // the error's bar depends on what was found: see error_view.h
  }
  return {};
}

}  // namespace gbl
