#include "renderer/inspect/pixel_probe.h"

#include <fmt/format.h>

namespace gbl {
namespace {

constexpr ProbeFieldRow kFields[] = {
#define PROBE_FIELD(name, components, unit, view, value) {#name, components, #unit, View::view},
#include "shaders/probe_fields.h"
#undef PROBE_FIELD
};

}  // namespace

std::span<const ProbeFieldRow> probe_fields() { return kFields; }

std::string hex(const StoredTexel& t) {
  std::string text;
  const FormatRow& format = row(t.attachment.format);
  for (int c = 0; c < format.channels; ++c)
    text += fmt::format("{}{:0{}x}", c ? " " : "", t.bits[static_cast<size_t>(c)], (format.channel_bits[c] + 3) / 4);
  return text;
}

std::string_view object_name(const PixelProbe& p, const Scene& scene) {
  const size_t number = static_cast<size_t>(p.object());
  return number > 0 && number <= scene.instances.size() ? std::string_view(scene.instances[number - 1].name) : "";
}

}  // namespace gbl
