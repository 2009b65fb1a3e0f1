#pragma once
// The axes of surfaces, sums and views. Those of what is stored stand in renderer/gbuffer, those of lights in
// renderer/light. One table of rows per enum; a row's index is the enum's value.
#include "renderer/rows/value_row.h"

namespace gbl {

enum class ShadingModel { lambert, phong, blinn_phong, ggx };
enum class BackgroundFill { black, grey, colour, sky };
enum class NormalMap { on, off };
enum class HeightMap { off, on };
enum class ParallaxMethod { none, offset, steep, occlusion, relief };
enum class ParallaxDepth { displaced, flat };
enum class TessellationMode { off, uniform, by_distance };
enum class AlbedoSource { textured, white };
enum class Colour { srgb, as_tutorial };
enum class AccumulationFormat { rgba8, r11g11b10f, rgba16f, rgba32f };
enum class AccumulationTargets { one, split, folded };
enum class BackgroundSkip { depth, stencil, alpha, none };
enum class Tangents { vertex, derivatives, matrix_columns };
enum class Antialias { none, edge_blur, msaa_resolved };
enum class DrawOrder { near_far, far_near, seeded };
enum class VolumeOverlay { off, picked, all };
enum class ErrorOf { final, lit, diffuse_light, specular_light, normal, position, depth, albedo, roughness };
enum class ErrorScale { magnitude, with_sign };

}  // namespace gbl
