#pragma once
// The passes of a frame, one row each, in the order they run. That each reads only what a row before it has written is
// asserted below.
#include "renderer/passes/passes.h"

namespace gbl {

// A set of what attachments store.
struct StoresSet {
  unsigned bits = 0;
  constexpr StoresSet(std::initializer_list<Stores> list) {  // NOLINT(google-explicit-constructor): a row's cell
    for (const Stores s : list) bits |= 1u << static_cast<unsigned>(s);
  }
};
inline constexpr StoresSet kMaterials = {Stores::material, Stores::normal,    Stores::reflectance, Stores::emission,
                                         Stores::ambient,  Stores::shininess, Stores::id,          Stores::position};
inline constexpr StoresSet kLightSums = {Stores::light, Stores::diffuse_light, Stores::specular_light};
constexpr StoresSet operator|(StoresSet a, const StoresSet& b) {
  a.bits |= b.bits;
  return a;
}

struct PassRow {
  const char* timer;                     // its name in reports; two ways to combine share one
  bool (*needed)(const ResolvedFrame&);  // by this frame
  StoresSet reads, writes;               // at most
  int (*draw)(Frame&);                   // -> draw calls
};

namespace pass {
inline bool shadows(const ResolvedFrame& f) { return !f.shadows.maps.empty(); }
inline bool forward(const ResolvedFrame& f) { return f.shading == Shading::forward; }
inline bool gbuffer(const ResolvedFrame& f) { return f.shading != Shading::forward; }
inline bool sums_light(const ResolvedFrame& f) { return gbuffer(f) && !f.folds_light; }
inline bool folds_light(const ResolvedFrame& f) { return f.folds_light; }
inline bool deferred(const ResolvedFrame& f) { return f.shading == Shading::deferred && !f.folds_light; }
inline bool light_prepass(const ResolvedFrame& f) { return f.shading == Shading::light_prepass; }
inline bool reflections(const ResolvedFrame& f) { return !f.mirrors.empty(); }
inline bool edge_blur(const ResolvedFrame& f) { return f.settings.antialias == Antialias::edge_blur; }
inline bool transparent(const ResolvedFrame& f) { return f.transparent_pass; }
}  // namespace pass

// clang-format off
inline constexpr PassRow kPasses[] = {
  {"shadows",     pass::shadows,       {},                                         {},                                               draw_shadow_maps},
  {"forward",     pass::forward,       {},                                         {Stores::depth, Stores::lit},                     draw_forward_frame},
  {"geometry",    pass::gbuffer,       {},                                         kMaterials | StoresSet{Stores::depth, Stores::light}, draw_geometry},
  {"lighting",    pass::sums_light,     kMaterials | StoresSet{Stores::depth},      kLightSums | StoresSet{Stores::light_depth},      draw_light_sums},
  {"lighting",    pass::folds_light,   kMaterials | StoresSet{Stores::depth},      {Stores::lit},                                    draw_folded_light},
  {"combine",     pass::deferred,      kMaterials | kLightSums | StoresSet{Stores::depth}, {Stores::lit},                            draw_combine},
  {"combine",     pass::light_prepass, kLightSums | StoresSet{Stores::depth},      {Stores::lit},                                    draw_materials_over_light},
  {"reflections", pass::reflections,   {Stores::depth, Stores::lit},               {Stores::lit},                                    draw_reflections},
  {"antialias",   pass::edge_blur,     kMaterials | StoresSet{Stores::depth, Stores::lit}, {Stores::lit},                            draw_edge_blur},
  {"transparent", pass::transparent,   {Stores::depth, Stores::lit},               {},                                               draw_transparent},
};
// clang-format on

constexpr bool reads_what_was_written() {
  unsigned written = 0;
  for (const PassRow& p : kPasses) {
    if (p.reads.bits & ~written) return false;
    written |= p.writes.bits;
  }
  return true;
}
static_assert(reads_what_was_written(), "a pass reads what no row before it writes");

}  // namespace gbl
