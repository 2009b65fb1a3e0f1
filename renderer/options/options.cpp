#include "renderer/options/options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/gbuffer/layout_file.h"

namespace gbl {

enum class View;  // its rows stand above this room, in renderer/inspect/views.cpp

namespace {

[[noreturn]] void bad_value(const Option& o, const OptionValue& v, std::string_view expected) {
  throw Error(ExitCode::bad_input, o.path, fmt::format("{} is not {}", written(v), expected));
}

double checked_number(const Option& o, const OptionValue& v) {
  const auto* n = std::get_if<Number>(&v);
  if (!n || !std::isfinite(n->value)) bad_value(o, v, "a finite number");
  const double x = n->value;
  if (x < o.min || x > o.max)
    bad_value(o, v, fmt::format("in {:g} ... {:g}{}{}", o.min, o.max, *o.unit ? " " : "", o.unit));
  return x;
}

double checked_whole(const Option& o, const OptionValue& v) {
  const double x = checked_number(o, v);
  if (x != std::floor(x)) bad_value(o, v, "a whole number");
  return x;
}

int checked_integer(const Option& o, const OptionValue& v) { return static_cast<int>(checked_whole(o, v)); }

const OptionList& checked_list(const Option& o, const OptionValue& v, size_t size) {
  const auto* list = std::get_if<OptionList>(&v);
  if (!list || list->size() != size) bad_value(o, v, fmt::format("an array of {} numbers", size));
  return *list;
}

const std::string& checked_text(const Option& o, const OptionValue& v) {
  const auto* text = std::get_if<std::string>(&v);
  if (!text) bad_value(o, v, "a text in quotes");
  if (!writable(*text)) bad_value(o, v, "UTF-8");  // no settings file could hold it
  return *text;
}

// A path alone means the file as it is now; settings that were written name its content, too.
std::string checked_layout_file(const Option& o, const OptionValue& v) {
  const std::string& name = checked_text(o, v);
  return name.empty() || names_content(name) ? name : name_unasked_layout_file(name);
}

template <class E>
E checked_choice(const Option& o, const OptionValue& v) {
  if (const auto* id = std::get_if<std::string>(&v)) return static_cast<E>(parse_id(o.values, *id, o.path));
  // `lights.volume.level=2` arrives as a number: ids that are digits are ids all the same.
  const auto* n = std::get_if<Number>(&v);
  if (!n || !n->whole) bad_value(o, v, "the id of a value");
  return static_cast<E>(parse_id(o.values, written(v), o.path));
}

// Accessors: one for reading, one for writing, from the same member expression.
#define GET(expr) [](const Settings& s) -> OptionValue { return expr; }
#define SET(...) [](Settings& s, const OptionValue& v, const Option& o) { __VA_ARGS__; }
#define CHOICE(E, member)                                                  \
  .kind = Kind::choice, .values = rows<E>(), .get = GET(row(s.member).id), \
  .set = SET(s.member = checked_choice<E>(o, v))
#define NUMBER(member, lo, hi) \
  .kind = Kind::number, .min = lo, .max = hi, .get = GET(s.member), .set = SET(s.member = checked_number(o, v))
#define INTEGER(member, lo, hi) \
  .kind = Kind::integer, .min = lo, .max = hi, .get = GET(s.member), .set = SET(s.member = checked_integer(o, v))
#define TEXT(member) .kind = Kind::text, .get = GET(s.member), .set = SET(s.member = checked_text(o, v))

OptionList vec3_list(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 checked_vec3(const Option& o, const OptionValue& v) {
  const OptionList& list = checked_list(o, v, 3);
  return {checked_number(o, list[0]), checked_number(o, list[1]), checked_number(o, list[2])};
}

glm::dvec2 checked_pair(const Option& o, const OptionValue& v) {
  const OptionList& list = checked_list(o, v, 2);
  return {checked_number(o, list[0]), checked_number(o, list[1])};
}

glm::ivec2 checked_size(const Option& o, const OptionValue& v) {
  const OptionList& list = checked_list(o, v, 2);
  return {checked_integer(o, list[0]), checked_integer(o, list[1])};
}

OptionList quaternion_list(const glm::dquat& q) { return {q.x, q.y, q.z, q.w}; }
glm::dquat checked_quaternion(const Option& o, const OptionValue& v) {
  const OptionList& list = checked_list(o, v, 4);
  std::array<double, 4> xyzw{};
  for (size_t i = 0; i < xyzw.size(); ++i) xyzw[i] = checked_number(o, list[i]);
  const glm::dquat q(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  const double length = glm::length(q);
  if (!(length > 1e-6)) bad_value(o, v, "a rotation (its length is 0)");
  // A unit quaternion is kept to the bit, so that a state read back equals the state written.
  return std::abs(length - 1) < 1e-12 ? q : q / length;
}

OptionValue exponent_value(const Settings& s) {
  if (s.shading.exponent == kExponentFromRoughness) return "from-roughness";
  return s.shading.exponent;
}
double checked_exponent(const Option& o, const OptionValue& v) {
  const auto* text = std::get_if<std::string>(&v);
  if (!text) return checked_number(o, v);
  if (*text != "from-roughness") bad_value(o, v, "a number or \"from-roughness\"");
  return kExponentFromRoughness;
}

// Of things that are written as VIEW:...
template <class T>
OptionList list_of(const std::vector<T>& of_views) {
  OptionList out;
  for (const T& one : of_views) out.emplace_back(text_of(one));
  return out;
}

std::string known_view(const Option& o, std::string_view id) {
  const std::span<const ValueRow> views = rows<View>();
  return views[static_cast<size_t>(parse_id(views, id, o.path, "view"))].id;
}

std::string checked_view(const Option& o, const OptionValue& v) { return known_view(o, checked_text(o, v)); }

Looks checked_looks(const Option& o, const OptionValue& v) {
  const auto* list = std::get_if<OptionList>(&v);
  if (!list) bad_value(o, v, "an array of looks");
  Looks out;
  for (const OptionValue& part : *list) {
    LookOf l = parse_look(checked_text(o, part), o.path);
    set_look(out, known_view(o, l.view), std::move(l.look));
  }
  return out;
}

std::vector<LookOf> checked_panels(const Option& o, const OptionValue& v) {
  constexpr size_t kPlaces = 8;
  const auto* list = std::get_if<OptionList>(&v);
  if (!list || list->size() > kPlaces) bad_value(o, v, "an array of 8 panels at most");
  std::vector<LookOf> out;
  for (const OptionValue& part : *list) {
    out.push_back(parse_look(checked_text(o, part), o.path));
    out.back().view = known_view(o, out.back().view);
  }
  if (!out.empty() && !out[0].look.plain())
    throw Error(ExitCode::bad_input, o.path, fmt::format("'{}': the first panel is the large one", text_of(out[0])),
                "give its look in view.looks, or lock a later panel");
  return out;
}

Overlays checked_overlays(const Option& o, const OptionValue& v) {
  const auto* list = std::get_if<OptionList>(&v);
  if (!list) bad_value(o, v, "an array of overlays");
  Overlays out;
  for (const OptionValue& part : *list) {
    const Overlay one = parse_overlay(checked_text(o, part), o.path);
    set_overlay(out, known_view(o, one.view), one.opacity);
  }
  return out;
}

std::set<Mistake> checked_mistakes(const Option& o, const OptionValue& v) {
  const auto* list = std::get_if<OptionList>(&v);
  if (!list) bad_value(o, v, "an array of ids");
  std::set<Mistake> chosen_ones;
  for (const OptionValue& part : *list) {
    const auto* id = std::get_if<std::string>(&part);
    if (!id) bad_value(o, v, "an array of ids");
    chosen_ones.insert(mistake_by_id(*id));
  }
  return chosen_ones;
}

OptionList list_of(const std::vector<std::string>& ids) { return OptionList(ids.begin(), ids.end()); }

constexpr double kFar = 1e9;  // world units; a bound for numbers that only have to be sane

std::string method_in_words(const Settings& s) { return fmt::format("method {}", row(s.lights.method).label); }

// Where nothing is stored, how it is stored means nothing.
bool stores_surfaces(const Settings& s) { return shading_of(s.lights.method) != Shading::forward; }

constexpr Use kByGbuffer = {stores_surfaces, method_in_words};
constexpr Use kByReconstruction = {
    [](const Settings& s) { return stores_surfaces(s) && s.position.source == PositionSource::depth; },
    [](const Settings& s) {
      return s.position.source == PositionSource::depth
                 ? method_in_words(s)
                 : fmt::format("position source {}", row(s.position.source).label);
    }};
// The stencil method draws both faces against the depth, whatever is chosen: to it only the mesh means something.
constexpr Use kByChosenFaces = {[](const Settings& s) { return draws_chosen_faces(s.lights.method); }, method_in_words,
                                true};
constexpr Use kByMeshes = {[](const Settings& s) { return facts(s.lights.method).draws_meshes; }, method_in_words,
                           true};
constexpr Use kByNormalMaps = {[](const Settings& s) { return s.normal_map == NormalMap::on; },
                               [](const Settings&) -> std::string { return "a frame without normal maps"; }};
constexpr Use kByThreshold = {[](const Settings& s) { return s.range.kind == RangeKind::threshold; },
                              [](const Settings& s) { return fmt::format("range {}", row(s.range.kind).label); }};

constexpr Use kByReflections = {
    [](const Settings& s) { return s.reflections != Reflections::off; },
    [](const Settings& s) { return fmt::format("reflections {}", row(s.reflections).label); }};
constexpr Use kByHeightMaps = {
    [](const Settings& s) { return s.height_map == HeightMap::on; },
    [](const Settings& s) { return fmt::format("height maps {}", row(s.height_map).label); }};
constexpr Use kByTessellation = {
    [](const Settings& s) { return s.height_map == HeightMap::on && s.tessellation.mode != TessellationMode::off; },
    [](const Settings& s) {
      return s.height_map == HeightMap::on ? std::string("meshes that stay as they are")
                                           : fmt::format("height maps {}", row(s.height_map).label);
    }};
constexpr Use kByParallax = {
    [](const Settings& s) { return s.height_map == HeightMap::on && s.parallax.method != ParallaxMethod::none; },
    [](const Settings& s) {
      return s.height_map == HeightMap::on ? std::string("surfaces that stay flat")
                                           : fmt::format("height maps {}", row(s.height_map).label);
    }};
constexpr Use kByShadows = {[](const Settings& s) { return s.shadows != Shadows::off; },
                            [](const Settings& s) { return fmt::format("shadows {}", row(s.shadows).label); }};

// clang-format off
const Option kOptions[] = {
  {.path = "scene", .group = Group::truth, .label = "Scene", .help = "builtin:NAME, or a model's file", TEXT(scene)},
  {.path = "camera.position", .group = Group::truth, .label = "Camera position", .help = "world units", .unit = "units", .kind = Kind::vector, .min = -kFar, .max = kFar, .get = GET(vec3_list(s.camera.position)), .set = SET(s.camera.position = checked_vec3(o, v))},
  {.path = "camera.orientation", .group = Group::truth, .label = "Camera orientation", .help = "quaternion x, y, z, w: world from view", .kind = Kind::vector, .min = -kFar, .max = kFar, .get = GET(quaternion_list(s.camera.orientation)), .set = SET(s.camera.orientation = checked_quaternion(o, v))},
  {.path = "camera.fov", .group = Group::truth, .label = "Field of view", .help = "vertical", .unit = "degrees", NUMBER(camera.fov, 1, 170)},
  {.path = "camera.orthographic-height", .group = Group::truth, .label = "Orthographic height", .help = "0 = perspective", .unit = "units", NUMBER(camera.orthographic_height, 0, kFar)},
  {.path = "camera.aspect", .group = Group::truth, .label = "Whole aspect", .help = "width : height shown whole, as a model's camera asks; 0 = the height alone counts", NUMBER(camera.aspect, 0, 1000)},
  {.path = "camera.near", .group = Group::truth, .label = "Near plane", .help = "distance along the view axis", .unit = "units", NUMBER(camera.near, 1e-6, kFar)},
  {.path = "camera.far", .group = Group::truth, .label = "Far plane", .help = "distance along the view axis", .unit = "units", NUMBER(camera.far, 1e-6, kFar)},
  {.path = "time_s", .group = Group::truth, .label = "Time", .help = "lights move as functions of it", .unit = "s", NUMBER(time_s, 0, kFar)},
  {.path = "size", .group = Group::truth, .label = "Size", .help = "width and height of the frame", .unit = "pixels", .kind = Kind::vector, .min = 1, .max = 16384, .get = GET((OptionList{s.size.x, s.size.y})), .set = SET(s.size = checked_size(o, v))},
  {.path = "lights.source", .group = Group::truth, .label = "Lights from", .help = "where the lights come from", CHOICE(LightSource, lights.source)},
  {.path = "lights.rig", .group = Group::truth, .label = "Lighting rig", .help = "a rig's file; needs a light source that reads it", TEXT(lights.rig)},
  {.path = "lights.count", .group = Group::truth, .label = "Lights", .help = "how many lights are generated", .key = "[ ]", INTEGER(lights.count, 0, kMaxLights), .implies = [](Settings& s) { s.lights.source = LightSource::generated; }},
  {.path = "lights.seed", .group = Group::truth, .label = "Seed", .help = "of the generated lights' colours and places", .kind = Kind::integer, .min = 0, .max = 4294967295.0, .get = GET(s.lights.seed), .set = SET(s.lights.seed = static_cast<unsigned>(checked_whole(o, v)))},
  {.path = "lights.range-scale", .group = Group::truth, .label = "Range scale", .help = "multiplies every light's range", NUMBER(lights.range_scale, 1e-3, 1e3)},
  {.path = "lights.only", .group = Group::truth, .label = "Only light", .help = "this light alone; -1 = all", INTEGER(lights.only, -1, kMaxLights - 1)},
  {.path = "lights.first", .group = Group::truth, .label = "First lights", .help = "the first k lights; -1 = all", INTEGER(lights.first, -1, kMaxLights)},
  {.path = "lights.spot", .group = Group::truth, .label = "Spot edge", .help = "how a spot light ends sideways", CHOICE(LightSpot, lights.spot)},
  {.path = "lights.markers", .group = Group::truth, .label = "Light cubes", .help = "forward draws after the lighting: they need the scene's depth", CHOICE(LightMarkers, lights.markers)},
  {.path = "attenuation", .group = Group::truth, .label = "Attenuation", .help = "how light falls off with distance", .key = "T", CHOICE(Attenuation, attenuation)},
  {.path = "range.kind", .group = Group::truth, .label = "Range", .help = "where a light ends", .key = "R", CHOICE(RangeKind, range.kind)},
  {.path = "range.threshold", .group = Group::truth, .label = "Range threshold", .help = "where range.kind=threshold ends a light", NUMBER(range.threshold, 1e-6, 1), .use = &kByThreshold},
  {.path = "shading.model", .group = Group::truth, .label = "Shading", .help = "the surface's reflection", .key = "K", CHOICE(ShadingModel, shading.model)},
  {.path = "shading.exponent", .group = Group::truth, .label = "Exponent", .help = "of the highlight: a number, or from-roughness (2/roughness^4 - 2, the lobe normalised)", .kind = Kind::number, .min = 0, .max = 8192, .get = exponent_value, .set = SET(s.shading.exponent = checked_exponent(o, v))},
  {.path = "shading.specular", .group = Group::truth, .label = "Specular", .help = "factor of the highlight", NUMBER(shading.specular, 0, 100)},
  {.path = "shadows", .group = Group::truth, .label = "Shadows", .help = "which lights are hidden by what stands in their way", CHOICE(Shadows, shadows)},
  {.path = "reflections", .group = Group::truth, .label = "Reflections", .help = "whether smooth surfaces mirror the scene", CHOICE(Reflections, reflections)},
  {.path = "ambient", .group = Group::truth, .label = "Ambient", .help = "light from everywhere, times the albedo", NUMBER(ambient, 0, 1e6)},
  {.path = "background.fill", .group = Group::truth, .label = "Background", .help = "what is seen where no surface is", CHOICE(BackgroundFill, background.fill)},
  {.path = "background.colour", .group = Group::truth, .label = "Background colour", .help = "linear, for background.fill=colour", .kind = Kind::vector, .min = 0, .max = 1e6, .get = GET(vec3_list(s.background.colour)), .set = SET(s.background.colour = checked_vec3(o, v))},
  {.path = "normal-map", .group = Group::truth, .label = "Normal maps", .help = "bend the shading normal by the material's map", CHOICE(NormalMap, normal_map)},
  {.path = "height-map", .group = Group::truth, .label = "Height maps", .help = "sink the surface below its triangles by the material's map", CHOICE(HeightMap, height_map)},
  {.path = "tessellation.mode", .group = Group::truth, .label = "Tessellation", .help = "whether height maps make triangles; the reference is then of these triangles", CHOICE(TessellationMode, tessellation.mode), .use = &kByHeightMaps},
  {.path = "tessellation.level", .group = Group::truth, .label = "Tessellation level", .help = "pieces that an edge is cut into, at most", INTEGER(tessellation.level, 1, 64), .use = &kByTessellation},
  {.path = "albedo", .group = Group::truth, .label = "Albedo", .help = "the surface's own colour, or white", CHOICE(AlbedoSource, albedo)},
  {.path = "exposure", .group = Group::truth, .label = "Exposure", .help = "factor before the display transform; unlit surfaces are shown as they are", NUMBER(exposure, 1e-6, 1e6)},
  {.path = "colour", .group = Group::truth, .label = "Colour", .help = "how texels are read and the picture is shown", CHOICE(Colour, colour)},
  {.path = "layout", .group = Group::method, .label = "Layout", .help = "how the material is packed", .key = "L", .kind = Kind::choice, .values = rows<Layout>(), .get = GET(row(s.layout).id), .set = SET(s.layout = checked_choice<Layout>(o, v); s.layout_file.clear()), .use = &kByGbuffer},
  {.path = "layout-file", .group = Group::method, .label = "Layout file", .help = "a layout of your own, drawn in the place of layout: one GLSL file, as --layout-file takes it", .kind = Kind::text, .get = GET(s.layout_file), .set = SET(s.layout_file = checked_layout_file(o, v)), .use = &kByGbuffer},
  {.path = "normal.encoding", .group = Group::method, .label = "Normal", .help = "how the normal is stored", .key = "N", CHOICE(NormalEncoding, normal.encoding), .use = &kByGbuffer},
  {.path = "normal.space", .group = Group::method, .label = "Normal space", .help = "the axes that normals are stored along", CHOICE(NormalSpace, normal.space), .use = &kByGbuffer},
  {.path = "position.source", .group = Group::method, .label = "Position source", .help = "where the lighting gets its position", CHOICE(PositionSource, position.source), .use = &kByGbuffer},
  {.path = "position.reconstruct", .group = Group::method, .label = "Position", .help = "how depth becomes a position", .key = "Z", CHOICE(PositionReconstruct, position.reconstruct), .use = &kByReconstruction},
  {.path = "depth.format", .group = Group::method, .label = "Depth format", .help = "of the depth attachment", CHOICE(DepthFormat, depth.format)},
  {.path = "lights.method", .group = Group::method, .label = "Method", .help = "which (pixel, light) pairs are shaded", .key = "M", CHOICE(LightMethod, lights.method)},
  {.path = "lights.cull", .group = Group::method, .label = "Cull", .help = "which faces of a light volume are drawn", .key = "C", CHOICE(LightCull, lights.cull), .use = &kByChosenFaces},
  {.path = "lights.volume.level", .group = Group::method, .label = "Volume level", .help = "icosphere subdivisions", CHOICE(VolumeLevel, lights.volume.level), .use = &kByMeshes},
  {.path = "lights.volume.fit", .group = Group::method, .label = "Volume fit", .help = "mesh inside or around the sphere", CHOICE(VolumeFit, lights.volume.fit), .use = &kByMeshes},
  {.path = "lights.volume.clip", .group = Group::method, .label = "Volume clip", .help = "whether near and far planes cut a volume", CHOICE(VolumeClip, lights.volume.clip), .use = &kByChosenFaces},
  {.path = "lights.volume.depth", .group = Group::method, .label = "Volume depth test", .help = "whether a volume is tested against the scene's depth", CHOICE(VolumeDepth, lights.volume.depth), .use = &kByChosenFaces},
  {.path = "accumulation.format", .group = Group::method, .label = "Accumulation", .help = "what light is kept in", .key = "F", CHOICE(AccumulationFormat, accumulation.format), .use = &kByGbuffer},
  {.path = "accumulation.targets", .group = Group::method, .label = "Light targets", .help = "what light is summed into between passes", CHOICE(AccumulationTargets, accumulation.targets), .use = &kByGbuffer},
  {.path = "background.skip", .group = Group::method, .label = "Background skip", .help = "how pixels without a surface are left out", CHOICE(BackgroundSkip, background.skip), .use = &kByGbuffer},
  {.path = "shadow.map-size", .group = Group::method, .label = "Shadow map", .help = "texels to a side", CHOICE(ShadowMapSize, shadow.map_size), .use = &kByShadows},
  {.path = "shadow.format", .group = Group::method, .label = "Shadow format", .help = "of the maps' depth", CHOICE(ShadowFormat, shadow.format), .use = &kByShadows},
  {.path = "shadow.cull", .group = Group::method, .label = "Shadow faces", .help = "which faces hide the light", CHOICE(ShadowCull, shadow.cull), .use = &kByShadows},
  {.path = "shadow.filter", .group = Group::method, .label = "Shadow filter", .help = "how a map is read", CHOICE(ShadowFilter, shadow.filter), .use = &kByShadows},
  {.path = "shadow.bias", .group = Group::method, .label = "Shadow bias", .help = "a point is moved towards the light before it is compared", .unit = "texels", NUMBER(shadow.bias, 0, 1000), .use = &kByShadows},
  {.path = "shadow.slope-bias", .group = Group::method, .label = "Slope bias", .help = "the same, times the tangent of the angle between light and normal", .unit = "texels", NUMBER(shadow.slope_bias, 0, 1000), .use = &kByShadows},
  {.path = "shadow.normal-offset", .group = Group::method, .label = "Normal offset", .help = "a point is moved along its normal before it is compared", .unit = "texels", NUMBER(shadow.normal_offset, 0, 1000), .use = &kByShadows},
  {.path = "shadow.cascades", .group = Group::method, .label = "Cascades", .help = "maps of a sun, each for a part of the depth", INTEGER(shadow.cascades, 1, 4), .use = &kByShadows},
  {.path = "shadow.stable", .group = Group::method, .label = "Stable cascades", .help = "how a sun's maps follow the camera", CHOICE(ShadowStable, shadow.stable), .use = &kByShadows},
  {.path = "shadow.point", .group = Group::method, .label = "Map of a point light", .help = "which of its six maps is read", CHOICE(ShadowPoint, shadow.point), .use = &kByShadows},
  {.path = "shadow.reach", .group = Group::method, .label = "Shadow planes", .help = "near and far plane of the maps of points and spots", CHOICE(ShadowReach, shadow.reach), .use = &kByShadows},
  {.path = "shadow.update", .group = Group::method, .label = "Shadow update", .help = "when maps are drawn", CHOICE(ShadowUpdate, shadow.update), .use = &kByShadows},
  {.path = "shadow.max-lights", .group = Group::method, .label = "Shadowed lights", .help = "so many lights have maps, suns first; light of the others passes through everything", INTEGER(shadow.max_lights, 0, 256), .use = &kByShadows},
  {.path = "reflect.method", .group = Group::method, .label = "Mirrors", .help = "where the mirrored scene comes from", CHOICE(ReflectMethod, reflect.method), .use = &kByReflections},
  {.path = "reflect.size", .group = Group::method, .label = "Mirror cube", .help = "size of its six pictures", CHOICE(ReflectSize, reflect.size), .use = &kByReflections},
  {.path = "reflect.parallax", .group = Group::method, .label = "Cube's parallax", .help = "how a cube is read from beside its middle", CHOICE(ReflectParallax, reflect.parallax), .use = &kByReflections},
  {.path = "parallax.method", .group = Group::method, .label = "Parallax", .help = "how the line of sight is followed into a height map", CHOICE(ParallaxMethod, parallax.method), .use = &kByHeightMaps},
  {.path = "parallax.steps", .group = Group::method, .label = "Parallax steps", .help = "from the highest place to the lowest", INTEGER(parallax.steps, 1, 1024), .use = &kByParallax},
  {.path = "parallax.depth", .group = Group::method, .label = "Parallax depth", .help = "what is stored of where the line of sight ends", CHOICE(ParallaxDepth, parallax.depth), .use = &kByParallax},
  {.path = "tangents", .group = Group::method, .label = "Tangents", .help = "where tangent frames come from", CHOICE(Tangents, tangents), .use = &kByNormalMaps},
  {.path = "antialias", .group = Group::method, .label = "Antialiasing", .help = "of edges", CHOICE(Antialias, antialias)},
  {.path = "draw-order", .group = Group::method, .label = "Draw order", .help = "of the objects in the geometry pass", CHOICE(DrawOrder, draw_order)},
  {.path = "mistakes", .group = Group::method, .label = "Mistakes", .help = "deliberate errors, by id", .kind = Kind::set, .get = GET(list_of(ids_of(s.mistakes))), .set = SET(s.mistakes = checked_mistakes(o, v))},
  {.path = "view.main", .group = Group::view, .label = "Main view", .help = "the view shown large, by id", .kind = Kind::text, .get = GET(s.view.main), .set = SET(s.view.main = checked_view(o, v))},
  {.path = "view.volumes", .group = Group::view, .label = "Light volumes", .help = "wires over the main view", .key = "V", CHOICE(VolumeOverlay, view.volumes)},
  {.path = "view.pick", .group = Group::view, .label = "Picked light", .help = "index of the light that wires, I and captions speak of", INTEGER(view.pick, 0, kMaxLights - 1)},
  {.path = "view.object", .group = Group::view, .label = "Picked object", .help = "number of the object that is outlined and named, from 1; 0 = none", INTEGER(view.object, 0, 1 << 24)},
  {.path = "view.error.of", .group = Group::view, .label = "Error of", .help = "what the error view compares with the reference", .key = "Y", CHOICE(ErrorOf, view.error.of)},
  {.path = "view.error.scale", .group = Group::view, .label = "Error scale", .help = "how far off, or which way", CHOICE(ErrorScale, view.error.scale)},
  {.path = "view.error.range", .group = Group::view, .label = "Error range", .help = "where the error's colour bar ends, in its unit; 0 = where 99.9 % of the pixels are within it", NUMBER(view.error.range, 0, kFar)},
  {.path = "view.zoom", .group = Group::view, .label = "Zoom", .help = "of every panel; 1 = the whole picture", NUMBER(view.zoom, 1, 16384)},
  {.path = "view.centre", .group = Group::view, .label = "Centre", .help = "of what a panel shows, 0..1 across the picture from its top left", .kind = Kind::vector, .min = 0, .max = 1, .get = GET(OptionList({s.view.centre.x, s.view.centre.y})), .set = SET(s.view.centre = checked_pair(o, v))},
  {.path = "view.looks", .group = Group::view, .label = "Looks", .help = "how views turn numbers into colours: VIEW:BLACK..WHITE or :fit, :CHANNELS, :MAP, :srgb or :linear; or :raw, the stored codes", .kind = Kind::set, .get = GET(list_of(s.view.looks)), .set = SET(s.view.looks = checked_looks(o, v))},
  {.path = "view.overlays", .group = Group::view, .label = "Overlays", .help = "views laid over the main view, each as VIEW or VIEW:OPACITY, from the lowest to the topmost", .kind = Kind::set, .get = GET(list_of(s.view.overlays)), .set = SET(s.view.overlays = checked_overlays(o, v))},
  {.path = "view.panels", .group = Group::view, .label = "Panels", .help = "views of the first page by place, the first one large; with a look as in view.looks a panel is locked: it keeps that look", .kind = Kind::set, .get = GET(list_of(s.view.panels)), .set = SET(s.view.panels = checked_panels(o, v))},
};
// clang-format on
#undef TEXT
#undef INTEGER
#undef NUMBER
#undef CHOICE
#undef SET
#undef GET

}  // namespace

std::span<const Option> options() { return kOptions; }

const Option& option(std::string_view path) {
  std::vector<std::string_view> known;
  for (const Option& o : kOptions) {
    if (o.path == path) return o;
    known.push_back(o.path);
  }
  throw Error(ExitCode::bad_input, path, "unknown option", suggest(path, known));
}

void apply_patch(Settings& s, const std::vector<Assignment>& patch, std::string_view where) {
  Settings changed = s;
  try {
    for (const Assignment& a : patch) {
      const Option& o = option(a.path);
      o.set(changed, a.value, o);
    }
  } catch (const Error& e) {
    throw Error(e.code(), where, e.what());
  }
  s = std::move(changed);
}

int chosen(const Option& o, const Settings& s) { return parse_id(o.values, std::get<std::string>(o.get(s)), o.path); }

bool in_use(const Option& o, const Settings& s) { return !o.use || o.use->now(s); }

void cycle(const Option& o, Settings& s, int step, FeatureSet available) {
  const int n = static_cast<int>(o.values.size());
  int i = chosen(o, s);
  do i = (i + step + n) % n;
  while (!available.has(o.values[i].needs));
  o.set(s, o.values[i].id, o);
}

std::string_view group_id(Group g) {
  constexpr const char* kIds[] = {"truth", "method", "view"};
  return kIds[static_cast<int>(g)];
}

}  // namespace gbl
