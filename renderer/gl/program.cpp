#include "renderer/gl/program.h"

#include <algorithm>
#include <fmt/format.h>
#include <regex>
#include <sstream>

#include "renderer/base/error.h"
#include "renderer/base/resources.h"
#include "renderer/gl/texture.h"

namespace gbl::gl {
namespace {

constexpr const char* kPrelude = "#version 330 core\n#define real float\n";
constexpr const char* kComputePrelude = "#version 430 core\n#define real float\n";

void append_file(ShaderText& out, const std::string& name) {
  const int file = static_cast<int>(out.files.size());
  out.files.push_back(name);
  std::istringstream text(resource(name));
  out.body += fmt::format("#line 1 {}\n", file);
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    const size_t open = line.starts_with("#include") ? line.find('"') : std::string::npos;
    if (open == std::string::npos) {
      out.body += line + "\n";
      continue;
    }
    const std::string included = "shaders/" + line.substr(open + 1, line.rfind('"') - open - 1);
    if (std::find(out.files.begin(), out.files.end(), included) == out.files.end()) append_file(out, included);
    out.body += fmt::format("#line {} {}\n", number + 1, file);
  }
}

GLuint compile_stage(GLenum stage, const ShaderText& text) {
  const GLuint shader = glCreateShader(stage);
  const char* parts[] = {stage == GL_COMPUTE_SHADER ? kComputePrelude : kPrelude, text.body.c_str()};
  glShaderSource(shader, 2, parts, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  char log[4096] = {};
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  throw Error(ExitCode::bad_input, "", readable_log(log, text), "mend the shader; it is read again when saved");
}

}  // namespace

ShaderText load_shader(std::string_view name, const Defines& defines) {
  ShaderText out{std::string(name), "", {}};
  for (const Define& d : defines) out.body += fmt::format("#define {} {}\n", d.name, d.value);
  append_file(out, fmt::format("shaders/{}", name));
  return out;
}

std::string readable_log(std::string_view log, const ShaderText& text) {
  static const std::regex kPlace(R"(^\s*(?:ERROR: )?(\d+)[:(](\d+)[^:]*:\s*(.*)$)");
  std::istringstream lines{std::string(log)};
  for (std::string line; std::getline(lines, line);) {
    std::smatch m;
    if (!std::regex_match(line, m, kPlace) || line.find("warning") != std::string::npos) continue;
    const size_t file = std::stoul(m[1]);
    const std::string& where = file < text.files.size() ? text.files[file] : text.name;
    return fmt::format("{}:{}: {}", where, m[2].str(), m[3].str());
  }
  return fmt::format("{}: {}", text.name, log);
}

GLint Program::uniform(const char* name) const {
  const auto found = locations_.find(std::string_view(name));
  if (found != locations_.end()) return found->second;
  return locations_.emplace(name, glGetUniformLocation(name_.id(), name)).first->second;
}

// The stages are let go of, whatever happens.
Program link(std::string_view name, std::span<const GLuint> stages) {
  Program p;
  p.name_ = Object<Kind::program>::make();
  for (const GLuint s : stages) glAttachShader(p.id(), s);
  glLinkProgram(p.id());
  for (const GLuint s : stages) glDetachShader(p.id(), s), glDeleteShader(s);
  GLint ok = 0;
  glGetProgramiv(p.id(), GL_LINK_STATUS, &ok);
  if (!ok) {
    char log[4096] = {};
    glGetProgramInfoLog(p.id(), sizeof log, nullptr, log);
    throw Error(ExitCode::bad_input, fmt::format("shaders/{}", name), log);
  }
  set_label(GL_PROGRAM, p.id(), name);
  return p;
}

Program compile_program(const ShaderText& vertex, const ShaderText& fragment) {
  const GLuint stages[] = {compile_stage(GL_VERTEX_SHADER, vertex), compile_stage(GL_FRAGMENT_SHADER, fragment)};
  return link(fmt::format("{} + {}", vertex.name, fragment.name), stages);
}

Program compile_compute_program(const ShaderText& text) {
  const GLuint stages[] = {compile_stage(GL_COMPUTE_SHADER, text)};
  return link(text.name, stages);
}

}  // namespace gbl::gl
