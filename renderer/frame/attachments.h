#pragma once
// attachments(settings): the one function that says which targets a frame has, with formats and names.
#include <vector>

#include "renderer/gbuffer/attachment.h"
#include "renderer/options/settings.h"

namespace gbl {

// In draw-buffer order within a pass; the depth attachment comes last of its pass. The layout must be resolved:
// `auto` has no attachments of its own (renderer/frame/resolve.h).
std::vector<Attachment> attachments(const Settings&);

// The attachment that stores this, or null.
const Attachment* find(const std::vector<Attachment>&, Stores);

// Does the sum of light already hold ambient and emission when lighting begins?
bool sum_begins_in_geometry(const Settings&);
double light_sum_scale(double exposure);  // what sums of light are stored times
bool folds_light(const Settings&);        // the light pass finishes the picture: see accumulation.targets

// Does a pass of these settings mark pixels? Then the depth attachment carries a stencil buffer.
bool needs_stencil(const Settings&);

// Does the lighting compare depths? Then it has a copy of the G-buffer's: to sample a texture while it is attached is
// not allowed everywhere (WebGL 2 refuses it even with writes off).
bool lighting_tests_depth(const Settings&);

// The difference of window depth that rounding can hide between a surface and a volume's face. 0: nobody compares them.
double volume_depth_step(const Settings&);

// Of every target that a pass writes, as stored; the geometry's with depth.
int bytes_per_pixel(const std::vector<Attachment>&, Pass);
inline int gbuffer_bytes_per_pixel(const Settings& s) { return bytes_per_pixel(attachments(s), Pass::geometry); }
inline int accumulation_bytes_per_pixel(const Settings& s) { return bytes_per_pixel(attachments(s), Pass::lighting); }

// Do material and normal share one attachment under these settings?
bool normal_in_material(const Settings&);

}  // namespace gbl
