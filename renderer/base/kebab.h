#pragma once
// The id of a C++ name, at compile time: volume_without_distance_test -> "volume-without-distance-test".
#include <algorithm>
#include <cstddef>

namespace gbl {

template <size_t N>
struct Kebab {
  char text[N];
  constexpr Kebab(const char (&name)[N]) {  // NOLINT(google-explicit-constructor): a template's argument
    std::transform(name, name + N, text, [](char c) { return c == '_' ? '-' : c; });
  }
};

template <Kebab kName>
inline constexpr const char* kKebab = kName.text;

}  // namespace gbl
