#pragma once
// Pixel formats of attachments and images: one row each. No GL here; renderer/gl maps rows to GL's enums.
#include <cstddef>

namespace gbl {

enum class Format { rgba8, rg8, rg16ui, rg16f, rgba16f, r11g11b10f, rgba32f, r32f, d16, d24, d32f };
enum class Numeric { unorm, uint, floating, depth };

struct FormatRow {
  Format format;
  const char* label;
  int bytes;  // per pixel as stored, padding included
  int channels;
  Numeric numeric;
};

inline constexpr FormatRow kFormats[] = {
    {Format::rgba8, "RGBA8", 4, 4, Numeric::unorm},
    {Format::rg8, "RG8", 2, 2, Numeric::unorm},
    {Format::rg16ui, "RG16UI", 4, 2, Numeric::uint},
    {Format::rg16f, "RG16F", 4, 2, Numeric::floating},
    {Format::rgba16f, "RGBA16F", 8, 4, Numeric::floating},
    {Format::r11g11b10f, "R11G11B10F", 4, 3, Numeric::floating},
    {Format::rgba32f, "RGBA32F", 16, 4, Numeric::floating},
    {Format::r32f, "R32F", 4, 1, Numeric::floating},
    {Format::d16, "D16", 2, 1, Numeric::depth},
    {Format::d24, "D24", 4, 1, Numeric::depth},
    {Format::d32f, "D32F", 4, 1, Numeric::depth},
};
constexpr const FormatRow& row(Format f) { return kFormats[static_cast<size_t>(f)]; }

constexpr bool formats_in_order() {
  for (size_t i = 0; i < sizeof kFormats / sizeof *kFormats; ++i)
    if (kFormats[i].format != static_cast<Format>(i)) return false;
  return true;
}
static_assert(formats_in_order());

}  // namespace gbl
