#include "renderer/gltf/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

#include "renderer/gltf/gltf_limits.h"

namespace gbl::gltf {
namespace {

constexpr int kByte = 5120, kUByte = 5121, kShort = 5122, kUShort = 5123, kUInt = 5125, kFloat = 5126;

size_t component_bytes(int type) {
  switch (type) {
    case kByte:
    case kUByte: return 1;
    case kShort:
    case kUShort: return 2;
    case kUInt:
    case kFloat: return 4;
    default: throw Broken(fmt::format("component type {} is not known", type));
  }
}

// memcpy: a hostile file's numbers need not be aligned. Integers in files are little-endian, as the machines we
// build for are.
template <class T>
T load(const uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

// Specification 3.6.2.2 and 2.4: c / 127, c / 255, …; signed values do not fall below -1.
float component(const uint8_t* at, int type, bool normalised) {
  switch (type) {
    case kByte: return normalised ? std::max(load<int8_t>(at) / 127.f, -1.f) : load<int8_t>(at);
    case kUByte: return normalised ? *at / 255.f : *at;
    case kShort: return normalised ? std::max(load<int16_t>(at) / 32767.f, -1.f) : load<int16_t>(at);
    case kUShort: return normalised ? load<uint16_t>(at) / 65535.f : load<uint16_t>(at);
    case kUInt:
      return normalised ? static_cast<float>(load<uint32_t>(at) / 4294967295.) : static_cast<float>(load<uint32_t>(at));
    default: return load<float>(at);
  }
}

uint32_t whole(const uint8_t* at, int type) {
  if (type == kUByte) return *at;
  if (type == kUShort) return load<uint16_t>(at);
  if (type == kUInt) return load<uint32_t>(at);
  throw Broken(fmt::format("indices of component type {}", type));
}

struct Strided {
  const uint8_t* first = nullptr;
  size_t stride = 0;
};

// count elements of `bytes` each, `offset` into the view. All arithmetic in 64 bits of values below 2^53.
Strided elements(const Document& document, int view_index, uint64_t offset, uint64_t count, uint64_t bytes,
                 bool strided) {
  const std::span<const uint8_t> view = view_bytes(document, view_index);
  const uint64_t given = document.views[static_cast<size_t>(view_index)].stride;
  const uint64_t stride = strided && given > 0 ? given : bytes;
  if (count == 0) return {view.data(), static_cast<size_t>(stride)};
  const bool inside =
      offset <= view.size() && bytes <= view.size() - offset && (count - 1) <= (view.size() - offset - bytes) / stride;
  if (!inside)
    throw Broken(fmt::format("{} elements from byte {} run past the end of buffer view {} ({} bytes)", count, offset,
                             view_index, view.size()));
  return {view.data() + offset, static_cast<size_t>(stride)};
}

// Elements that a sparse accessor replaces: (index, where its new value lies).
template <class Replace>
void for_each_replaced(const Document& document, const Accessor& accessor, uint64_t bytes, Replace replace) {
  const Sparse& sparse = accessor.sparse;
  if (sparse.indices_view < 0) return;
  if (sparse.count > accessor.count)
    throw Broken(fmt::format("{} sparse values for {} elements", sparse.count, accessor.count));
  const Strided index = elements(document, sparse.indices_view, sparse.indices_offset, sparse.count,
                                 component_bytes(sparse.indices_type), false);
  const Strided value = elements(document, sparse.values_view, sparse.values_offset, sparse.count, bytes, false);
  for (uint64_t i = 0; i < sparse.count; ++i) {
    const uint32_t at = whole(index.first + i * index.stride, sparse.indices_type);
    if (at >= accessor.count) throw Broken(fmt::format("sparse index {} of {} elements", at, accessor.count));
    replace(at, value.first + i * value.stride);
  }
}

void check_count(const Accessor& accessor, const std::string& name) {
  if (accessor.count == 0) throw Broken(fmt::format("{} is empty or broken", name));
  if (accessor.view < 0 && accessor.count > kMaxZeroElements)
    throw Broken(fmt::format("{} has {} elements without data", name, accessor.count));
}

}  // namespace

std::span<const uint8_t> view_bytes(const Document& document, int view_index) {
  const BufferView& view = document.views[static_cast<size_t>(view_index)];
  if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= document.buffers.size())
    throw Broken(fmt::format("buffer view {} has no buffer", view_index));
  const std::span<const uint8_t> buffer = document.buffers[static_cast<size_t>(view.buffer)];
  if (buffer.empty()) throw Broken(fmt::format("buffer {} is not there", view.buffer));
  if (view.offset > buffer.size() || view.length > buffer.size() - view.offset)
    throw Broken(fmt::format("buffer view {} runs past the end of buffer {} ({} bytes)", view_index, view.buffer,
                             buffer.size()));
  return buffer.subspan(view.offset, view.length);
}

Numbers read_numbers(const Document& document, int index, const char* name, int least, int most,
                     bool always_normalised) {
  const Accessor& accessor = document.accessors[static_cast<size_t>(index)];
  check_count(accessor, name);
  if (accessor.components < least || accessor.components > most)
    throw Broken(fmt::format("{} has {} components", name, accessor.components));
  const auto components = static_cast<size_t>(accessor.components);
  const size_t size = component_bytes(accessor.component_type), bytes = size * components;
  const bool normalised = accessor.normalised || always_normalised;
  Numbers numbers{{}, components};
  const auto put = [&](uint64_t element, const uint8_t* from) {
    for (size_t c = 0; c < components; ++c)
      numbers.values[element * components + c] = component(from + c * size, accessor.component_type, normalised);
  };
  if (accessor.view >= 0) {
    const Strided from = elements(document, accessor.view, accessor.offset, accessor.count, bytes, true);
    numbers.values.resize(accessor.count * components);
    for (uint64_t i = 0; i < accessor.count; ++i) put(i, from.first + i * from.stride);
  } else {
    numbers.values.resize(accessor.count * components);  // specification 3.6.2.1: zeros
  }
  for_each_replaced(document, accessor, bytes, put);
  return numbers;
}

std::vector<uint32_t> read_indices(const Document& document, int index) {
  const Accessor& accessor = document.accessors[static_cast<size_t>(index)];
  check_count(accessor, "the list of indices");
  if (accessor.components != 1) throw Broken("its indices are not single numbers");
  const size_t bytes = component_bytes(accessor.component_type);
  std::vector<uint32_t> indices;
  const auto put = [&](uint64_t i, const uint8_t* at) { indices[i] = whole(at, accessor.component_type); };
  if (accessor.view >= 0) {
    const Strided from = elements(document, accessor.view, accessor.offset, accessor.count, bytes, true);
    indices.resize(accessor.count);
    for (uint64_t i = 0; i < accessor.count; ++i) put(i, from.first + i * from.stride);
  } else {
    indices.resize(accessor.count);
  }
  for_each_replaced(document, accessor, bytes, put);
  return indices;
}

}  // namespace gbl::gltf
