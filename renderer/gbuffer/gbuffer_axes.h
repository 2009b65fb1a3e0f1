#pragma once
// The axes of what is stored, but for layouts and normal encodings, whose rows hold more (layouts.inc,
// normal_encodings.inc). One table of rows per enum; a row's index is the enum's value.
#include "renderer/rows/value_row.h"

namespace gbl {

enum class NormalSpace { world, view };
enum class PositionSource { depth, linear32f, world16f, world32f, view16f, view32f, view_scaled };
enum class PositionReconstruct { view_ray, inverse_viewproj, inverse_viewproj_varying };
enum class DepthFormat { d16, d24, d32f, d32f_reversed, auto_ };

}  // namespace gbl
