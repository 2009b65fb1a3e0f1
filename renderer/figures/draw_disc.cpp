// A disc through the light's middle that faces the camera, as a polygon, against the outline of the light's sphere, on the image
// plane: straight ahead and off the axis. The disc spans atan(r / d), the sphere asin(r / d). (Engine blog, part 30.)
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <vector>

#include "renderer/figures/drawing_parts.h"
#include "renderer/picture/svg.h"

namespace gbl {
namespace {

constexpr double kDistance = 1.5;  // of the light's middle, in ranges
constexpr int kCorners = 36, kOutline = 180;
constexpr double kTurns[] = {0, 30};  // degrees off the view axis
constexpr double kMiddles[] = {150, 400}, kTexts[] = {150, 450};
constexpr glm::dvec2 kPage{640, 340};
constexpr double kPixels = 78;  // per unit of the image plane

using Outline = std::vector<glm::dvec2>;

// A circle round the light's direction, at this angle from it, on the image plane at distance 1.
Outline circle(double half_angle, double turn, int corners) {
  Outline out;
  for (int k = 0; k < corners; ++k) {
    const double a = 2 * std::numbers::pi * k / corners;
    const glm::dvec3 way(std::sin(half_angle) * std::cos(a), std::sin(half_angle) * std::sin(a), std::cos(half_angle));
    const glm::dvec3 turned(way.x * std::cos(turn) + way.z * std::sin(turn), way.y,
                            way.z * std::cos(turn) - way.x * std::sin(turn));
    out.emplace_back(turned.x / turned.z, -turned.y / turned.z);
  }
  return out;
}

double area(const Outline& o) {
  double twice = 0;
  for (size_t k = 0; k < o.size(); ++k) {
    const glm::dvec2 &a = o[k], &b = o[(k + 1) % o.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2;
}

// Moved so that the light's own direction lies at `middle`.
Outline on_page(const Outline& from, double turn, glm::dvec2 middle) {
  Outline out;
  for (const glm::dvec2& p : from) out.push_back(middle + kPixels * (p - glm::dvec2(std::tan(turn), 0)));
  return out;
}

}  // namespace

std::string draw_disc(const Settings&, const std::string& title) {
  std::string body = svg_text({20, 28}, title, SvgAnchor::start, 16);
  for (size_t i = 0; i < std::size(kTurns); ++i) {
    const double turn = kTurns[i] * std::numbers::pi / 180;
    const Outline sphere = circle(std::asin(1 / kDistance), turn, kOutline);
    const Outline disc = circle(std::atan(1 / kDistance), turn, kCorners);
    const glm::dvec2 middle(kMiddles[i], 150);
    body += svg_path(on_page(sphere, turn, middle), true, {"#204a87", 2, "", "#dfe7f3"});
    body += svg_path(on_page(disc, turn, middle), true, {"#a40000", 2, "6 4", "#f6e3c5"});
    const std::string place = kTurns[i] == 0 ? "straight ahead" : fmt::format("{:.0f}° off the axis", kTurns[i]);
    body += svg_text({kTexts[i], 280}, fmt::format("{}: {:.0f} % covered", place, 100 * area(disc) / area(sphere)),
                     SvgAnchor::middle);
  }
  body += svg_text(
      {20, 318},
      fmt::format("solid: the sphere's outline, {} radii away; dashed: the disc, {} corners", kDistance, kCorners),
      SvgAnchor::start, 12, "#555");
  return svg_page({int(kPage.x), int(kPage.y)}, body);
}

}  // namespace gbl
