#pragma once
// The passes, each a function of the frame. A pass states all its state and binds all it reads.
#include "renderer/gl/pass_state.h"
#include "renderer/gl/texture_units.h"
#include "renderer/light/light_volume.h"
#include "renderer/passes/frame.h"

namespace gbl {

// Bind where a pass draws, set the viewport, apply its state.
void begin_drawing(const gl::Framebuffer&, glm::ivec2 size, const gl::PassState&);

// The state with this depth test, whichever way depth runs; and the farthest depth into the bound framebuffer.
gl::PassState depth_tested(const Frame&, gl::DepthTest, gl::PassState);
void clear_depth(const Frame&);
// The stencil test that leaves the background out of the light passes, if background.skip asks for it.
gl::Stencil light_stencil(const Frame&);

// Textures of the G-buffer and the light records, by the names of the samplers that read them.
void bind_gbuffer(const Frame&);
void bind_lights(const Frame&);
void bind_light_sums(const Frame&);

void upload_frame_block(Frame&);
void upload_lights(Frame&);
void upload_records(gl::TexelBuffer&, const std::vector<glm::vec4>& texels, const char* sampler, const char* label);

// -> draw calls
int draw_shadow_maps(Frame&);
double shadow_mib(const ResolvedFrame&);  // of the maps
// What mirrors show, before the frame that shows them; -> draw calls
int draw_mirrored(Renderer&, const Settings&, const ResolvedFrame&, const GpuScene&, Targets& around);
double mirrors_mib(const MirrorTargets&);
int draw_reflections(Frame&);    // onto the mirrors
int draw_forward_frame(Frame&);  // background, then surfaces shaded as they are drawn
int draw_geometry(Frame&);
int draw_light_sums(Frame&);    // the lists of its method, then light
int draw_folded_light(Frame&);  // the same, and what combine would do
int prepare_lighting(Frame&);   // what the lighting reads beside the G-buffer and the lights
int draw_lighting(const Frame&, LightOutput, const gl::Framebuffer& into);
int draw_combine(Frame&);
int draw_background(const Frame&, const gl::Framebuffer& into);
int draw_forward(Frame&, LightOutput, const gl::Framebuffer& into);
int draw_materials_over_light(Frame&);
int draw_transparent(Frame&);
int draw_edge_blur(Frame&);
void draw_volume_wires(const Frame&, Canvas& into);
void draw_ids(Frame&);                    // into targets.ids(), once per frame drawn
void draw_redrawn(Frame&);                // into targets.redrawn_…, once per frame drawn
void draw_outline(Frame&, Canvas& into);  // of settings.view.object
void draw_truth_view(const Frame&, View, const ViewOptions&, Canvas& into);  // of reference and error
void draw_truth_numbers(const Frame&, View, const ViewOptions&, const PixelGrid&, Canvas& into);
// Signed numbers in r, where a is 1, along the error's bar, over what is bound.
void colour_errors(ProgramCache&, Shapes&, const gl::Texture& errors, ErrorScale, double range);
void set_pixel_grid(const gl::Program&, glm::ivec2 size, const PixelGrid&);  // of a picture of this size

}  // namespace gbl
