#pragma once
// The way of one frame: settings -> geometry -> lighting -> combine -> views. Owns the order of passes, nothing else.
#include <memory>
#include <optional>

#include "renderer/frame/frame_report.h"
#include "renderer/passes/gpu_scene.h"
#include "renderer/passes/programs.h"
#include "renderer/passes/shapes.h"
#include "renderer/passes/targets.h"

namespace gbl {

// The facts of one frame, computed once and read by every pass.
struct Frame {
  Settings settings;  // lights.method=auto is resolved
  const GpuScene& scene;
  Targets& targets;
  ProgramCache& programs;
  Shapes& shapes;
  double aspect;
  glm::dmat4 clip_from_relative;

  DepthRuns depth_runs() const;
  bool split() const;  // are diffuse and specular light kept apart?
  bool mistaken(Mistake) const;
  glm::vec3 background() const;  // linear; the sky's is a function of direction, in the shader

  gl::Defines defines() const;          // of every program that reads the G-buffer or the lights
  gl::Defines surface_defines() const;  // of those that draw objects into the G-buffer
  gl::Defines shaded_defines() const;   // of those that shade objects as they draw them
};

struct TruthTextures;

struct ViewOptions {
  bool raw = false;                      // stored codes, undecoded
  bool overlays = false;                 // wires of light volumes as settings.view.volumes says
  const TruthTextures* truth = nullptr;  // of the views that need it
  double error_range = 1;                // where the error's colour bar ends
};

// One pixel's values in a row of texels; their meaning stands in shaders/probe.frag.
using ProbeValues = std::array<glm::vec4, 8>;

class Renderer {
 public:
  // Draw the frame up to `lit`. There is no other state than the arguments': two Settings drawn in turn give the
  // bits of separate runs. Throws Error.
  FrameReport render(const Settings&, const GpuScene&, Targets&);

  // Of the frame just drawn into these targets with the same settings and scene:
  void draw_view(View, const Settings&, const GpuScene&, Targets&, ViewOptions = {});
  void count_pairs(const Settings&, const GpuScene&, Targets&, bool lit_too);
  void start_probe(const Settings&, const GpuScene&, Targets&, glm::ivec2 pixel);  // pixel: origin top left

  // For the reference and the measures (renderer/passes/judging.h):
  // which triangle each pixel sees and its texels, into four float targets; of any settings, drawn or not
  void draw_seen(const Settings&, const GpuScene&, Targets&, const gl::Framebuffer& into);
  // normal and position as the lighting decodes them
  void draw_decoded(const Settings&, const GpuScene&, Targets&, const gl::Framebuffer& into);
  // how far the frame is from the truth, into targets.errors(), and begins to read it back
  void draw_errors(const Settings&, const GpuScene&, Targets&, const TruthTextures&);

  // What has arrived since: times and pair counts into the report. `wait` blocks until all of it has.
  void collect(Targets&, FrameReport&, bool wait);
  std::optional<ProbeValues> take_probe(Targets&, bool wait);

  void reload_shaders() { programs_.reload(); }

 private:
  Frame frame_of(const Settings&, const GpuScene&, Targets&);
  ProgramCache programs_;
  Shapes shapes_;
};

}  // namespace gbl
