#include "renderer/study/advice/axis_values.h"

#include "renderer/gbuffer/layouts.h"

namespace gbl {
namespace {

// Some layouts find their successors by themselves, and auto is one of the others.
Values layouts(const DeviceLimits& limits) {
  Values out;
  for_sound_rows<Layout>(limits, [&](const ValueRow& r) {
    const auto l = static_cast<Layout>(r.value);
    if (l != Layout::auto_ && !succeeds_another(l)) out.push_back({{"layout", r.id}});
  });
  return out;
}

Values normals(const DeviceLimits& limits) {
  Values out;
  for_sound_rows<NormalEncoding>(limits, [&](const ValueRow& r) { out.push_back({{"normal.encoding", r.id}}); });
  return out;
}

// Depth formats from the finest: of set-ups with equal costs the first is taken.
Values positions(const DeviceLimits& limits) {
  Values out;
  for_sound_rows<DepthFormat>(limits, [&](const ValueRow& r) {
    if (static_cast<DepthFormat>(r.value) != DepthFormat::auto_)  // one of the others
      out.insert(out.begin(), Patch{{"position.source", "depth"}, {"depth.format", r.id}});
  });
  for_sound_rows<PositionSource>(limits, [&](const ValueRow& r) {
    if (static_cast<PositionSource>(r.value) != PositionSource::depth) out.push_back({{"position.source", r.id}});
  });
  return out;
}

Values accumulations(const DeviceLimits& limits) {
  Values out;
  for_sound_rows<AccumulationFormat>(limits, [&](const ValueRow& f) {
    for_sound_rows<AccumulationTargets>(limits, [&](const ValueRow& t) {
      out.push_back({{"accumulation.format", f.id}, {"accumulation.targets", t.id}});
    });
  });
  return out;
}

}  // namespace

void apply_values(Settings& s, const Patch& patch) { apply_patch(s, patch, "advice"); }

Settings lossless(const Settings& truth, FeatureSet features) {
  Settings s = truth;
  const Settings defaults;
  for (const Option& o : options())
    if (o.group == Group::method) o.set(s, o.get(defaults), o);
  apply_values(s, {{"layout", "float32"},
                   {"normal.encoding", "xyz32f"},
                   {"position.source", "view32f"},
                   {"accumulation.format", "rgba32f"},
                   {"accumulation.targets", "one"},
                   {"lights.method", "auto"},
                   {"lights.cull", "front"}});
  if (features.has(Feature::clip_control)) apply_values(s, {{"depth.format", "d32f-reversed"}});
  s.view = {};
  return s;
}

std::vector<Values> axis_values(const DeviceLimits& limits) {
  return {layouts(limits), normals(limits), positions(limits), accumulations(limits)};
}

}  // namespace gbl
