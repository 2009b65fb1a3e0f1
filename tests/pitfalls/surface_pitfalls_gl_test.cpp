// Every unsound row of the axes that store and rebuild surfaces, and every mistake by id, fails in the way it names; the
// fixed settings do not.
#include <functional>

#include "renderer/options/options.h"
#include "renderer/options/settings_json.h"
#include "renderer/pitfalls/mistakes.h"
#include "tests/pitfalls/judged.h"

namespace gbl::test {
namespace {

class SurfacePitfalls : public GlTest {};

// Everything that is stored is stored in float32: what is left of an error is the failure's.
Settings exact_settings(const GpuScene& scene, glm::ivec2 size = {160, 90}) {
  Settings s = settings_for(scene, size);
  s.layout = Layout::float32;
  s.normal.encoding = NormalEncoding::xyz32f;
  s.position.source = PositionSource::view32f;
  return s;
}

// Lengths of the normals as they are stored: of no concern to the reference, whose normals are unit by definition, so a
// proof by length compares with 1.
std::vector<double> stored_lengths(const Settings& s, const GpuScene& scene) {
  Stage& stage = shared_stage(scene);
  stage.draw(s);
  std::vector<double> out;
  for (const glm::vec4& n : picture_of(*stage.targets.frame.texture(Stores::normal)).texels)
    if (const double length = glm::length(glm::dvec3(n)); length > 0) out.push_back(length);
  return out;
}

double mean_angle(const Settings& s, const GpuScene& scene) { return errors_of(s, scene).normal_deg_mean.value(); }

// A ball squashed to a quarter of its height.
const GpuScene& squashed() {
  static const GpuScene scene = [] {
    Scene s = make_yard();
    s.instances[3].world_from_object =
        s.instances[3].world_from_object * glm::dmat4(glm::dmat3(1, 0, 0, 0, 0.25, 0, 0, 0, 1));
    return GpuScene(std::make_shared<const Scene>(std::move(s)));
  }();
  return scene;
}

const GpuScene& grove() {
  static const GpuScene scene(std::make_shared<const Scene>(build_grove()));
  return scene;
}

Settings grove_settings(Tangents tangents) {
  Settings s = preset("viewspace-fixed").make();
  s.size = {160, 90};
  s.layout = Layout::float32;
  s.normal = {NormalEncoding::xyz32f, NormalSpace::world};
  s.background.skip = BackgroundSkip::depth;
  s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::split};
  s.tangents = tangents;
  return s;
}

Settings with(Settings s, Mistake mistake) {
  s.mistakes = {mistake};
  return s;
}

// The number that the failure is known by, of the broken settings and of the fixed ones, and what each must keep.
struct Proof {
  double broken, fixed;
  double at_least;  // the broken one's
  double at_most;   // the fixed one's: what the truth leaves to float32, or to the format that the proof needs
};

Proof background_shaded() {
  const auto lit_background = [](BackgroundSkip skip) {
    Settings s = exact_settings(yard());
    s.background.skip = skip;
    return errors_of(s, yard()).background_lit_pixels.value();
  };
  return {lit_background(BackgroundSkip::none), lit_background(BackgroundSkip::depth), 600, 0};
}

Proof tangents() {
  return {mean_angle(grove_settings(Tangents::matrix_columns), grove()),
          mean_angle(grove_settings(Tangents::vertex), grove()), 1, 1e-3};
}

Proof resolved_samples() {
  const auto odd_lengths = [](Antialias antialias) {
    Settings s = exact_settings(yard());
    s.antialias = antialias;
    double odd = 0;
    for (const double length : stored_lengths(s, yard())) odd += std::abs(length - 1) > 0.01;
    return odd;
  };
  return {odd_lengths(Antialias::msaa_resolved), odd_lengths(Antialias::none), 50, 0};
}

// Mean distance from the true point, with depth stored so well that the matrix is what is left: the fix is a view ray.
// Against one float inverse for all pixels the noise of the varyings is small (0.00068 for 0.00050), and with a worse
// depth it drowns: the reference shows that the inverse itself is the larger part of this failure.
Proof inverse_varying() {
  const auto mean_distance = [](PositionReconstruct reconstruct) {
    Settings s = settings_for(terrain(), {320, 180});
    s.depth.format = DepthFormat::d32f_reversed;
    s.position.reconstruct = reconstruct;
    return errors_of(s, terrain()).position_mean.value();
  };
  const double varying = mean_distance(PositionReconstruct::inverse_viewproj_varying);
  EXPECT_GT(varying, 1.2 * mean_distance(PositionReconstruct::inverse_viewproj))
      << "interpolation adds noise of its own";
  return {varying, mean_distance(PositionReconstruct::view_ray), 6e-4, 3e-4};
}

const std::map<std::string, std::function<Proof()>>& row_proofs() {
  static const std::map<std::string, std::function<Proof()>> proofs = {
      {"background.skip=none", background_shaded},
      {"tangents=matrix-columns", tangents},
      {"antialias=msaa-resolved", resolved_samples},
      {"position.reconstruct=inverse-viewproj-varying", inverse_varying},
  };
  return proofs;
}

// ---- mistakes ----------------------------------------------------------------------------------------------

Proof tilted_normals(Mistake mistake, const GpuScene& scene, double at_least) {
  const Settings s = exact_settings(scene);
  return {mean_angle(with(s, mistake), scene), mean_angle(s, scene), at_least, 1e-3};
}

// Triangles of some degrees only: the deficit is small, but it is there; a unit normal is one to 1e-6.
Proof short_normals() {
  Settings s = exact_settings(terrain());
  s.normal_map = NormalMap::off;
  const auto deficit = [](const Settings& drawn) {
    const std::vector<double> lengths = stored_lengths(drawn, terrain());
    return 1 - *std::min_element(lengths.begin(), lengths.end());
  };
  return {deficit(with(s, Mistake::interpolated_not_normalised)), deficit(s), 1e-4, 1e-6};
}

// Alpha is roughness there.
Proof blended_fill() {
  Settings s = settings_for(yard());
  const Compared c = against_truth(with(s, Mistake::blend_on_in_fill), yard()), f = against_truth(s, yard());
  return {double(c.darker), double(f.both()), 1000, 0};
}

// Codes of 8 bits are off in direction, too: by up to 4 codes of the picture; their lengths add more.
Proof lengths_of_codes() {
  Settings s = exact_settings(yard(), {320, 180});
  s.normal.encoding = NormalEncoding::xyz8;
  s.shading = {ShadingModel::blinn_phong, 256, 1};
  const Compared c = against_truth(with(s, Mistake::decode_not_normalised), yard(), 4), f = against_truth(s, yard(), 4);
  return {double(c.both()), double(f.both()), 20, 0};
}

Proof ungated_highlights() {
  Settings s = exact_settings(yard());
  s.shading = {ShadingModel::phong, 4, 0.5};
  const Compared c = against_truth(with(s, Mistake::specular_ungated), yard()), f = against_truth(s, yard());
  EXPECT_LE(c.darker, f.darker) << "it only ever adds light";
  return {double(c.brighter), double(f.both()), 50, 0};
}

Proof discs_of_light() {
  Settings s = exact_settings(yard());
  s.lights.count = 16;
  s.attenuation = Attenuation::none;
  const Compared c = against_truth(with(s, Mistake::volume_without_distance_test), yard()),
                 f = against_truth(s, yard());
  EXPECT_LE(c.darker, f.darker) << "it only ever adds light";
  return {double(c.brighter), double(f.both()), 200, 0};
}

Proof short_range() {
  Settings s = exact_settings(yard());
  s.attenuation = Attenuation::ramp;
  s.range.kind = RangeKind::threshold;
  const Compared c = against_truth(with(s, Mistake::range_shortcut), yard()), f = against_truth(s, yard());
  EXPECT_LE(c.brighter, f.brighter) << "it only ever loses light";
  return {double(c.darker), double(f.both()), 200, 0};
}

// The reference has no markers of lights, so none may be seen: the light stands behind the wall that fills the picture.
Proof markers_through_a_wall() {
  Settings s = exact_settings(yard());
  s.lights.markers = LightMarkers::on;
  s.lights.count = 1;
  s.camera.position = {20, 2, -4};
  s.camera.orientation = orientation_from_yaw_pitch(180, 0);
  s.camera.fov = 30;
  const Compared c = against_truth(with(s, Mistake::forward_without_depth), yard()), f = against_truth(s, yard());
  return {double(c.both()), double(f.both()), 50, 0};
}

const std::map<Mistake, std::function<Proof()>>& mistake_proofs() {
  static const std::map<Mistake, std::function<Proof()>> proofs = {
      {Mistake::tbn_precedence, [] { return tilted_normals(Mistake::tbn_precedence, terrain(), 1); }},
      {Mistake::interpolated_not_normalised, short_normals},
      {Mistake::nonuniform_scale_normal,
       [] { return tilted_normals(Mistake::nonuniform_scale_normal, squashed(), 0.3); }},
      {Mistake::blend_on_in_fill, blended_fill},
      {Mistake::decode_not_normalised, lengths_of_codes},
      {Mistake::specular_ungated, ungated_highlights},
      {Mistake::volume_without_distance_test, discs_of_light},
      {Mistake::range_shortcut, short_range},
      {Mistake::forward_without_depth, markers_through_a_wall},
  };
  return proofs;
}

void expect_proof(const std::string& name, const Proof& p) {
  EXPECT_GE(p.broken, p.at_least) << name;
  EXPECT_LE(p.fixed, p.at_most) << name << ": the fixed settings must not fail, too";
}

TEST_F(SurfacePitfalls, EveryUnsoundRowHasAProof) {
  for (const Option& o : options()) {
    const std::string_view path = o.path;
    // Proved by tests of their own: which pairs are shaded, and the encodings of normals.
    if (o.group != Group::method || path.starts_with("lights.") || path == "normal.encoding") continue;
    for (const ValueRow& r : o.values) {
      if (r.sound()) continue;
      const std::string name = fmt::format("{}={}", o.path, r.id);
      ASSERT_TRUE(row_proofs().count(name)) << name << " is unsound and nothing shows its " << id_of(r.pitfall);
      expect_proof(name, row_proofs().at(name)());
    }
  }
}

TEST_F(SurfacePitfalls, EveryMistakeHasAProof) {
  for (const MistakeRow& m : mistakes()) {
    ASSERT_TRUE(mistake_proofs().count(m.mistake)) << m.id;
    expect_proof(m.id, mistake_proofs().at(m.mistake)());
  }
}

// The headline bug is invisible on flat ground: turning (1, 1, 1) gives (1, 1, 1) there.
TEST_F(SurfacePitfalls, TbnPrecedenceIsHiddenByGroundWithoutANormalMap) {
  EXPECT_LE(mean_angle(with(exact_settings(yard()), Mistake::tbn_precedence), yard()), 1e-3);
}

}  // namespace
}  // namespace gbl::test
