#pragma once
// Texture units by the name of the sampler that reads them. A name gets the next unit when it is first seen, in a
// program or at a bind, and keeps it: each sampler has a unit of its own, what is bound serves every program of that
// name, and no list of samplers stands in C++.
#include <string_view>

#include "renderer/gl/texture.h"

namespace gbl::gl {

int unit_of(std::string_view sampler);  // Error when the device has no unit left
int units_in_use();                     // from 0 on; unit 0 has no sampler: textures are made and written there

void bind_texture(std::string_view sampler, const Texture&);
void activate_unit_of(std::string_view sampler);  // for a bind of another kind

}  // namespace gbl::gl
