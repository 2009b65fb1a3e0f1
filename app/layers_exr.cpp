#include "app/layers_exr.h"

#include <cctype>
#include <fmt/format.h>

#include "renderer/picture/exr.h"

namespace gbl {
namespace {

// The conventions of OpenEXR's layers: R G B of colours, X Y Z of vectors, Z of depth, Y of any other single number.
std::string channel_name(View v, int component) {
  const ViewValues& values = row(v).values;
  if (values.components == 1) return v == View::depth ? "Z" : "Y";
  return {static_cast<char>(std::toupper(static_cast<unsigned char>(values.channels[component])))};
}

ExrChannel channel(std::string name, const std::vector<glm::vec4>& numbers, int component, bool whole = false) {
  ExrChannel c{std::move(name), {}, whole};
  c.values.reserve(numbers.size());
  for (const glm::vec4& n : numbers) c.values.push_back(n[component]);
  return c;
}

}  // namespace

void write_layers(const std::filesystem::path& path, Lab& lab, const std::vector<View>& views_shown,
                  const PngText& texts) {
  std::vector<ExrChannel> channels;
  const std::vector<glm::vec4> lit = lab.numbers_of(View::lit), depth = lab.numbers_of(View::depth);
  for (int k = 0; k < 3; ++k) channels.push_back(channel(std::string(1, "RGB"[k]), lit, k));
  channels.push_back(channel("A", depth, 3));
  channels.push_back(channel("Z", depth, 0));
  for (const View v : views_shown) {
    const std::vector<glm::vec4> numbers = lab.numbers_of(v);
    const bool whole = (counted(v) || row(v).numbered) && row(v).values.black >= 0;  // a difference has a sign
    for (int k = 0; k < row(v).values.components; ++k)
      channels.push_back(channel(fmt::format("{}.{}", row(v).id, channel_name(v, k)), numbers, k, whole));
  }
  write_exr(path, lab.drawn().size, channels, texts);
}

}  // namespace gbl
