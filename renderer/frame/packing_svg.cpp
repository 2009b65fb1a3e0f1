#include "renderer/frame/packing_svg.h"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

#include "renderer/frame/attachments.h"
#include "renderer/frame/stored_fields.h"
#include "renderer/picture/svg.h"

namespace gbl {
namespace {

constexpr int kLeft = 250, kWidth = 640, kRow = 50, kCell = 26, kTop = 44;

struct Cell {
  std::string name;
  int bits;
};

// Bits of one field that lie side by side, in the order in which they lie.
std::vector<Cell> cells_of(const Settings& s, const Attachment& a) {
  struct Piece {
    BitRun run;
    std::string_view name;
  };
  const std::vector<StoredField> fields = stored_fields(s, a);
  std::vector<Piece> pieces;
  for (const StoredField& f : fields)
    for (const BitRuns& code : f.components)
      for (const BitRun& r : code) pieces.push_back({r, f.name});
  std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
    return std::pair(p.run.channel, p.run.first) < std::pair(q.run.channel, q.run.first);
  });
  std::vector<Cell> cells;
  for (const Piece& p : pieces)
    if (!cells.empty() && cells.back().name == p.name)
      cells.back().bits += p.run.bits;
    else
      cells.push_back({std::string(p.name), p.run.bits});
  return cells;
}

// As many words of the field's name as there is room for beside its bits.
std::string_view name_in(const Cell& c, double width) {
  constexpr double kLetter = 7.5, kNumber = 30;
  std::string_view name = c.name;
  while (!name.empty() && kLetter * static_cast<double>(name.size()) + kNumber > width)
    name = name.substr(0, name.find(' ') == std::string_view::npos ? 0 : name.rfind(' '));
  return name;
}

}  // namespace

std::string packing_svg(const Settings& s, const std::string& title) {
  std::string body;
  int y = kTop, most = 32;
  std::vector<Attachment> shown;
  for (const Attachment& a : attachments(s))
    if (a.written_by == Pass::geometry) {
      shown.push_back(a);
      most = std::max(most, row(a.format).bytes * 8);
    }
  for (const Attachment& a : shown) {
    body += fmt::format(
        "<text x=\"10\" y=\"{}\">{}</text><text x=\"{}\" y=\"{}\" text-anchor=\"end\" fill=\"#555\">{} · {} B</text>\n",
        y + 21, svg_escaped(a.name), kLeft - 10, y + 21, row(a.format).label, row(a.format).bytes);
    double x = kLeft;
    for (const Cell& c : cells_of(s, a)) {
      const double width = double(kWidth) * c.bits / most;
      body += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"#e8eef7\" stroke=\"#335\"/>"
          "<text x=\"{:.1f}\" y=\"{}\"><tspan font-weight=\"bold\">{}</tspan> {}</text>\n",
          x, y, width, kCell, x + std::min(6.0, width / 5), y + 18, svg_escaped(name_in(c, width)), c.bits);
      x += width;
    }
    body += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"11\" fill=\"#333\">{}</text>\n", kLeft, y + kCell + 13,
                        svg_escaped(a.contents));
    y += kRow;
  }
  const std::string head = svg_text({10, 24}, fmt::format("{}: {} bytes per pixel", title, gbuffer_bytes_per_pixel(s)),
                                    SvgAnchor::start, 16);
  return svg_page({kLeft + kWidth + 10, y + 8}, head + body);
}

}  // namespace gbl
