#include "renderer/gltf/gltf_document.h"

namespace gbl::gltf {
namespace {

// The codes are OpenGL's.
Wrap wrap_of(int code) {
  if (code == 33071) return Wrap::clamp;
  if (code == 33648) return Wrap::mirror;
  return Wrap::repeat;
}

Filter filter_of(int code, Filter otherwise) {
  switch (code) {
    case 9728: return Filter::nearest;
    case 9729: return Filter::linear;
    case 9984: return Filter::nearest_mipmap_nearest;
    case 9985: return Filter::linear_mipmap_nearest;
    case 9986: return Filter::nearest_mipmap_linear;
    case 9987: return Filter::linear_mipmap_linear;
    default: return otherwise;
  }
}

}  // namespace

Sampler sampler_of(int wrap_s, int wrap_t, int min_filter, int mag_filter) {
  Sampler sampler{wrap_of(wrap_s), wrap_of(wrap_t)};
  sampler.min = filter_of(min_filter, sampler.min);
  sampler.mag = filter_of(mag_filter, sampler.mag) == Filter::nearest ? Filter::nearest : Filter::linear;
  return sampler;
}

}  // namespace gbl::gltf
