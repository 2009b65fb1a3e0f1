#pragma once
// The little of SVG 1.1 that our drawings use. They are printed in grey, too: lines differ by their dashes, not by colour alone.
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

namespace gbl {

std::string svg_escaped(std::string_view);  // for texts and attributes

// A page on white, `body` in pixels from the top left.
std::string svg_page(glm::ivec2 size, const std::string& body);

struct SvgStroke {
  const char* colour = "#222";
  double width = 1.5;
  const char* dashes = "";  // as stroke-dasharray
  const char* fill = "none";
};
std::string svg_path(std::span<const glm::dvec2> points, bool closed, const SvgStroke&);
std::string svg_line(glm::dvec2 from, glm::dvec2 to, const SvgStroke&);

enum class SvgAnchor { start, middle, end };
std::string svg_text(glm::dvec2 at, std::string_view text, SvgAnchor = SvgAnchor::start, int px = 13,
                     const char* colour = "#222");

}  // namespace gbl
