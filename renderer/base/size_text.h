#pragma once
// Two whole numbers in a text: a size as "1280x720", a pixel as "640, 360".
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace gbl {

std::string size_text(glm::ivec2 size);
std::optional<glm::ivec2> size_of(std::string_view text);   // empty: it is no size; its range is not looked at
std::optional<glm::ivec2> pixel_of(std::string_view text);  // blanks, "," ";" or "x" between the numbers

}  // namespace gbl
