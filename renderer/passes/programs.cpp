#include "renderer/passes/programs.h"

#include <algorithm>
#include <cctype>

#include "renderer/gbuffer/layouts.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "renderer/options/options.h"
#include "renderer/pitfalls/mistakes.h"

namespace gbl {
namespace {

std::string constant_name(const char* prefix, const char* id) {
  std::string name = prefix;
  for (const char* c = id; *c; ++c) name += *c == '-' ? '_' : static_cast<char>(std::toupper(*c));
  return name;
}

// The define that holds the draw buffer of what the geometry pass writes; null: it never does, or in no draw buffer.
const char* draw_buffer_name(Stores what) {
  switch (what) {
    case Stores::material: return "STORED_MATERIAL";
    case Stores::normal: return "STORED_NORMAL";
    case Stores::reflectance: return "STORED_REFLECTANCE";
    case Stores::emission: return "STORED_EMISSION";
    case Stores::ambient: return "STORED_AMBIENT";
    case Stores::shininess: return "STORED_SHININESS";
    case Stores::id: return "STORED_ID";
    case Stores::position: return "STORED_POSITION";
    case Stores::light: return "STORED_LIGHT";
    case Stores::depth:
    case Stores::diffuse_light:
    case Stores::specular_light:
    case Stores::light_depth:
    case Stores::lit: break;
  }
  return nullptr;
}

void append_mistakes(gl::Defines& out, const Settings& s, MistakeIn where) {
  for (const MistakeRow& m : mistakes())
    if (m.in == where) out.push_back({constant_name("MISTAKE_", m.id), s.mistakes.count(m.mistake) > 0});
}

// The encoding's functions by name, and how its code lies in a texel: the shader knows no list of encodings.
void append_encoding(gl::Defines& out, NormalEncoding e) {
  std::string name = row(e).id;
  std::replace(name.begin(), name.end(), '-', '_');
  out.push_back({"ENCODE_NORMAL", "encode_" + name});
  out.push_back({"DECODE_NORMAL", "decode_" + name});
  out.push_back({"NORMAL_CHANNELS", row_of(e).channels});
  out.push_back({"NORMAL_BITS", row_of(e).bits_per_channel});
  out.push_back({"NORMAL_STORAGE", static_cast<int>(row_of(e).storage())});
  out.push_back({"STORAGE_UNORM8", static_cast<int>(NormalStorage::unorm8)});
  out.push_back({"STORAGE_UINTS", static_cast<int>(NormalStorage::uints)});
  out.push_back({"STORAGE_WORD", static_cast<int>(NormalStorage::word)});
  out.push_back({"STORAGE_FLOATS", static_cast<int>(NormalStorage::floats)});
}

// Every program sees these constants.
void append_common(gl::Defines& out) {
  out.push_back({"MATERIAL_VIEW_ROUGHNESS", static_cast<int>(MaterialView::roughness)});
  out.push_back({"OUTPUT_SPLIT", static_cast<int>(LightOutput::split)});
  out.push_back({"OUTPUT_SUM", static_cast<int>(LightOutput::sum)});
  out.push_back({"OUTPUT_COUNT", static_cast<int>(LightOutput::count)});
  out.push_back({"OUTPUT_LIT", static_cast<int>(LightOutput::lit)});
}

}  // namespace

void append_choice(gl::Defines& out, const char* name, const char* prefix, std::span<const ValueRow> table,
                   int chosen) {
  out.push_back({name, chosen});
  for (const ValueRow& r : table) out.push_back({constant_name(prefix, r.id), r.value});
}

gl::Defines gbuffer_defines(const ResolvedFrame& f) {
  const Settings& s = f.settings;
  gl::Defines out;
  const LayoutRow& layout = layout_of(s);
  out.push_back({"LAYOUT_FILE", f.shading == Shading::light_prepass ? kThinLayoutShader : layout_shader_of(s)});
  append_encoding(out, s.normal.encoding);
  append_axis(out, "NORMAL_SPACE", "SPACE_", s.normal.space);
  append_axis(out, "POSITION_SOURCE", "POSITION_", s.position.source);
  append_axis(out, "POSITION_RECONSTRUCT", "RECONSTRUCT_", s.position.reconstruct);
  append_axis(out, "BACKGROUND_SKIP", "SKIP_", s.background.skip);
  append_axis(out, "COLOUR", "COLOUR_", s.colour);
  append_axis(out, "SHADING_MODEL", "MODEL_", s.shading.model);
  int draw_buffer = 0;
  for (const Attachment& a : f.attachments)
    if (const char* name = a.written_by == Pass::geometry ? draw_buffer_name(a.stores) : nullptr)
      out.push_back({name, draw_buffer++});
  out.push_back({"MATERIAL_WORDS", layout.words && f.shading == Shading::deferred});
  out.push_back({"MATERIAL_FLOATS", layout.floats});
  out.push_back({"NORMAL_IN_MATERIAL", f.normal_in_material});
  out.push_back({"DEPTH_REVERSED", f.depth_runs == DepthRuns::reversed});
  out.push_back({"MATERIAL_VIEW", static_cast<int>(layout.shows)});
  append_mistakes(out, s, MistakeIn::shading);
  return out;
}

void append_light_defines(gl::Defines& out, const ResolvedFrame& f) {
  const Settings& s = f.settings;
  append_axis(out, "ATTENUATION", "ATTENUATION_", s.attenuation);
  out.push_back({"LIGHT_KINDS", f.light_kinds});
  out.push_back({"MANY_LIGHTS", f.many_lights});
  out.push_back({"RANGE_WINDOWED", s.range.kind == RangeKind::windowed});
  const bool shadows = !f.shadows.maps.empty();
  out.push_back({"SHADOWS", shadows});
  if (shadows) {
    append_axis(out, "SHADOW_FILTER", "SHADOW_FILTER_", s.shadow.filter);
    // A map that stands still does not follow its light: where the light was, only the map's matrix tells.
    const bool tries = s.shadow.point == ShadowPoint::brute_force || s.shadow.update == ShadowUpdate::once;
    out.push_back({"SHADOW_TRIES_FACES", tries});
    out.push_back({"SHADOW_TEXELS", f.shadows.map_texels});
    out.push_back({"SHADOW_CASCADES", s.shadow.cascades});
  }
  out.push_back({"SPOT_COS_POWER", s.lights.spot == LightSpot::cos_power});
}

void append_surface_defines(gl::Defines& out, const Settings& s, bool emission_kept) {
  append_axis(out, "TANGENTS", "TANGENTS_", s.tangents);
  if (s.height_map == HeightMap::on) {
    append_axis(out, "PARALLAX_METHOD", "PARALLAX_", s.parallax.method);
    append_axis(out, "PARALLAX_DEPTH", "PARALLAX_DEPTH_", s.parallax.depth);
  }
  out.push_back({"EMISSION_KEPT", emission_kept});
  append_mistakes(out, s, MistakeIn::surface);
}

// In the order of Vertex, which the buffer is then an array of.
constexpr const char* kCaptured[] = {"captured_position", "captured_normal", "captured_tangent",
                                     "captured_uv0",      "captured_uv1",    "captured_colour"};

ProgramCache::Stages ProgramCache::read(const Variant& v) {
  gl::Defines defines = v.defines;
  append_common(defines);
  Stages out;
  if (!v.tessellation.empty()) {
    for (const char* stage : {".vert", ".tesc", ".tese"})
      out.push_back(gl::load_shader(v.tessellation + stage, defines));
    return out;
  }
  if (!v.vertex.empty()) out.push_back(gl::load_shader(v.vertex, defines));
  out.push_back(gl::load_shader(v.fragment, defines));
  return out;
}

size_t ProgramCache::hash(const Stages& stages) {
  std::string all;
  for (const gl::ShaderText& s : stages) all += s.body;
  return std::hash<std::string>{}(all);
}

gl::Program ProgramCache::compile(const Variant& v, const Stages& s) {
  ++compiled_;
  if (!v.tessellation.empty()) return gl::compile_tessellation_program(s[0], s[1], s[2], kCaptured);
  gl::Program program = s.size() == 1 ? gl::compile_compute_program(s[0]) : gl::compile_program(s[0], s[1]);
  const GLuint block = glGetUniformBlockIndex(program.id(), "FrameBlock");
  if (block != GL_INVALID_INDEX) glUniformBlockBinding(program.id(), block, 0);
  return program;
}

const gl::Program& ProgramCache::get(std::string_view vertex, std::string_view fragment, const gl::Defines& defines) {
  return get({std::string(vertex), std::string(fragment), defines});
}

const gl::Program& ProgramCache::get_compute(std::string_view file, const gl::Defines& defines) {
  return get({"", std::string(file), defines});
}

const gl::Program& ProgramCache::get_tessellation(std::string_view name, const gl::Defines& defines) {
  return get({.defines = defines, .tessellation = std::string(name)});
}

const gl::Program& ProgramCache::get(Variant v) {
  auto found = programs_.find(v);
  if (found == programs_.end()) {
    const Stages stages = read(v);
    gl::Program program = compile(v, stages);
    if (programs_.size() >= kMost) forget_oldest();
    found = programs_.emplace(std::move(v), Kept{std::move(program), hash(stages)}).first;
  }
  found->second.used = ++uses_;
  return found->second.program;
}

void ProgramCache::forget_oldest() {
  programs_.erase(std::min_element(programs_.begin(), programs_.end(),
                                   [](const auto& a, const auto& b) { return a.second.used < b.second.used; }));
}

void ProgramCache::reload() {
  std::map<Variant, Kept> fresh;
  for (const auto& [variant, old] : programs_) {
    const Stages stages = read(variant);
    const size_t text = hash(stages);
    if (text != old.text) fresh.emplace(variant, Kept{compile(variant, stages), text, old.used});
  }
  for (auto& [variant, program] : fresh) programs_.at(variant) = std::move(program);
  ++reloads_;
}

}  // namespace gbl
