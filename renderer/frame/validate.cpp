#include "renderer/frame/validate.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/size_text.h"
#include "renderer/frame/attachments.h"
#include "renderer/gbuffer/layouts.h"
#include "renderer/options/options.h"

namespace gbl {
namespace {

const char* name_of(Feature f) { return kFeatures[static_cast<int>(f) - 1].id; }

bool finite(const OptionValue& v) {
  if (const auto* n = std::get_if<Number>(&v)) return std::isfinite(n->value);
  const auto* list = std::get_if<OptionList>(&v);
  return !list || std::all_of(list->begin(), list->end(), finite);
}

void check_options(const Settings& s, const DeviceLimits& limits, std::vector<Problem>& out) {
  for (const Option& o : options()) {
    if (!finite(o.get(s))) out.push_back({ProblemId::not_finite, o.path, "is not a finite number; give one"});
    if (o.kind != Kind::choice) continue;
    const ValueRow& r = o.values[chosen(o, s)];
    if (!limits.features.has(r.needs))
      out.push_back({ProblemId::feature_missing, o.path,
                     fmt::format("{} needs {}, which this driver lacks or --without switched off; choose another value",
                                 r.id, name_of(r.needs))});
  }
}

void check_gbuffer(const Settings& s, const DeviceLimits& limits, std::vector<Problem>& out) {
  const Shading shading = shading_of(s.lights.method);
  if (shading == Shading::forward) {
    if (s.antialias != Antialias::none)
      out.push_back(
          {ProblemId::antialias_needs_gbuffer, "antialias",
           fmt::format("{} reads a G-buffer, and forward shading has none; choose none", row(s.antialias).id)});
    return;
  }
  const bool alpha = shading == Shading::deferred && layout_of(s).alpha_marks;
  if (s.background.skip == BackgroundSkip::alpha && !alpha)
    out.push_back({ProblemId::alpha_not_stored, "background.skip",
                   fmt::format("the {} layout stores no alpha that marks a surface; choose depth, or the layout nclgl, "
                               "objectid or viewspace with a deferred method",
                               layout_of(s).axis.id)});
  if (shading == Shading::light_prepass && s.accumulation.targets == AccumulationTargets::one)
    out.push_back({ProblemId::prepass_needs_split, "accumulation.targets",
                   "deferred lighting does not know the albedo yet when it sums light; choose split"});
  int targets = 0;
  if (s.layout != Layout::auto_ || !s.layout_file.empty())
    for (const Attachment& a : attachments(s)) targets += a.written_by == Pass::geometry && a.stores != Stores::depth;
  if (targets > limits.max_draw_buffers)
    out.push_back(
        {ProblemId::too_many_targets, "layout",
         fmt::format("{} colour targets in one pass, and this driver draws into {}; choose a smaller layout, or "
                     "position.source=depth",
                     targets, limits.max_draw_buffers)});
}

// A depth test keeps one side of the volumes; drawn with it, the other side's faces light what is not inside.
void check_volumes(const Settings& s, std::vector<Problem>& out) {
  if (needs_stencil(s) && s.depth.format == DepthFormat::d16)
    out.push_back({ProblemId::stencil_needs_d24, "depth.format",
                   fmt::format("d16 has no room for the stencil buffer that {} needs; choose d24 or d32f",
                               s.lights.method == LightMethod::volumes_stencil ? "lights.method=volumes-stencil"
                                                                               : "background.skip=stencil")});
  const VolumeDepth depth = s.lights.volume.depth;
  if (!draws_chosen_faces(s.lights.method)) return;
  const auto needs = [&](ProblemId id, LightCull cull, const char* side) {
    if (s.lights.cull != cull)
      out.push_back({id, "lights.cull",
                     fmt::format("{} draws other faces than the {} faces that lights.volume.depth={} means; choose {}",
                                 row(s.lights.cull).id, side, row(depth).id, row(cull).id)});
  };
  if (depth == VolumeDepth::less_equal) needs(ProblemId::less_equal_needs_back, LightCull::back, "front");
  if (depth == VolumeDepth::greater_equal) needs(ProblemId::greater_equal_needs_front, LightCull::front, "back");
}

}  // namespace

const char* id_of(ProblemId id) {
  constexpr const char* kIds[] = {"not-finite",
                                  "size-above-limit",
                                  "far-not-beyond-near",
                                  "rig-not-read",
                                  "rig-not-named",
                                  "no-such-light",
                                  "stencil-needs-d24",
                                  "less-equal-needs-back",
                                  "greater-equal-needs-front",
                                  "feature-missing",
                                  "alpha-not-stored",
                                  "prepass-needs-split",
                                  "antialias-needs-gbuffer",
                                  "too-many-targets"};
  return kIds[static_cast<int>(id)];
}

std::vector<Problem> validate(const Settings& s, const DeviceLimits& limits) {
  std::vector<Problem> out;
  check_options(s, limits, out);
  check_gbuffer(s, limits, out);
  if (s.size.x > limits.max_size || s.size.y > limits.max_size)
    out.push_back({ProblemId::size_above_limit, "size",
                   fmt::format("{} is above this driver's limit of {} a side; choose a smaller size", size_text(s.size),
                               limits.max_size)});
  if (!(s.camera.far > s.camera.near))
    out.push_back({ProblemId::far_not_beyond_near, "camera.far",
                   fmt::format("{:g} is not beyond camera.near {:g}; make it larger", s.camera.far, s.camera.near)});
  const bool reads_rig = s.lights.source == LightSource::rig;
  if (!reads_rig && !s.lights.rig.empty())
    out.push_back({ProblemId::rig_not_read, "lights.rig", "is set, but lights.source does not read a rig; clear it"});
  if (reads_rig && s.lights.rig.empty())
    out.push_back({ProblemId::rig_not_named, "lights.rig", "lights.source is rig, but no file is named; name one"});
  if (s.lights.source == LightSource::generated && s.lights.only >= s.lights.count)
    out.push_back({ProblemId::no_such_light, "lights.only",
                   fmt::format("{} is not below lights.count {}; choose -1 for all", s.lights.only, s.lights.count)});
  check_volumes(s, out);
  return out;
}

Nearest nearest_with(const FeatureSet& features, Settings s) {
  Nearest out{std::move(s), {}};
  for (const Option& o : options()) {
    if (o.kind != Kind::choice) continue;
    const ValueRow& asked = o.values[chosen(o, out.settings)];
    if (features.has(asked.needs)) continue;
    cycle(o, out.settings, -1, features);
    out.sentences.push_back(fmt::format("{}: {} stands in for {}, which needs {}", o.path,
                                        o.values[chosen(o, out.settings)].id, asked.id, name_of(asked.needs)));
  }
  return out;
}

void require_valid(const Settings& s, const DeviceLimits& limits) {
  const std::vector<Problem> problems = validate(s, limits);
  if (problems.empty()) return;
  const Problem& p = problems.front();
  throw Error(ExitCode::bad_input, p.path, fmt::format("{} [{}]", p.sentence, id_of(p.id)));
}

}  // namespace gbl
