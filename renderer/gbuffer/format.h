#pragma once
// Pixel formats of attachments and images: one row each. No GL here; renderer/gl maps rows to GL's enums.
#include <array>
#include <cstddef>

namespace gbl {

enum class Format {
  rgba8,
  rg8,
  rg16ui,
  r32ui,
  rg32ui,
  rgba32ui,
  rg16f,
  rgba16f,
  r11g11b10f,
  rgba32f,
  r32f,
  d16,
  d24,
  d32f,
  d24s8,
  d32fs8
};
enum class Numeric { unorm, uint, floating, depth };

struct FormatRow {
  Format format;
  const char* label;
  int bytes;  // per pixel as stored, padding included
  int channels;
  Numeric numeric;
  std::array<int, 4> channel_bits;
  bool stencil = false;  // 8 bits beside the depth
};

inline constexpr FormatRow kFormats[] = {
    {Format::rgba8, "RGBA8", 4, 4, Numeric::unorm, {8, 8, 8, 8}},
    {Format::rg8, "RG8", 2, 2, Numeric::unorm, {8, 8}},
    {Format::rg16ui, "RG16UI", 4, 2, Numeric::uint, {16, 16}},
    {Format::r32ui, "R32UI", 4, 1, Numeric::uint, {32}},
    {Format::rg32ui, "RG32UI", 8, 2, Numeric::uint, {32, 32}},
    {Format::rgba32ui, "RGBA32UI", 16, 4, Numeric::uint, {32, 32, 32, 32}},
    {Format::rg16f, "RG16F", 4, 2, Numeric::floating, {16, 16}},
    {Format::rgba16f, "RGBA16F", 8, 4, Numeric::floating, {16, 16, 16, 16}},
    {Format::r11g11b10f, "R11G11B10F", 4, 3, Numeric::floating, {11, 11, 10}},
    {Format::rgba32f, "RGBA32F", 16, 4, Numeric::floating, {32, 32, 32, 32}},
    {Format::r32f, "R32F", 4, 1, Numeric::floating, {32}},
    {Format::d16, "D16", 2, 1, Numeric::depth, {16}},
    {Format::d24, "D24", 4, 1, Numeric::depth, {24}},
    {Format::d32f, "D32F", 4, 1, Numeric::depth, {32}},
    {Format::d24s8, "D24S8", 4, 1, Numeric::depth, {24}, true},
    {Format::d32fs8, "D32FS8", 8, 1, Numeric::depth, {32}, true},
};
constexpr const FormatRow& row(Format f) { return kFormats[static_cast<size_t>(f)]; }

constexpr bool formats_in_order() {
  for (size_t i = 0; i < sizeof kFormats / sizeof *kFormats; ++i)
    if (kFormats[i].format != static_cast<Format>(i)) return false;
  return true;
}
static_assert(formats_in_order());

}  // namespace gbl
