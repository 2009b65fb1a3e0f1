#include "renderer/gl/program.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cstdio>
#include <fmt/format.h>
#include <sstream>

#include "renderer/base/error.h"
#include "renderer/base/resources.h"
#include "renderer/gl/device.h"
#include "renderer/gl/misuse.h"
#include "renderer/gl/texel_buffer.h"
#include "renderer/gl/texture_units.h"

namespace gbl::gl {
namespace {

// Tables (texel_buffer.h) are read by index alone.
#define GBL_CORE_WORDS                                                                                       \
  "#define real float\n#define HAS_CLIP_DISTANCE 1\n#define number_table samplerBuffer\n#define word_table " \
  "usamplerBuffer\n#define table_at "                                                                        \
  "texelFetch\n"
constexpr const char* kPrelude = "#version 330 core\n" GBL_CORE_WORDS;
constexpr const char* kComputePrelude = "#version 430 core\n" GBL_CORE_WORDS;
// Lines of the n-th file count from n times this: Mesa says of some errors that they are in file 0, whichever it is.
constexpr size_t kMostLines = 100'000;

constexpr const char* kTessellationPrelude = "#version 400 core\n" GBL_CORE_WORDS;
#undef GBL_CORE_WORDS

// There are no buffer textures, no planes that clip, and no interpolation across the screen.
constexpr const char* kEsPrelude = R"(#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
#define real float
#define HAS_CLIP_DISTANCE 0
#define number_table sampler2D
#define word_table usampler2D
vec4 table_at(number_table t, int i) { return texelFetch(t, ivec2(i & 2047, i >> 11), 0); }
uvec4 table_at(word_table t, int i) { return texelFetch(t, ivec2(i & 2047, i >> 11), 0); }
)";
static_assert(kTableWidth == 2048, "as table_at() has it");

const char* prelude_of(Kind stage) {
  if (device().api == Api::es3) return kEsPrelude;
  switch (stage) {
    case Kind::compute_shader: return kComputePrelude;
    case Kind::control_shader:
    case Kind::evaluation_shader: return kTessellationPrelude;
    default: return kPrelude;
  }
}

// The names in a text, in their order.
std::vector<std::string> names_in(std::string_view text) {
  const auto begins = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; };
  const auto goes_on = [&](char c) { return begins(c) || (c >= '0' && c <= '9'); };
  std::vector<std::string> names;
  for (size_t i = 0; i < text.size();) {
    size_t end = i;
    while (end < text.size() && goes_on(text[end])) ++end;
    if (begins(text[i])) names.emplace_back(text.substr(i, end - i));
    i = std::max(end, i + 1);
  }
  return names;
}

// The file of an #include line: in quotes, or the value of a define that stands there. Empty: the line is another.
std::string included_file(const std::string& line, const Defines& defines, std::string_view where) {
  constexpr std::string_view kInclude = "#include ";
  if (!line.starts_with(kInclude)) return "";
  const size_t begin = line.find('"'), end = line.find('"', begin + 1);
  if (begin != std::string::npos && end != std::string::npos) {
    const std::string file = line.substr(begin + 1, end - begin - 1);
    if (file.find("..") != std::string::npos)
      throw Error(ExitCode::bad_input, where, fmt::format("#include \"{}\" leaves the shaders' folder", file));
    return fmt::format("shaders/{}", file);
  }
  const std::vector<std::string> names = names_in(line.substr(kInclude.size()));
  if (names.empty()) return "";
  const auto named =
      std::find_if(defines.begin(), defines.end(), [&](const Define& d) { return d.name == names.front(); });
  if (named == defines.end())
    throw Error(ExitCode::bad_input, where, fmt::format("#include {}: no such define", names.front()));
  return fmt::format("shaders/{}", named->value);
}

void append_file(ShaderText& out, const std::string& name, const Defines& defines) {
  const size_t file = out.files.size();
  const auto line_marker = [&](int number) {
    return fmt::format("#line {} {}\n", file * kMostLines + static_cast<size_t>(number), file);
  };
  out.files.push_back(name);
  std::istringstream text(resource(name));
  out.body += line_marker(1);
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    const std::string included = included_file(line, defines, fmt::format("{}:{}", shown_name(name), number));
    if (included.empty()) {
      out.body += line + "\n";
      continue;
    }
    if (std::find(out.files.begin(), out.files.end(), included) == out.files.end()) append_file(out, included, defines);
    out.body += line_marker(number + 1);
  }
}

// "#define NAME 0" for each name of an #if that nothing defines and nothing asks "is it defined?" of. GLSL ES takes no such
// name.
std::string undefined_as_0(const std::string& text) {
  std::set<std::string> asked, known{"defined", "HAS_CLIP_DISTANCE"};
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const std::vector<std::string> names = names_in(line.substr(0, line.find("//")));
    if (names.size() < 2) continue;
    const std::string& directive = names.front();
    if (directive == "define" || directive == "ifdef" || directive == "ifndef") known.insert(names[1]);
    if (directive != "if" && directive != "elif") continue;
    asked.insert(names.begin() + 1, names.end());
    for (size_t i = 1; i + 1 < names.size(); ++i)
      if (names[i] == "defined") known.insert(names[i + 1]);
  }
  std::string out;
  for (const std::string& name : asked)
    if (!known.contains(name)) out += fmt::format("#define {} 0\n", name);
  return out;
}

// The driver's text in full: `length` is glGetShaderiv or glGetProgramiv, `log` the call that goes with it.
std::string info_log(GLuint id, decltype(glGetShaderiv) length, decltype(glGetShaderInfoLog) log) {
  GLint bytes = 0;  // with the 0 at the end
  length(id, GL_INFO_LOG_LENGTH, &bytes);
  std::string text(static_cast<size_t>(std::max(bytes, 1)), '\0');
  GLsizei written = 0;
  log(id, static_cast<GLsizei>(text.size()), &written, text.data());
  text.resize(static_cast<size_t>(written));
  return text;
}

template <Kind kStage>
Object<kStage> compile_stage(const ShaderText& text) {
  auto shader = Object<kStage>::make();
  const std::string zeros = device().api == Api::es3 ? undefined_as_0(text.body) : "";
  const char* parts[] = {prelude_of(kStage), zeros.c_str(), text.body.c_str()};
  glShaderSource(shader.id(), 3, parts, nullptr);
  glCompileShader(shader.id());
  GLint ok = 0;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
  if (!ok)
    throw Error(ExitCode::bad_input, "", readable_log(info_log(shader.id(), glGetShaderiv, glGetShaderInfoLog), text),
                "fix the shader; it is read again when saved");
  return shader;
}

// clang-format off
constexpr GLenum kSamplerTypes[] = {  // of GLSL 3.30
    GL_SAMPLER_1D, GL_SAMPLER_2D, GL_SAMPLER_3D, GL_SAMPLER_CUBE, GL_SAMPLER_1D_ARRAY, GL_SAMPLER_2D_ARRAY,
    GL_SAMPLER_2D_RECT, GL_SAMPLER_BUFFER, GL_SAMPLER_2D_MULTISAMPLE, GL_SAMPLER_2D_MULTISAMPLE_ARRAY,
    GL_SAMPLER_1D_SHADOW, GL_SAMPLER_2D_SHADOW, GL_SAMPLER_CUBE_SHADOW, GL_SAMPLER_1D_ARRAY_SHADOW,
    GL_SAMPLER_2D_ARRAY_SHADOW, GL_SAMPLER_2D_RECT_SHADOW,
    GL_INT_SAMPLER_1D, GL_INT_SAMPLER_2D, GL_INT_SAMPLER_3D, GL_INT_SAMPLER_CUBE, GL_INT_SAMPLER_1D_ARRAY,
    GL_INT_SAMPLER_2D_ARRAY, GL_INT_SAMPLER_2D_RECT, GL_INT_SAMPLER_BUFFER, GL_INT_SAMPLER_2D_MULTISAMPLE,
    GL_INT_SAMPLER_2D_MULTISAMPLE_ARRAY,
    GL_UNSIGNED_INT_SAMPLER_1D, GL_UNSIGNED_INT_SAMPLER_2D, GL_UNSIGNED_INT_SAMPLER_3D, GL_UNSIGNED_INT_SAMPLER_CUBE,
    GL_UNSIGNED_INT_SAMPLER_1D_ARRAY, GL_UNSIGNED_INT_SAMPLER_2D_ARRAY, GL_UNSIGNED_INT_SAMPLER_2D_RECT,
    GL_UNSIGNED_INT_SAMPLER_BUFFER, GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE,
    GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY};
// clang-format on

UniformNames declared_in(std::initializer_list<const ShaderText*> texts) {
  UniformNames all;
  if (kReportsMisuse)
    for (const ShaderText* t : texts) all.merge(declared_uniforms(t->body));
  return all;
}

// Each sampler that the program reads is told its unit.
void assign_units(GLuint program) {
  glUseProgram(program);
  GLint count = 0, longest = 0;
  glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  glGetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
  std::string name(static_cast<size_t>(longest), '\0');
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
    GLint elements = 0;
    GLenum type = 0;
    glGetActiveUniform(program, i, longest, nullptr, &elements, &type, name.data());
    if (std::find(std::begin(kSamplerTypes), std::end(kSamplerTypes), type) == std::end(kSamplerTypes)) continue;
    assert(elements == 1 && "a texture is bound to one name");
    glUniform1i(glGetUniformLocation(program, name.c_str()), unit_of(name.c_str()));
  }
}

}  // namespace

ShaderText load_shader(std::string_view name, const Defines& defines) {
  ShaderText out{std::string(name), "", {}};
  for (const Define& d : defines) out.body += fmt::format("#define {} {}\n", d.name, d.value);
  append_file(out, fmt::format("shaders/{}", name), defines);
  return out;
}

// Drivers write "0:12(3): error: …", "0(12) : error …" or "ERROR: 0:12: …".
std::string readable_log(std::string_view log, const ShaderText& text) {
  constexpr std::string_view kPrefix = "ERROR: ";
  std::istringstream lines{std::string(log)};
  for (std::string said; std::getline(lines, said);) {
    said.erase(0, said.find_first_not_of(" \t"));
    if (said.starts_with(kPrefix)) said.erase(0, kPrefix.size());
    size_t told = 0, line = 0;
    int end = 0;
    if (std::sscanf(said.c_str(), "%zu%*1[:(]%zu%n", &told, &line, &end) != 2) continue;
    const size_t colon = said.find(':', static_cast<size_t>(end));
    if (colon == std::string::npos || said.find("warning") != std::string::npos) continue;
    const size_t file = std::max(line / kMostLines, told), words = said.find_first_not_of(" \t", colon + 1);
    const std::string where = file < text.files.size() ? shown_name(text.files[file]) : text.name;
    return fmt::format("{}:{}: {}", where, line % kMostLines, words == std::string::npos ? "" : said.substr(words));
  }
  return fmt::format("{}: {}", text.name, log);
}

UniformNames declared_uniforms(std::string_view text) {
  UniformNames names;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    if (word != "uniform") continue;
    words >> word >> word;  // type and name
    names.insert(word.substr(0, word.find_first_of(";[")));
  }
  return names;
}

GLint Program::location(const char* name, bool may_be_unused) const {
  const auto found = locations_.find(std::string_view(name));
  if (found != locations_.end()) return found->second;
  const GLint location = glGetUniformLocation(id(), name);
  const bool declared = declared_.find(std::string_view(name)) != declared_.end();
  if (kReportsMisuse && location < 0 && !(may_be_unused && declared))
    report_misuse(fmt::format("{}: uniform '{}' is {}", label_, name, declared ? "not used" : "not declared"));
  return locations_.emplace(name, location).first->second;
}

GLint Program::uniform(const char* name) const { return location(name, false); }
GLint Program::find_uniform(const char* name) const { return location(name, true); }

Program link(std::string_view label, std::span<const GLuint> stages, UniformNames declared,
             std::span<const char* const> captured = {}) {
  Program p;
  p.name_ = Object<Kind::program>::make();
  p.label_ = label;
  p.declared_ = std::move(declared);
  for (const GLuint s : stages) glAttachShader(p.id(), s);
  if (!captured.empty())
    glTransformFeedbackVaryings(p.id(), static_cast<GLsizei>(captured.size()), captured.data(), GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(p.id());
  for (const GLuint s : stages) glDetachShader(p.id(), s);
  GLint ok = 0;
  glGetProgramiv(p.id(), GL_LINK_STATUS, &ok);
  if (!ok)
    throw Error(ExitCode::bad_input, fmt::format("shaders/{}", label),
                info_log(p.id(), glGetProgramiv, glGetProgramInfoLog));
  assign_units(p.id());
  set_label(GL_PROGRAM, p.id(), label);
  return p;
}

Program compile_program(const ShaderText& vertex, const ShaderText& fragment) {
  const auto first = compile_stage<Kind::vertex_shader>(vertex);
  const auto second = compile_stage<Kind::fragment_shader>(fragment);
  const GLuint stages[] = {first.id(), second.id()};
  return link(fmt::format("{} + {}", vertex.name, fragment.name), stages, declared_in({&vertex, &fragment}));
}

Program compile_compute_program(const ShaderText& text) {
  const auto stage = compile_stage<Kind::compute_shader>(text);
  const GLuint stages[] = {stage.id()};
  return link(text.name, stages, declared_in({&text}));
}

Program compile_tessellation_program(const ShaderText& vertex, const ShaderText& control, const ShaderText& evaluation,
                                     std::span<const char* const> captured) {
  const auto first = compile_stage<Kind::vertex_shader>(vertex);
  const auto second = compile_stage<Kind::control_shader>(control);
  const auto third = compile_stage<Kind::evaluation_shader>(evaluation);
  const GLuint stages[] = {first.id(), second.id(), third.id()};
  return link(evaluation.name, stages, declared_in({&vertex, &control, &evaluation}), captured);
}

}  // namespace gbl::gl
