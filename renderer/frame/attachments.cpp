#include "renderer/frame/attachments.h"

#include <cmath>

#include "renderer/gbuffer/layouts.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "renderer/light/light_methods.h"

namespace gbl {
namespace {

constexpr Attachment of_geometry(const char* name, Stores stores, Format format, const char* contents) {
  return {name, Pass::geometry, stores, format, contents};
}

// What lighting needs when the materials come later: deferred lighting's thin G-buffer.
constexpr Attachment kThin =
    of_geometry("gbuffer.specular_rough", Stores::material, Format::rgba8, "rgb: specular colour; a: roughness");
constexpr Attachment kThinFloat =
    of_geometry("gbuffer.specular_rough", Stores::material, Format::rgba32f, kThin.contents);

Format format_of(PositionSource source) {
  switch (source) {
    case PositionSource::depth:
    case PositionSource::linear32f: return Format::r32f;
    case PositionSource::world16f:
    case PositionSource::view16f: return Format::rgba16f;
    case PositionSource::world32f:
    case PositionSource::view32f:
    case PositionSource::view_scaled: break;
  }
  return Format::rgba32f;
}

Format format_of(DepthFormat f) {
  switch (f) {
    case DepthFormat::d16: return Format::d16;
    case DepthFormat::d24: return Format::d24;
    case DepthFormat::d32f:
    case DepthFormat::d32f_reversed:
    case DepthFormat::auto_: break;  // either of the two above
  }
  return Format::d32f;
}

Format format_of(AccumulationFormat f) {
  switch (f) {
    case AccumulationFormat::rgba8: return Format::rgba8;
    case AccumulationFormat::r11g11b10f: return Format::r11g11b10f;
    case AccumulationFormat::rgba16f: return Format::rgba16f;
    case AccumulationFormat::rgba32f: break;
  }
  return Format::rgba32f;
}

// D16 has no variant with a stencil buffer; validate() says so.
Format depth_format(const Settings& s) {
  const Format plain = format_of(s.depth.format);
  if (!needs_stencil(s)) return plain;
  return plain == Format::d24 ? Format::d24s8 : plain == Format::d32f ? Format::d32fs8 : plain;
}

// Light that is summed before the albedo is known needs both.
bool split(const Settings& s) {
  return s.accumulation.targets == AccumulationTargets::split ||
         (s.accumulation.targets == AccumulationTargets::folded &&
          shading_of(s.lights.method) == Shading::light_prepass);
}

void append_material(const Settings& s, std::vector<Attachment>& all) {
  if (shading_of(s.lights.method) == Shading::light_prepass) {
    all.push_back(layout_of(s).floats ? kThinFloat : kThin);
    return;
  }
  for (const MaterialTexel& t : layout_of(s).material)
    if (t.name) all.push_back(of_geometry(t.name, t.stores, t.format, t.contents));
  if (layout_of(s).begins_sum) {
    const Format sum = format_of(s.accumulation.format);
    all.push_back(sum_begins_in_geometry(s)
                      ? of_geometry("light.sum", Stores::light, sum, "rgb: ambient + emission, then all light")
                      : of_geometry("gbuffer.accumulation", Stores::emission, sum, "rgb: ambient + emission"));
  }
}

void append_light(const Settings& s, std::vector<Attachment>& all) {
  const Format sum = format_of(s.accumulation.format);
  if (split(s)) {
    all.push_back({"light.diffuse", Pass::lighting, Stores::diffuse_light, sum, "rgb: diffuse light without albedo"});
    all.push_back({"light.specular", Pass::lighting, Stores::specular_light, sum, "rgb: specular light"});
  } else if (!sum_begins_in_geometry(s) && !folds_light(s)) {
    all.push_back({"light.sum", Pass::lighting, Stores::light, sum, "rgb: albedo x diffuse + specular"});
  }
  if (!folds_light(s) && (lighting_tests_depth(s) || needs_stencil(s)))
    all.push_back({"light.depth", Pass::lighting, Stores::light_depth, depth_format(s),
                   needs_stencil(s) ? "a copy of the depth; stencil: marks" : "a copy of the depth"});
}

}  // namespace

bool sum_begins_in_geometry(const Settings& s) {
  return layout_of(s).begins_sum && !split(s) && !folds_light(s) && shading_of(s.lights.method) == Shading::deferred;
}

bool folds_light(const Settings& s) {
  return s.accumulation.targets == AccumulationTargets::folded && facts(s.lights.method).reads_pixels_once;
}

bool normal_in_material(const Settings& s) {
  const auto& normal = row_of(s.normal.encoding);
  return shading_of(s.lights.method) == Shading::deferred && normal.format == Format::r32ui &&
         normal.bits() <= layout_of(s).normal_bits;
}

// Half floats end at 65504, a sunlit wall's radiance lies above that, and at 10^-8 they have no digits left. Where the
// exposure says that radiance is so far from the display's range, sums are stored in its units; a power of two changes
// no other bit. (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", section 5.1.2, pre-exposure.)
double light_sum_scale(double exposure) {
  constexpr double kAsItIs = 256;
  return exposure >= 1 / kAsItIs && exposure <= kAsItIs ? 1 : std::exp2(std::round(std::log2(exposure)));
}

std::vector<Attachment> attachments(const Settings& s) {
  std::vector<Attachment> all;
  const bool forward = shading_of(s.lights.method) == Shading::forward;
  if (!forward) {
    append_material(s, all);
    if (!normal_in_material(s))
      all.push_back({"gbuffer.normal", Pass::geometry, Stores::normal, row_of(s.normal.encoding).format,
                     row(s.normal.encoding).label});
    if (s.position.source != PositionSource::depth)
      all.push_back({"gbuffer.position", Pass::geometry, Stores::position, format_of(s.position.source),
                     row(s.position.source).help});
  }
  all.push_back({"gbuffer.depth", Pass::geometry, Stores::depth, depth_format(s),
                 s.depth.format == DepthFormat::d32f_reversed ? "window depth 1..0, near to far"
                                                              : "window depth 0..1, near to far"});
  if (!forward) append_light(s, all);
  // Folded, it is the only place where light is kept, and holds it as sums would. It is radiance as it is: where that would not
  // fit into few bits it is kept in floats.
  all.push_back(
      {"lit", Pass::combine, Stores::lit,
       folds_light(s) && light_sum_scale(s.exposure) == 1 ? format_of(s.accumulation.format) : Format::rgba32f,
       "rgb: linear radiance"});
  return all;
}

bool needs_stencil(const Settings& s) {
  return facts(s.lights.method).marks_stencil ||
         (s.background.skip == BackgroundSkip::stencil && shading_of(s.lights.method) != Shading::forward);
}

bool lighting_tests_depth(const Settings& s) {
  return facts(s.lights.method).compares_depth ||
         (draws_chosen_faces(s.lights.method) && s.lights.volume.depth != VolumeDepth::none);
}

// One step of the format, for both depths are rounded to it; and of float, in which a face's depth is interpolated from
// its vertices', four.
double volume_depth_step(const Settings& s) {
  if (!lighting_tests_depth(s)) return 0;
  return std::ldexp(1, s.depth.format == DepthFormat::d16 ? -16 : -24) + std::ldexp(4, -24);
}

const Attachment* find(const std::vector<Attachment>& all, Stores what) {
  for (const Attachment& a : all)
    if (a.stores == what) return &a;
  return nullptr;
}

int bytes_per_pixel(const std::vector<Attachment>& all, Pass pass) {
  int bytes = 0;
  for (const Attachment& a : all)
    if (a.written_by == pass) bytes += row(a.format).bytes;
  return bytes;
}

}  // namespace gbl
