// Where light volumes fail, band by band; the catalogue's own proofs stand in tests/study/pitfalls.
#include "renderer/lessons/lessons.h"
#include "tests/pitfalls/judged.h"

namespace gbl::test {
namespace {

class MethodPitfalls : public GlTest {};

constexpr double kSeen = 1.0 / 255;  // less light than this is not missed by anybody

struct Score {
  int lit = 0;      // pixels that are lit visibly by the reference
  int lost = 0;     // of these, with less than half the light
  int doubled = 0;  // with twice the light
  int other = 0;    // with neither that nor the same light, to what float32 leaves of both
  bool right() const { return lit > 0 && lost == 0 && doubled == 0 && other == 0; }
  bool all_lost() const { return lit > 0 && lost == lit; }
  bool all_doubled() const { return lit > 0 && doubled == lit; }
};

std::ostream& operator<<(std::ostream& out, const Score& s) {
  return out << fmt::format("{} pixels lit, {} lost, {} doubled, {} otherwise wrong", s.lit, s.lost, s.doubled,
                            s.other);
}

constexpr double kFloat32 = 0.01;  // relative, float32 against double: 0.005 where light grazes, mostly 1e-5

// These settings against the reference; the light alone, stored and summed in float32.
Score score(const Settings& settings, const GpuScene& scene) {
  Settings s = light_alone(settings);
  s.size = {160, 90};
  s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::split};
  s.layout = Layout::float32;
  s.normal.encoding = NormalEncoding::xyz32f;
  s.position.source = PositionSource::view32f;
  const std::vector<glm::dvec3>& truth = truth_of(s, scene)->truth.lit;
  Stage& stage = shared_stage(scene);
  stage.draw(s);
  const std::vector<glm::vec3> got = read_lit(stage.targets);
  Score out;
  for (size_t i = 0; i < got.size(); ++i) {
    const glm::dvec3 g = got[i], t = truth[i];
    if (std::max({t.x, t.y, t.z}) <= kSeen) continue;
    ++out.lit;
    const double ratio = (g.x + g.y + g.z) / (t.x + t.y + t.z);
    if (ratio < 0.5)
      ++out.lost;
    else if (std::abs(ratio - 2) < 2 * kFloat32)
      ++out.doubled;
    else if (std::abs(ratio - 1) > kFloat32)
      ++out.other;
  }
  return out;
}

Settings start_with(LightCull cull, int only = 37) {
  Settings s = preset("start").make();
  s.lights.cull = cull;
  s.lights.only = only;
  return s;
}

Settings from_outside(LightCull cull) {
  Settings s = preset("nclgl-fixed").make();
  s.camera.position = {2056, 1500, 4612};
  s.camera.orientation = orientation_from_yaw_pitch(0, -40);
  s.lights.cull = cull;
  s.lights.only = 28;
  return s;
}

Settings less_equal(Settings s) {
  s.lights.volume.depth = VolumeDepth::less_equal;
  s.lights.volume.clip = VolumeClip::none;
  return s;
}

Settings lesson_step(size_t k) {
  Settings s = settings_at(load_lesson("three-ways-to-lose-a-light"), k);
  s.lights.only = 37;
  return s;
}

// Of a light in the yard whose volume's rim crosses ground and walls.
Settings yard_rim(VolumeFit fit) {
  Settings s = settings_for(yard());
  s.camera.position = {20, 45, 20};
  s.camera.orientation = orientation_from_yaw_pitch(0, -90);
  s.lights.count = 4, s.lights.only = 3, s.lights.range_scale = 0.6;
  s.lights.volume.level = VolumeLevel::l0;
  s.lights.volume.fit = fit;
  return s;
}

Settings far_plane_through_volume(VolumeClip clip) {
  Settings s = start_with(LightCull::front);
  s.lights.volume.clip = clip;
  s.camera.far = 700;  // the light's far side is 950 away
  return s;
}

// One light of range 10 in the yard, at (20, 3, 20).
Settings yard_light(LightMethod method, const glm::dvec3& camera, double yaw, double pitch) {
  Settings s = settings_for(yard());
  s.lights.count = 1, s.lights.range_scale = 0.25;
  s.lights.method = method;
  s.camera.position = camera;
  s.camera.orientation = orientation_from_yaw_pitch(yaw, pitch);
  return s;
}

// The camera looks at the light from 1.3 times its range: the outline is 1 / sqrt(1 - (r/d)^2) as wide as the disc.
Settings before_the_light(LightMethod method) { return yard_light(method, {20, 5, 33}, 0, -9); }

// The light is to the right of the camera and a little behind it, but reaches into the picture.
Settings beside_the_light(LightMethod method) { return yard_light(method, {11, 3, 17.5}, 0, -25); }

TEST_F(MethodPitfalls, BackfaceCullInsideLosesTheWholeLight) {
  for (const VolumeClip clip : {VolumeClip::none, VolumeClip::planes}) {
    Settings s = start_with(LightCull::back);
    s.lights.volume.clip = clip;
    EXPECT_TRUE(score(s, terrain()).all_lost()) << score(s, terrain());
    s.lights.cull = LightCull::flip_safe;
    EXPECT_TRUE(score(s, terrain()).right()) << score(s, terrain());
  }
  const Score outside = score(from_outside(LightCull::back), terrain());
  EXPECT_TRUE(outside.right()) << outside;  // from outside it is as good as any
}

// Front faces before the surface: right from outside, and as lost from inside as without the depth test.
TEST_F(MethodPitfalls, LessEqualLosesTheLightThatTheCameraIsInsideOf) {
  for (const LightMethod method : {LightMethod::volumes, LightMethod::volumes_instanced}) {
    Settings s = less_equal(start_with(LightCull::back));
    s.lights.method = method;
    const Score inside = score(s, terrain());
    EXPECT_TRUE(inside.all_lost()) << inside;
    s = less_equal(from_outside(LightCull::back));
    s.lights.method = method;
    const Score outside = score(s, terrain());
    EXPECT_TRUE(outside.right()) << outside;
    s = start_with(LightCull::front);
    s.lights.method = method;
    s.lights.volume.depth = VolumeDepth::greater_equal;  // the fix
    const Score fixed = score(s, terrain());
    EXPECT_TRUE(fixed.right()) << fixed;
  }
}

TEST_F(MethodPitfalls, NoCullingDoublesFromOutsideAndOnlyThere) {
  const Score outside = score(from_outside(LightCull::none), terrain());
  EXPECT_TRUE(outside.all_doubled()) << outside;
  const Score fixed = score(from_outside(LightCull::front), terrain());
  EXPECT_TRUE(fixed.right()) << fixed;
  const Score inside = score(start_with(LightCull::none), terrain());
  EXPECT_TRUE(inside.right()) << inside;
}

TEST_F(MethodPitfalls, NearPlaneCutsTheFrontOfAVolumeWeStandBefore) {
  const Score flip = score(lesson_step(2), terrain());
  EXPECT_TRUE(flip.all_lost()) << flip;
  const Score safe = score(lesson_step(3), terrain());
  EXPECT_TRUE(safe.right()) << safe;
}

TEST_F(MethodPitfalls, FlipForgetsThatTheMeshIsLargerThanTheSphere) {
  const Score flip = score(lesson_step(4), terrain());
  EXPECT_TRUE(flip.all_lost()) << flip;
  const Score safe = score(lesson_step(5), terrain());
  EXPECT_TRUE(safe.right()) << safe;
}

// All the way out of a volume: flip-safe never loses a pixel; flip loses all of them in one narrow band, where the
// sphere is between camera and near plane.
TEST_F(MethodPitfalls, FlipFailsInTheBandThatIsStatedAndFlipSafeNowhere) {
  Settings s = settings_for(yard());
  s.lights.count = 1, s.lights.range_scale = 0.125;  // range 5 about (20, 3, 20)
  s.lights.volume.clip = VolumeClip::planes;
  s.lights.volume.level = VolumeLevel::l4;
  s.camera.near = 1;
  const glm::dvec3 light(20, 3, 20), outwards = glm::normalize(glm::dvec3(1, 0.5, -1));
  s.camera.orientation = orientation_from_yaw_pitch(135, -glm::degrees(std::asin(outwards.y)));
  for (const double gap : {-1.0, -0.3, 0.01, 0.4, 0.9, 1.4, 3.0}) {
    s.camera.position = light + outwards * (5 + gap);
    s.lights.cull = LightCull::flip_safe;
    const Score safe = score(s, yard());
    EXPECT_TRUE(safe.right()) << gap << ": " << safe;
    s.lights.cull = LightCull::flip;
    const Score flip = score(s, yard());
    EXPECT_TRUE(gap > 0 && gap < s.camera.near ? flip.all_lost() : flip.right()) << gap << ": " << flip;
  }
}

TEST_F(MethodPitfalls, InscribedMeshCutsNotchesIntoTheRim) {
  const Score inscribed = score(yard_rim(VolumeFit::inscribed), yard());
  EXPECT_GT(inscribed.lost, inscribed.lit / 50) << inscribed;
  EXPECT_LT(inscribed.lost, inscribed.lit);
  const Score circumscribed = score(yard_rim(VolumeFit::circumscribed), yard());
  EXPECT_TRUE(circumscribed.right()) << circumscribed;
}

TEST_F(MethodPitfalls, FarPlaneClipsBackFaces) {
  const Score clipped = score(far_plane_through_volume(VolumeClip::planes), terrain());
  EXPECT_GT(clipped.lost, clipped.lit / 2) << clipped;
  const Score whole = score(far_plane_through_volume(VolumeClip::none), terrain());
  EXPECT_TRUE(whole.right()) << whole;
}

// The near part of the sphere bulges out of the disc through its middle: its rim stays dark, where the light is near.
TEST_F(MethodPitfalls, FlatCircleUndercoversTheNearRim) {
  const Score near = score(before_the_light(LightMethod::disc), yard());
  EXPECT_GT(near.lost, near.lit / 20) << near;
  EXPECT_LT(near.lost, near.lit) << near;
  EXPECT_EQ(near.doubled + near.other, 0) << near;
  Settings s = before_the_light(LightMethod::disc);
  s.camera.position += 60.0 * glm::dvec3(0, 0.155, 1);
  s.camera.fov = 15;
  const Score far = score(s, yard());
  EXPECT_LT(far.lost * near.lit, near.lost * far.lit / 4) << "from afar it is nearly enough: " << far;
  for (const LightMethod fixed : {LightMethod::volumes, LightMethod::quads})
    EXPECT_TRUE(score(before_the_light(fixed), yard()).right()) << score(before_the_light(fixed), yard());
}

// `circle-behind-camera`: x / w of what is behind the camera lands on the other side of the picture.
TEST_F(MethodPitfalls, AFlatCircleBehindTheCameraIsMirrored) {
  const Score mirrored = score(beside_the_light(LightMethod::disc), yard());
  EXPECT_GT(mirrored.lost, mirrored.lit / 4) << mirrored;
  for (const LightMethod fixed : {LightMethod::volumes, LightMethod::quads})
    EXPECT_TRUE(score(beside_the_light(fixed), yard()).right()) << score(beside_the_light(fixed), yard());
}

}  // namespace
}  // namespace gbl::test
