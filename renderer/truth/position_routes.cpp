#include "renderer/truth/position_routes.h"

#include <cmath>
#include <fmt/format.h>
#include <glm/glm.hpp>

#include "renderer/gbuffer/position_source.h"
#include "renderer/light/light_methods.h"
#include "renderer/options/settings.h"

namespace gbl {
namespace {

const StoredTexel* stored_depth(const PixelProbe& p) {
  for (const StoredTexel& t : p.stored)
    if (t.attachment.stores == Stores::depth) return &t;
  return nullptr;
}

double window_of(const DepthAccount& d, uint32_t code) {
  return d.floating ? double(glm::uintBitsToFloat(code)) : code / (std::exp2(double(d.bits)) - 1);
}

PositionRoute route(const Settings& s, const SurfacePixel& pixel, PositionSource source, PositionReconstruct by) {
  const glm::dvec3 read = position_read({source, by, s.depth.format, {}}, pixel);
  const bool used = s.position.source == source && (source != PositionSource::depth || s.position.reconstruct == by);
  return {source, by, read + s.camera.position, glm::distance(read, pixel.relative), used};
}

}  // namespace

std::string code_text(const DepthAccount& d) { return fmt::format("0x{:0{}x} of {} bits", d.code, d.bits / 4, d.bits); }

std::string name_of(const PositionRoute& r) {
  if (r.source != PositionSource::depth) return row(r.source).id;
  return fmt::format("{}, {}", row(r.source).id, row(r.reconstruct).id);
}

std::string_view pitfall_of(const PositionRoute& r) {
  if (!row(r.source).sound()) return id_of(row(r.source).pitfall);
  const ValueRow& by = row(r.reconstruct);
  return r.source == PositionSource::depth && !by.sound() ? id_of(by.pitfall) : "";
}

DepthAccount depth_account(const Settings& s, const PixelProbe& p, const glm::dvec3& relative) {
  DepthAccount out;
  const StoredTexel* t = stored_depth(p);
  if (!t) return out;
  out.code = t->bits[0];
  out.bits = row(t->attachment.format).channel_bits[0];
  out.floating = out.bits == 32;
  out.window = window_of(out, out.code);
  const auto range = [&](double window) { return range_from_depth(s.camera, window, depth_runs(s.depth.format)); };
  out.distance = range(out.window);
  out.truth = glm::dot(relative, s.camera.forward());
  const uint32_t farther = depth_runs(s.depth.format) == DepthRuns::reversed ? out.code - 1 : out.code + 1;
  out.step = range(window_of(out, farther)) - out.distance;
  return out;
}

std::vector<PositionRoute> position_routes(const Settings& s, const PixelProbe& p, const glm::dvec3& relative) {
  std::vector<PositionRoute> out;
  if (shading_of(s.lights.method) == Shading::forward) return out;
  const glm::dvec2 share = (glm::dvec2(p.pixel) + 0.5) / glm::dvec2(s.size);
  const SurfacePixel pixel{s.camera, s.size.x / double(s.size.y), glm::vec2(share.x * 2 - 1, 1 - share.y * 2), relative,
                           p.number(ProbeField::window_depth)};
  for (const ValueRow& by : rows<PositionReconstruct>())
    out.push_back(route(s, pixel, PositionSource::depth, static_cast<PositionReconstruct>(by.value)));
  for (const ValueRow& source : rows<PositionSource>())
    if (const auto from = static_cast<PositionSource>(source.value); from != PositionSource::depth)
      out.push_back(route(s, pixel, from, PositionReconstruct::view_ray));
  return out;
}

}  // namespace gbl
