#pragma once
// Programs by variant, cached and shared by all frames. Reload is start-up run again: the last good program stays.
#include <map>
#include <string>
#include <string_view>
#include <tuple>

#include "renderer/frame/resolved_frame.h"
#include "renderer/gl/program.h"
#include "renderer/inspect/views.h"

namespace gbl {

// What a lighting pass writes; constants of shaders/light_output.glsl.
enum class LightOutput { split, sum, count, lit };

// COLOUR = the chosen value, and COLOUR_SRGB, COLOUR_AS_TUTORIAL, … = each row's value.
void append_choice(gl::Defines&, const char* name, const char* prefix, std::span<const ValueRow>, int chosen);
template <class E>
void append_axis(gl::Defines& out, const char* name, const char* prefix, E chosen) {
  append_choice(out, name, prefix, rows<E>(), static_cast<int>(chosen));
}

// Defines that name the choices a shader depends on; each shader asks only for those it reads.
gl::Defines gbuffer_defines(const ResolvedFrame&);  // what is stored and how, colour, shading
void append_light_defines(gl::Defines&, const ResolvedFrame&);
void append_surface_defines(gl::Defines&, const Settings&, bool emission_kept);

class ProgramCache {
 public:
  // A driver keeps a megabyte and more per program, and settings make thousands of variants. A frame with all its views
  // uses some forty, the frames of all presets with two views each some 150.
  static constexpr size_t kMost = 256;

  // The program of these files and defines; compiled at first use. Error with file and line if it does not compile. Good
  // until kMost others have been asked for.
  const gl::Program& get(std::string_view vertex, std::string_view fragment, const gl::Defines&);

  const gl::Program& get_compute(std::string_view file, const gl::Defines&);
  // NAME.vert, NAME.tesc and NAME.tese, whose captured corners have the members of Vertex.
  const gl::Program& get_tessellation(std::string_view name, const gl::Defines&);

  // Read the shader files again and compile anew what they changed. On an error all old programs stay and the Error is
  // thrown.
  void reload();
  int reloads() const { return reloads_; }  // how often; what they drew before may be other than what they draw now
  size_t size() const { return programs_.size(); }
  int compiled() const { return compiled_; }  // so far, those since forgotten included

 private:
  struct Variant {
    std::string vertex, fragment;  // without a vertex shader: a compute shader
    gl::Defines defines;
    std::string tessellation = {};  // the name of three shaders; then no others
    bool operator<(const Variant& o) const {
      return std::tie(vertex, fragment, tessellation, defines) <
             std::tie(o.vertex, o.fragment, o.tessellation, o.defines);
    }
  };
  using Stages = std::vector<gl::ShaderText>;  // in the order they run
  static Stages read(const Variant&);
  static size_t hash(const Stages&);
  gl::Program compile(const Variant&, const Stages&);
  const gl::Program& get(Variant);
  void forget_oldest();

  struct Kept {
    gl::Program program;
    size_t text = 0;    // what it was compiled from, hashed
    uint64_t used = 0;  // when: a count of all uses
  };
  std::map<Variant, Kept> programs_;
  uint64_t uses_ = 0;
  int reloads_ = 0, compiled_ = 0;
};

}  // namespace gbl
