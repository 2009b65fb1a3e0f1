#pragma once
// Programs from shader files with #include and compile-time variants; errors point into our files.
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "renderer/gl/object.h"

namespace gbl::gl {

struct Define {
  std::string name;
  std::string value;  // a number, a word of GLSL or a file that `#include NAME` names
  Define(std::string n, int v) : name(std::move(n)), value(std::to_string(v)) {}
  Define(std::string n, std::string word) : name(std::move(n)), value(std::move(word)) {}
  bool operator==(const Define&) const = default;
  bool operator<(const Define& o) const { return std::tie(name, value) < std::tie(o.name, o.value); }
};
using Defines = std::vector<Define>;

struct ShaderText {
  std::string name;                     // for messages
  std::string body;                     // expanded GLSL without #version
  std::vector<std::string> files = {};  // index = GLSL source-string number used in #line; empty: `name` alone
};

// Reads shaders/`name`, expands #include "x" and #include DEFINE once per file with #line markers, prepends the defines.
ShaderText load_shader(std::string_view name, const Defines&);

// "0:12(5): error: …" of Mesa or "0(12) : error …" of others -> "shaders/surface.glsl:12: error: …".
std::string readable_log(std::string_view log, const ShaderText&);

using UniformNames = std::set<std::string, std::less<>>;
UniformNames declared_uniforms(std::string_view text);  // under whichever #if they stand

// Its samplers read the texture units of their names, see texture_units.h.
class Program {
 public:
  GLuint id() const { return name_.id(); }
  // Where a value is set. A program without it ignores the value, and the misuse is reported (misuse.h).
  GLint uniform(const char* name) const;
  // The same for a uniform that some variants of the shader do not use: it need only be declared.
  GLint find_uniform(const char* name) const;

 private:
  friend Program link(std::string_view label, std::span<const GLuint> stages, UniformNames declared,
                      std::span<const char* const> captured);
  GLint location(const char* name, bool may_be_unused) const;
  Object<Kind::program> name_;
  std::string label_;
  UniformNames declared_;  // for reports of misuse; else empty
  mutable std::map<std::string, GLint, std::less<>> locations_;
};

// Error(bad_input) with file and line.
Program compile_program(const ShaderText& vertex, const ShaderText& fragment);
Program compile_compute_program(const ShaderText&);  // needs Feature::compute
// Makes triangles of patches, and writes these outputs of each corner one after the other; draws nothing.
Program compile_tessellation_program(const ShaderText& vertex, const ShaderText& control, const ShaderText& evaluation,
                                     std::span<const char* const> captured);  // needs Feature::tessellation

}  // namespace gbl::gl
