#pragma once
// Settings: a value. Equal settings on the same machine give the same picture. Nobody else holds options.
// Members are the words of the paths in options.h, in snake_case; defaults stand at the member.
#include <glm/glm.hpp>
#include <set>
#include <string>
#include <vector>

#include "renderer/base/limits.h"
#include "renderer/gbuffer/gbuffer_axes.h"
#include "renderer/gbuffer/layouts.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "renderer/light/light_axes.h"
#include "renderer/light/light_methods.h"
#include "renderer/options/axes.h"
#include "renderer/options/overlays.h"
#include "renderer/options/view_look.h"
#include "renderer/pitfalls/mistakes.h"
#include "renderer/scene/camera.h"

namespace gbl {

inline constexpr int kSettingsVersion = 1;

// Blinn-Phong exponent: a number >= 0, or from the surface's roughness (2/roughness^4 - 2, in 1..8192).
inline constexpr double kExponentFromRoughness = -1;

struct Settings {
  // ---- what is true: the reference depends on these and on nothing else ----
  std::string scene = "builtin:terrain";
  Camera camera;
  double time_s = 0;
  glm::ivec2 size{1280, 720};

  struct Lights {
    LightSource source = LightSource::generated;
    std::string rig;  // a lighting rig's file; empty = none
    int count = 64;   // 0..kMaxLights
    unsigned seed = 1;
    double range_scale = 1;  // multiplies every light's range
    int only = -1;           // this light alone; -1 = all
    int first = -1;          // the first k lights; -1 = all
    LightSpot spot = LightSpot::cone;
    LightMarkers markers = LightMarkers::off;
    LightMethod method = LightMethod::volumes;
    LightCull cull = LightCull::flip_safe;
    struct Volume {
      VolumeLevel level = VolumeLevel::l2;
      VolumeFit fit = VolumeFit::circumscribed;
      VolumeClip clip = VolumeClip::none;
      VolumeDepth depth = VolumeDepth::none;
      bool operator==(const Volume&) const = default;
    } volume;
    bool operator==(const Lights&) const = default;
  } lights;

  Attenuation attenuation = Attenuation::linear;
  struct Range {
    RangeKind kind = RangeKind::source;
    double threshold = 5.0 / 256;
    bool operator==(const Range&) const = default;
  } range;
  struct Shading {
    ShadingModel model = ShadingModel::blinn_phong;
    double exponent = kExponentFromRoughness;
    double specular = 0.04;  // factor of the highlight
    bool operator==(const Shading&) const = default;
  } shading;
  Shadows shadows = Shadows::off;
  Reflections reflections = Reflections::off;
  double ambient = 0.2;
  struct Background {
    BackgroundFill fill = BackgroundFill::grey;
    glm::dvec3 colour{0.2};  // linear
    BackgroundSkip skip = BackgroundSkip::depth;
    bool operator==(const Background&) const = default;
  } background;
  NormalMap normal_map = NormalMap::on;
  HeightMap height_map = HeightMap::off;
  struct Tessellation {
    TessellationMode mode = TessellationMode::off;
    int level = 16;
    bool operator==(const Tessellation&) const = default;
  } tessellation;
  AlbedoSource albedo = AlbedoSource::textured;
  double exposure = 1;
  Colour colour = Colour::srgb;

  // ---- how it is drawn: whatever these drop, round, clamp or miss is error ----
  Layout layout = Layout::albedo_roughness;
  std::string layout_file;  // a user's, drawn in the place of `layout`: "PATH@HASH" (layout_file.h); empty: none
  struct Normal {
    NormalEncoding encoding = NormalEncoding::oct16;
    NormalSpace space = NormalSpace::world;
    bool operator==(const Normal&) const = default;
  } normal;
  struct Position {
    PositionSource source = PositionSource::depth;
    PositionReconstruct reconstruct = PositionReconstruct::view_ray;
    bool operator==(const Position&) const = default;
  } position;
  struct Depth {
    DepthFormat format = DepthFormat::d32f;
    bool operator==(const Depth&) const = default;
  } depth;
  struct Accumulation {
    AccumulationFormat format = AccumulationFormat::rgba16f;
    AccumulationTargets targets = AccumulationTargets::split;
    bool operator==(const Accumulation&) const = default;
  } accumulation;
  struct Shadow {  // biases in texels of the map, so that one value serves every scene
    ShadowMapSize map_size = ShadowMapSize::s1024;
    ShadowFormat format = ShadowFormat::d32f;
    ShadowCull cull = ShadowCull::none;
    ShadowFilter filter = ShadowFilter::bilinear;
    double bias = 0.5;         // towards the light
    double slope_bias = 1.5;   // … times the tangent of the light's angle to the normal
    double normal_offset = 0;  // along the normal
    int cascades = 3;          // maps of a sun
    ShadowStable stable = ShadowStable::on;
    ShadowPoint point = ShadowPoint::axis;
    ShadowReach reach = ShadowReach::fitted;
    ShadowUpdate update = ShadowUpdate::changed;
    int max_lights = 8;  // that have maps
    bool operator==(const Shadow&) const = default;
  } shadow;
  struct Reflect {
    ReflectMethod method = ReflectMethod::planar;
    ReflectSize size = ReflectSize::s256;
    ReflectParallax parallax = ReflectParallax::none;
    bool operator==(const Reflect&) const = default;
  } reflect;
  struct Parallax {
    ParallaxMethod method = ParallaxMethod::occlusion;
    int steps = 32;
    ParallaxDepth depth = ParallaxDepth::displaced;
    bool operator==(const Parallax&) const = default;
  } parallax;
  Tangents tangents = Tangents::vertex;
  Antialias antialias = Antialias::none;
  DrawOrder draw_order = DrawOrder::near_far;
  std::set<Mistake> mistakes;

  // ---- what is looked at ----
  struct View {
    std::string main = "final";  // a view's id
    VolumeOverlay volumes = VolumeOverlay::off;
    int pick = 0;    // the picked light's index
    int object = 0;  // the picked object's number, from 1; 0: none
    struct Error {
      ErrorOf of = ErrorOf::final;
      ErrorScale scale = ErrorScale::magnitude;
      double range = 0;  // where the colour bar ends, in the quantity's unit; 0: fitted
      bool operator==(const Error&) const = default;
    } error;
    double zoom = 1;              // of every panel; 1: the whole picture
    glm::dvec2 centre{0.5, 0.5};  // of what a panel shows, 0..1 across the picture, origin top left
    Looks looks;                  // of views that are not shown as they show themselves
    Overlays overlays;            // views laid over the one that is looked at
    std::vector<LookOf> panels;   // the views of the first page by place; empty: the usual ones. With a look: locked
    bool operator==(const View&) const = default;
  } view;

  bool operator==(const Settings&) const = default;
};

// The truth alone: two settings with equal truth share one reference picture.
bool same_truth(const Settings&, const Settings&);

// The same with nothing hidden from a light, mirrored or sunk: what is left is what a G-buffer stores.
Settings lit_alone(Settings);

// Sorted, as files and messages name them.
std::vector<std::string> ids_of(const std::set<Mistake>&);

// The layout that is meant: the row, or what the user's file says. Error(bad_input): it cannot be read, or was changed.
const LayoutRow& layout_of(const Settings&);
std::string layout_shader_of(const Settings&);  // below shaders/

// Every unsound choice by its path and the failure it shows; empty = sound.
struct Unsound {
  std::string path, value, pitfall;
};
std::vector<Unsound> unsound_choices(const Settings&);
// The same with the default, which is sound, in the place of every unsound choice.
Settings cured(const Settings&);
inline bool sound(const Settings& s) { return unsound_choices(s).empty(); }

}  // namespace gbl
