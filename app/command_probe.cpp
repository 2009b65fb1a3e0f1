// `probe X Y`: one pixel of a frame, stored and decoded.
#include <fmt/format.h>

#include "app/commands.h"
#include "app/headless.h"
#include "app/lab.h"
#include "renderer/base/json.h"
#include "renderer/base/size_text.h"

namespace gbl {
namespace {

// The fields that these settings store, each with as many numbers as it has components.
template <class Use>
void each_field(const PixelProbe& p, const Settings& drawn, Use use) {
  for (size_t i = 0; i < probe_fields().size(); ++i) {
    const ProbeFieldRow& field = probe_fields()[i];
    if (!why_missing(field.view, drawn).empty()) continue;
    const glm::vec4& v = p.values[i];
    use(field, std::vector<float>{&v.x, &v.x + field.components});
  }
}

void print_json(const PixelProbe& p, const Lab& lab) {
  Json json = {{"x", p.pixel.x}, {"y", p.pixel.y}, {"surface", p.surface()}};
  json["object_name"] = object_name(p, lab.scene());
  json["stored"] = Json::array();
  for (const StoredTexel& t : p.stored) {
    const FormatRow& format = row(t.attachment.format);
    Json bits = Json::array();
    for (int c = 0; c < format.channels; ++c) bits.push_back(t.bits[static_cast<size_t>(c)]);
    json["stored"].push_back({{"name", t.attachment.name},
                              {"format", format.label},
                              {"bits", bits},
                              {"hex", hex(t)},
                              {"contents", t.attachment.contents}});
  }
  json["decoded"] = Json::array();
  each_field(p, lab.drawn(), [&](const ProbeFieldRow& field, const std::vector<float>& values) {
    const Json value = field.components == 1 ? Json(values[0]) : Json(values);
    json["decoded"].push_back({{"path", field.path}, {"value", value}, {"unit", field.unit}});
  });
  fmt::print("{}\n", json.dump(2));
}

void print_text(const PixelProbe& p, const Lab& lab) {
  const std::string_view name = object_name(p, lab.scene());
  fmt::print("pixel {}, {} of {}: {}\n\nstored, hexadecimal\n", p.pixel.x, p.pixel.y, size_text(lab.drawn().size),
             !name.empty() ? name
             : p.surface() ? "a surface"
                           : "the background");
  for (const StoredTexel& t : p.stored)
    fmt::print("  {:<24} {:<11} {:<36} {}\n", t.attachment.name, row(t.attachment.format).label, hex(t),
               t.attachment.contents);
  fmt::print("\ndecoded, as the lighting reads it\n");
  each_field(p, lab.drawn(), [](const ProbeFieldRow& field, const std::vector<float>& values) {
    std::string numbers;
    for (const float v : values) numbers += fmt::format("{:>14.7g} ", v);
    fmt::print("  {:<15} {:<46}{}\n", field.path, numbers, field.unit);
  });
}

}  // namespace

ExitCode run_probe(const Arguments& a) {
  const auto [s, scene] = setup_of(a);
  const glm::ivec2 pixel{a.pixel_x.value(), a.pixel_y.value()};
  if (pixel.x >= s.size.x || pixel.y >= s.size.y)
    throw Error(
        ExitCode::bad_input, fmt::format("pixel {} {}", pixel.x, pixel.y),
        fmt::format("it lies outside the picture of {}", size_text(s.size)),
        fmt::format("choose 0 to {} and 0 to {}, from the top left; or another --size", s.size.x - 1, s.size.y - 1));
  const HeadlessContext context;
  Lab lab(without_of(a));
  if (scene) lab.show(s.scene, scene);
  lab.draw(s);
  lab.start_probe(pixel);
  const PixelProbe probe = lab.take_probe(true).value();
  if (a.json)
    print_json(probe, lab);
  else
    print_text(probe, lab);
  return ExitCode::done;
}

}  // namespace gbl
