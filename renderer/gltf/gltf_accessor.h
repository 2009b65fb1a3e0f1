#pragma once
// An accessor's elements as numbers. Every byte range is checked before it is touched; Broken says what is wrong.
// (Specification 3.6.2 accessors, 3.6.2.4 alignment, 3.6.2.3 sparse; 3.11 for normalised integers.)
#include <cstdint>
#include <vector>

#include "renderer/gltf/gltf_document.h"

namespace gbl::gltf {

struct Numbers {
  std::vector<float> values;
  size_t components = 0;
  size_t count() const { return components ? values.size() / components : 0; }
  const float* operator[](size_t element) const { return values.data() + element * components; }
};

// index: of the accessor. name: for messages ("POSITION"). least, most: how many components are allowed.
// always_normalised: of colours and weights, whose integers mean 0..1 whatever the flag says.
Numbers read_numbers(const Document&, int index, const char* name, int least, int most, bool always_normalised = false);

std::vector<uint32_t> read_indices(const Document&, int index);

// The bytes of a buffer view, e.g. of an image.
std::span<const uint8_t> view_bytes(const Document&, int view_index);

}  // namespace gbl::gltf
