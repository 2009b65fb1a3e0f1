#include "renderer/passes/programs.h"

#include <cctype>

#include "renderer/options.h"

namespace gbl {
namespace {

struct SamplerUnit {
  const char* name;
  Unit unit;
};
constexpr SamplerUnit kSamplers[] = {
    {"gbuffer_material", kMaterialUnit},
    {"gbuffer_normal", kNormalUnit},
    {"gbuffer_depth", kDepthUnit},
    {"light_data", kLightUnit},
    {"light_lists", kLightListUnit},
    {"light_diffuse", kDiffuseUnit},
    {"light_specular", kSpecularUnit},
    {"light_sum", kDiffuseUnit},
    {"lit", kLitUnit},
    {"counts", kCountUnit},
    {"counts_lit", kLitUnit},
    {"base_colour_map", kBaseColourUnit},
    {"normal_map", kNormalMapUnit},
    {"roughness_map", kRoughnessUnit},
    {"emissive_map", kEmissiveUnit},
    {"occlusion_map", kOcclusionUnit},
    {"instance_data", kInstanceUnit},
    {"gbuffer_reflectance", kReflectanceUnit},
    {"gbuffer_emission", kEmissionUnit},
};

std::string constant_name(const char* prefix, const char* id) {
  std::string name = prefix;
  for (const char* c = id; *c; ++c) name += *c == '-' ? '_' : static_cast<char>(std::toupper(*c));
  return name;
}

// NORMAL_ENCODING = the chosen value, and NORMAL_OCT16, NORMAL_XYZ8, … = each row's value.
template <class E>
void append_axis(gl::Defines& out, const char* name, const char* prefix, E chosen_value) {
  out.push_back({name, static_cast<int>(chosen_value)});
  for (const ValueRow& r : rows<E>()) out.push_back({constant_name(prefix, r.id), r.value});
}

// Every program sees these constants.
void append_common(gl::Defines& out) {
  for (const ViewRow& v : views()) out.push_back({constant_name("VIEW_", v.id), static_cast<int>(v.view)});
  out.push_back({"OUTPUT_SPLIT", static_cast<int>(LightOutput::split)});
  out.push_back({"OUTPUT_SUM", static_cast<int>(LightOutput::sum)});
  out.push_back({"OUTPUT_COUNT", static_cast<int>(LightOutput::count)});
}

}  // namespace

gl::Defines gbuffer_defines(const Settings& s) {
  gl::Defines out;
  append_axis(out, "LAYOUT", "LAYOUT_", s.layout);
  append_axis(out, "NORMAL_ENCODING", "NORMAL_", s.normal.encoding);
  append_axis(out, "POSITION_RECONSTRUCT", "RECONSTRUCT_", s.position.reconstruct);
  append_axis(out, "COLOUR", "COLOUR_", s.colour);
  append_axis(out, "SHADING_MODEL", "MODEL_", s.shading.model);
  append_axis(out, "ATTENUATION", "ATTENUATION_", s.attenuation);
  return out;
}

gl::Program ProgramCache::compile(const Variant& v) {
  gl::Defines defines = v.defines;
  append_common(defines);
  const gl::ShaderText fragment = gl::load_shader(v.fragment, defines);
  gl::Program program = v.vertex.empty() ? gl::compile_compute_program(fragment)
                                         : gl::compile_program(gl::load_shader(v.vertex, defines), fragment);
  glUseProgram(program.id());
  for (const SamplerUnit& s : kSamplers) glUniform1i(program.uniform(s.name), s.unit);
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

const gl::Program& ProgramCache::get(Variant v) {
  const auto found = programs_.find(v);
  if (found != programs_.end()) return found->second;
  gl::Program program = compile(v);
  return programs_.emplace(std::move(v), std::move(program)).first->second;
}

void ProgramCache::reload() {
  std::map<Variant, gl::Program> fresh;
  for (const auto& [variant, old] : programs_) fresh.emplace(variant, compile(variant));
  programs_ = std::move(fresh);
}

}  // namespace gbl
