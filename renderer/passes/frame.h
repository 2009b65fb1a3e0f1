#pragma once
// The way of one frame: settings -> geometry -> lighting -> combine -> views. Owns the order of passes, nothing else.
#include <functional>
#include <memory>
#include <optional>

#include "renderer/frame/frame_report.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/inspect/pixel_probe.h"
#include "renderer/passes/gpu_scene.h"
#include "renderer/passes/outside.h"
#include "renderer/passes/programs.h"
#include "renderer/passes/shapes.h"
#include "renderer/passes/targets.h"
#include "renderer/truth/truth.h"

namespace gbl {

// One frame as the passes see it: what it means, what it is drawn from and into. A pass that only reads takes it const:
// what it may change then is the GPU's state alone.
class Frame {
 public:
  Frame(const std::shared_ptr<const ResolvedFrame>& r, const Settings::View& v, const GpuScene& s, Targets& t,
        ProgramCache& p, Shapes& sh)
      : resolved(*r), settings(r->settings), view(v), scene(s), programs(p), shapes(sh), targets_(t), held_(r) {}

  const ResolvedFrame& resolved;
  const Settings& settings;    // resolved.settings
  const Settings::View& view;  // what is looked at
  const GpuScene& scene;
  ProgramCache& programs;  // compiled at first use
  Shapes& shapes;          // made at first use

  Targets& targets() { return targets_; }
  const Targets& targets() const { return targets_; }
  const std::vector<Light>& lights() const { return resolved.lights; }
  int light_count() const { return static_cast<int>(resolved.lights.size()); }
  const gl::Texture& texture(Stores what) const { return *targets_.frame.texture(what); }  // must be stored
  const gl::Framebuffer& framebuffer(Pass pass) const { return targets_.frame.framebuffer(pass); }
  // Objects that are drawn as other triangles than their meshes'.
  const Tessellation& tessellation() const {
    return targets_.cut.tessellation ? *targets_.cut.tessellation : targets_.tessellation;
  }
  glm::vec3 background() const;  // linear; the sky's is a function of direction, in the shader

  gl::Defines defines() const;          // of every program that reads the G-buffer or the lights
  gl::Defines surface_defines() const;  // of those that draw objects into the G-buffer
  gl::Defines shaded_defines() const;   // of those that shade objects as they draw them

 private:
  Targets& targets_;
  std::shared_ptr<const ResolvedFrame> held_;
};

struct TruthTextures;

struct ViewOptions {
  bool raw = false;                  // stored codes, undecoded
  const ViewStats* stats = nullptr;  // of what is seen, where the view's colours follow it; null: its own range
  std::function<const ViewStats*(View)> stats_of = {};  // of the overlays; empty: none is known
  bool overlays = false;                 // what settings.view lays over it: views, wires of light volumes, an outline
  const TruthTextures* truth = nullptr;  // of the views that need it
  double error_range = 1;                // where the error's colour bar ends
};

class Renderer {
 public:
  // What these settings mean for this scene on this device; worked out once until something changes.
  std::shared_ptr<const ResolvedFrame> resolve(const Settings&, const GpuScene&);
  const Resolver& resolver() const { return resolver_; }

  // Draw the frame up to `lit`. There is no other state than the arguments': two Settings drawn in turn give the
  // bits of separate runs. Throws Error.
  FrameReport render(const Settings&, const GpuScene&, Targets&);

  // Of the frame just drawn into these targets with the same settings and scene:
  void draw_view(View, const Settings&, const GpuScene&, Targets&, const ViewOptions& = {});
  // the view's numbers of some pixels (view_stats.h), and w = 1 where there are any, into targets.canvases.numbers()
  void draw_numbers(View, const Settings&, const GpuScene&, Targets&, const PixelGrid&, const ViewOptions& = {});
  void count_pairs(const Settings&, const GpuScene&, Targets&, bool lit_too);
  // How often each of these lights was shaded at a pixel (origin top left): counted as pairs are, with that light alone.
  // Waits for the GPU.
  std::vector<int> times_shaded(const std::vector<int>& lights, glm::ivec2 pixel, const Settings&, const GpuScene&,
                                Targets&);
  void start_probe(const Settings&, const GpuScene&, Targets&, glm::ivec2 pixel);  // pixel: origin top left

  // For the reference and the measures (renderer/passes/judging.h):
  // which triangle each pixel sees and its texels, into four float targets; of any settings, drawn or not
  // uvs_moved: of each pixel with a height map, how far its texture coordinates have moved; null: nothing is sunk.
  void draw_seen(const Settings&, const GpuScene&, Targets&, const gl::Framebuffer& into,
                 const gl::Texture* uvs_moved = nullptr);
  // the surface that the frame shows at a pixel (origin top left); waits for the GPU
  SeenSurface surface_at(const Settings&, const GpuScene&, Targets&, glm::ivec2 pixel);
  // normal and position as the lighting decodes them, and the surface that the frame shows
  void draw_decoded(const Settings&, const GpuScene&, Targets&, const gl::Framebuffer& into);
  // how far the frame is from the truth, with the surface that it shows, into targets.canvases.errors(), and begins to read it back
  void draw_errors(const Settings&, const GpuScene&, Targets&, const TruthTextures&);

  // The frame from outside, its points in the colours of a view that is drawn; into RGBA8 with depth.
  void draw_outside(const OutsideView&, View colours, const Settings&, const GpuScene&, Targets&, const Canvas& into);
  // Two pictures against each other: A - B in codes, of the channel that is off most, into RGBA32F; and its colours.
  void draw_difference(const gl::Texture& a, const gl::Texture& b, const Canvas& into);
  void colour_difference(const gl::Texture& difference, ErrorScale, double range, const Canvas& into);

  // What has arrived since: times and pair counts into the report. `wait` blocks until all of it has.
  void collect(Targets&, FrameReport&, bool wait);
  std::optional<PixelProbe> take_probe(Targets&, bool wait);

  void reload_shaders() { programs_.reload(); }
  int reloads() const { return programs_.reloads(); }
  int programs_compiled() const { return programs_.compiled(); }
  // May as many as a frame with all its views uses be compiled without one being forgotten?
  bool has_room_for_programs() const { return programs_.size() + 40 <= ProgramCache::kMost; }

 private:
  // What these settings draw in front, once per frame drawn, bound for shaders/frame_surface.glsl.
  const Canvases::Surfaces& draw_surfaces(const Settings&, const GpuScene&, Targets&);
  // With its facts uploaded: views, counts and probes may follow a frame of other settings on the same device, so each
  // of them uploads anew, a few hundred bytes.
  Frame frame_of(const Settings&, const GpuScene&, Targets&);
  // What the view counts, counted if nobody has yet.
  void count_for(View, const Settings&, const GpuScene&, Targets&);
  void count_picked(const Settings&, const GpuScene&,
                    Targets&);  // pairs of the picked light, into counts and counts_lit
  void draw_overlays(View under, const Settings&, const GpuScene&, Targets&, const ViewOptions&, Canvas& into);
  Resolver resolver_;
  ProgramCache programs_;
  Shapes shapes_;
};

}  // namespace gbl
