#include "renderer/picture/colour_map.h"

namespace gbl {
namespace {

constexpr glm::vec3 kMagma[] = {{0.001f, 0.000f, 0.014f}, {0.040f, 0.031f, 0.134f}, {0.113f, 0.065f, 0.277f},
                                {0.212f, 0.062f, 0.419f}, {0.317f, 0.072f, 0.485f}, {0.415f, 0.110f, 0.505f},
                                {0.513f, 0.148f, 0.508f}, {0.614f, 0.182f, 0.499f}, {0.716f, 0.215f, 0.475f},
                                {0.817f, 0.256f, 0.436f}, {0.904f, 0.320f, 0.388f}, {0.961f, 0.418f, 0.360f},
                                {0.987f, 0.536f, 0.382f}, {0.996f, 0.654f, 0.446f}, {0.997f, 0.770f, 0.535f},
                                {0.992f, 0.884f, 0.640f}, {0.987f, 0.991f, 0.750f}};

constexpr glm::vec3 of_codes(int r, int g, int b) { return glm::vec3(r, g, b) / 255.0f; }
constexpr glm::vec3 kRedBlue[] = {of_codes(5, 48, 97),     of_codes(33, 102, 172),  of_codes(67, 147, 195),
                                  of_codes(146, 197, 222), of_codes(209, 229, 240), of_codes(247, 247, 247),
                                  of_codes(253, 219, 199), of_codes(244, 165, 130), of_codes(214, 96, 77),
                                  of_codes(178, 24, 43),   of_codes(103, 0, 31)};

}  // namespace

std::span<const glm::vec3> magma() { return kMagma; }
std::span<const glm::vec3> red_blue() { return kRedBlue; }

}  // namespace gbl
