#include "renderer/frame/packing_svg.h"

#include <fmt/format.h>
#include <string_view>

#include "renderer/frame/attachments.h"

namespace gbl {
namespace {

constexpr int kLeft = 250, kWidth = 640, kRow = 50, kCell = 26, kTop = 44;

struct Cell {
  std::string channels;
  int bits;
};

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

int bits_of_channels(Format f, size_t channels) {
  if (f == Format::r11g11b10f) return 32;
  const FormatRow& r = row(f);
  return static_cast<int>(channels) * r.bytes * 8 / r.channels;
}

// "rgb: albedo; a: roughness" -> two cells; a text without channels is one.
std::vector<Cell> cells_of(const Attachment& a) {
  std::vector<Cell> cells;
  std::string_view rest = a.contents;
  while (!rest.empty()) {
    const size_t end = std::min(rest.find(';'), rest.size());
    std::string_view part = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    const size_t colon = part.find(':');
    const bool named = colon != std::string_view::npos && part.find_first_not_of("rgba") == colon;
    if (named)
      cells.push_back({std::string(part.substr(0, colon)), bits_of_channels(a.format, colon)});
    else
      cells.push_back({"", row(a.format).bytes * 8});
  }
  int unused = row(a.format).bytes * 8;
  for (const Cell& c : cells) unused -= c.bits;
  if (unused > 0) cells.push_back({"unused", unused});
  return cells;
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
        y + 21, escaped(a.name), kLeft - 10, y + 21, row(a.format).label, row(a.format).bytes);
    double x = kLeft;
    for (const Cell& c : cells_of(a)) {
      const double width = double(kWidth) * c.bits / most;
      body += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"#e8eef7\" stroke=\"#335\"/>"
          "<text x=\"{:.1f}\" y=\"{}\"><tspan font-weight=\"bold\">{}</tspan> {}</text>\n",
          x, y, width, kCell, x + 6, y + 18, c.channels, c.bits);
      x += width;
    }
    body += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"11\" fill=\"#333\">{}</text>\n", kLeft, y + kCell + 13,
                        escaped(a.contents));
    y += kRow;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"10\" y=\"24\" font-size=\"16\">{2}: {3} bytes per pixel</text>\n{4}</svg>\n",
      kLeft + kWidth + 10, y + 8, escaped(title), gbuffer_bytes_per_pixel(s), body);
}

}  // namespace gbl
