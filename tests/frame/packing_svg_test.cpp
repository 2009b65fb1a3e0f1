#include "renderer/frame/packing_svg.h"

#include <gtest/gtest.h>
#include <regex>

#include "renderer/frame/attachments.h"
#include "renderer/frame/resolve.h"
#include "renderer/options/presets.h"

namespace gbl {
namespace {

TEST(PackingSvg, NamesEveryTargetAndItsBitsAddUp) {
  for (const Preset& p : presets()) {
    const Settings s = resolve(p.make(), Scene{}).settings;
    const std::string svg = packing_svg(s, p.id);
    EXPECT_EQ(svg.rfind("<svg ", 0), 0u) << p.id;
    int bits = 0;
    for (const Attachment& a : attachments(s))
      if (a.written_by == Pass::geometry) {
        EXPECT_NE(svg.find(a.name), std::string::npos) << p.id << " " << a.name;
      }
    static const std::regex kCell("</tspan> (\\d+)</text>");
    for (std::sregex_iterator it(svg.begin(), svg.end(), kCell), end; it != end; ++it) bits += std::stoi((*it)[1]);
    EXPECT_EQ(bits, 8 * gbuffer_bytes_per_pixel(s)) << p.id;
  }
}

}  // namespace
}  // namespace gbl
