#pragma once
// The passes, each a function of the frame. A pass states all its state and binds all it reads.
#include "renderer/gl/pass_state.h"
#include "renderer/light_volume.h"
#include "renderer/passes/frame.h"

namespace gbl {

// Bind where a pass draws, set the viewport, apply its state.
void begin_drawing(const gl::Framebuffer&, glm::ivec2 size, const gl::PassState&);

// Textures of the G-buffer and the light records, at the units of programs.h.
void bind_gbuffer(const Frame&);
void bind_lights(const Frame&);
void bind_light_sums(const Frame&);

void upload_frame_block(const Frame&);
void upload_lights(const Frame&);
// Rows of float records as a texture; remade only when it must grow or shrink.
void upload_records(gl::Texture&, std::vector<glm::vec4>& texels, Unit, const char* label);

int draw_geometry(const Frame&);                                            // -> draw calls
int draw_forward(const Frame&);                                             // -> draw calls
void prepare_lighting(const Frame&);
int draw_lighting(const Frame&, LightOutput, const gl::Framebuffer& into);  // -> draw calls
int draw_combine(const Frame&);
void draw_volume_wires(const Frame&, Canvas& into);

}  // namespace gbl
