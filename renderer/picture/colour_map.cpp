#include "renderer/picture/colour_map.h"

#include <algorithm>
#include <array>

#include "renderer/rows/value_table.h"

namespace gbl {
namespace {

// Black over violet to light yellow.
constexpr glm::vec3 kMagma[] = {{0.001f, 0.000f, 0.014f}, {0.040f, 0.031f, 0.134f}, {0.113f, 0.065f, 0.277f},
                                {0.212f, 0.062f, 0.419f}, {0.317f, 0.072f, 0.485f}, {0.415f, 0.110f, 0.505f},
                                {0.513f, 0.148f, 0.508f}, {0.614f, 0.182f, 0.499f}, {0.716f, 0.215f, 0.475f},
                                {0.817f, 0.256f, 0.436f}, {0.904f, 0.320f, 0.388f}, {0.961f, 0.418f, 0.360f},
                                {0.987f, 0.536f, 0.382f}, {0.996f, 0.654f, 0.446f}, {0.997f, 0.770f, 0.535f},
                                {0.992f, 0.884f, 0.640f}, {0.987f, 0.991f, 0.750f}};

constexpr glm::vec3 of_codes(int r, int g, int b) { return glm::vec3(r, g, b) / 255.0f; }
// 11 classes, turned round.
constexpr glm::vec3 kRedBlue[] = {of_codes(5, 48, 97),     of_codes(33, 102, 172),  of_codes(67, 147, 195),
                                  of_codes(146, 197, 222), of_codes(209, 229, 240), of_codes(247, 247, 247),
                                  of_codes(253, 219, 199), of_codes(244, 165, 130), of_codes(214, 96, 77),
                                  of_codes(178, 24, 43),   of_codes(103, 0, 31)};

constexpr glm::vec3 kGrey[] = {glm::vec3(0), glm::vec3(1)};

constexpr glm::vec3 kViridis[] = {
    {0.267004f, 0.004874f, 0.329415f}, {0.282327f, 0.094955f, 0.417331f}, {0.278826f, 0.175490f, 0.483397f},
    {0.258965f, 0.251537f, 0.524736f}, {0.229739f, 0.322361f, 0.545706f}, {0.199430f, 0.387607f, 0.554642f},
    {0.172719f, 0.448791f, 0.557885f}, {0.149039f, 0.508051f, 0.557250f}, {0.127568f, 0.566949f, 0.550556f},
    {0.120638f, 0.625828f, 0.533488f}, {0.157851f, 0.683765f, 0.501686f}, {0.246070f, 0.738910f, 0.452024f},
    {0.369214f, 0.788888f, 0.382914f}, {0.515992f, 0.831158f, 0.294279f}, {0.678489f, 0.863742f, 0.189503f},
    {0.845561f, 0.887322f, 0.099702f}, {0.993248f, 0.906157f, 0.143936f}};

// Mikhailov 2019, "Turbo, An Improved Rainbow Colormap for Visualization": its polynomials of degree 5.
constexpr std::array<glm::vec3, 17> turbo_stops() {
  constexpr float kFactors[3][6] = {
      {0.13572138f, 4.61539260f, -42.66032258f, 132.13108234f, -152.94239396f, 59.28637943f},
      {0.09140261f, 2.19418839f, 4.84296658f, -14.18503333f, 4.27729857f, 2.82956604f},
      {0.10667330f, 12.64194608f, -60.58204836f, 110.36276771f, -89.90310912f, 27.34824973f}};
  std::array<glm::vec3, 17> out{};
  for (size_t i = 0; i < out.size(); ++i) {
    const float x = static_cast<float>(i) / 16;
    float rgb[3] = {};
    for (int c = 0; c < 3; ++c) {
      for (int k = 5; k >= 0; --k) rgb[c] = rgb[c] * x + kFactors[c][k];
      rgb[c] = rgb[c] < 0 ? 0 : rgb[c] > 1 ? 1 : rgb[c];
    }
    out[i] = glm::vec3(rgb[0], rgb[1], rgb[2]);
  }
  return out;
}
constexpr std::array<glm::vec3, 17> kTurbo = turbo_stops();

// clang-format off
constexpr ValueRow kMaps[] = {
  {.value = at(ColourMap::own), .id = "own", .label = "the view's own", .help = "as the view shows itself"},
  {.value = at(ColourMap::grey), .id = "grey", .label = "grey", .help = "black to white"},
  {.value = at(ColourMap::viridis), .id = "viridis", .label = "viridis", .help = "violet over green to yellow, evenly growing lightness: safe for the colour-blind", .source = "Smith and van der Walt 2015, matplotlib"},
  {.value = at(ColourMap::magma), .id = "magma", .label = "magma", .help = "black over violet to light yellow, evenly growing lightness", .source = "Smith and van der Walt 2015, matplotlib"},
  {.value = at(ColourMap::turbo), .id = "turbo", .label = "turbo", .help = "a rainbow with many steps: for detail, not for order", .source = "Mikhailov 2019, Turbo"},
  {.value = at(ColourMap::diverging), .id = "diverging", .label = "diverging", .help = "blue below, white at the middle, red above", .source = "Brewer 2002, ColorBrewer: RdBu"},
};
// clang-format on

}  // namespace

GBL_ROWS(ColourMap, kMaps)

std::span<const glm::vec3> stops_of(ColourMap map) {
  switch (map) {
    case ColourMap::own: return {};
    case ColourMap::grey: return kGrey;
    case ColourMap::viridis: return kViridis;
    case ColourMap::magma: return kMagma;
    case ColourMap::turbo: return kTurbo;
    case ColourMap::diverging: return kRedBlue;
  }
  return {};
}

glm::vec3 colour_at(std::span<const glm::vec3> stops, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const size_t i = std::min(static_cast<size_t>(place), stops.size() - 2);
  return glm::mix(stops[i], stops[i + 1], static_cast<float>(place - static_cast<double>(i)));
}

}  // namespace gbl
