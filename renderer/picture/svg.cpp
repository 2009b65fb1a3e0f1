#include "renderer/picture/svg.h"

#include <fmt/format.h>

namespace gbl {

std::string svg_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '&': out += "&amp;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  return out;
}

std::string svg_page(glm::ivec2 size, const std::string& body) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"white\"/>\n{2}</svg>\n",
      size.x, size.y, body);
}

std::string svg_path(std::span<const glm::dvec2> points, bool closed, const SvgStroke& s) {
  std::string d;
  for (const glm::dvec2& p : points) d += fmt::format("{}{:.2f} {:.2f}", d.empty() ? "M" : " L", p.x, p.y);
  return fmt::format("<path d=\"{}{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", d, closed ? " Z" : "",
                     s.fill, s.colour, s.width, *s.dashes ? fmt::format(" stroke-dasharray=\"{}\"", s.dashes) : "");
}

std::string svg_line(glm::dvec2 from, glm::dvec2 to, const SvgStroke& s) {
  const glm::dvec2 ends[] = {from, to};
  return svg_path(ends, false, s);
}

std::string svg_text(glm::dvec2 at, std::string_view text, SvgAnchor anchor, int px, const char* colour) {
  constexpr const char* kAnchors[] = {"start", "middle", "end"};
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>\n",
                     at.x, at.y, kAnchors[static_cast<int>(anchor)], px, colour, svg_escaped(text));
}

}  // namespace gbl
