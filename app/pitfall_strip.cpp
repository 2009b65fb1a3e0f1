#include "app/pitfall_strip.h"

#include <algorithm>
#include <cmath>

#include "renderer/picture/colour_map.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;
constexpr glm::ivec2 kDrawn{1152, 648};
constexpr uintmax_t kMostBytes = 120 * 1000;
constexpr int kGap = 6;             // pixels between the pictures, white
constexpr int kSameWithin = 2;      // codes: of pictures that show the same
constexpr double kEnough = 0.6;     // of the difference is to be seen in the part that is cut out
constexpr double kCommonMost = 16;  // codes: a smaller difference is not made brighter than this

Image picture_of_side(Lab& lab, const PitfallEntry& e, PitfallSide side) {
  Settings s = settings_of(e, side);
  s.size = kDrawn;
  lab.open(s.scene);
  lab.draw(s);
  const View view = view_by_id(s.view.main).view;
  if (needs_truth(view))
    lab.draw_truth_view(view, true);
  else
    lab.draw_measured_view(view, {.overlays = true});
  return lab.image_of(view);
}

// Of each pixel the channel that differs most, in codes.
std::vector<double> differences(const Image& a, const Image& b) {
  std::vector<double> out(a.rgba.size() / 4);
  for (size_t i = 0; i < out.size(); ++i)
    for (size_t k = 0; k < 3; ++k)
      out[i] = std::max(out[i], std::abs(double(a.rgba[4 * i + k]) - double(b.rgba[4 * i + k])));
  return out;
}

double percentile(std::vector<double> values, double share) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(share * double(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

Image coloured(const std::vector<double>& codes, glm::ivec2 size, double most) {
  Image out{size, {}};
  for (const double c : codes) {
    const glm::vec3 colour = colour_at(stops_of(ColourMap::magma), std::min(c / most, 1.0));
    for (int k = 0; k < 3; ++k) out.rgba.push_back(static_cast<uint8_t>(std::lround(255 * colour[k])));
    out.rgba.push_back(255);
  }
  return out;
}

struct Part {
  glm::ivec2 first, size;
};

// The smallest part of the picture's own shape in which most of the difference lies.
Part where_it_shows(const std::vector<double>& codes, glm::ivec2 size) {
  const auto width = static_cast<size_t>(size.x) + 1;
  std::vector<double> sums(width * (static_cast<size_t>(size.y) + 1));  // of all above and to the left
  const auto at = [&](glm::ivec2 p) -> double& {
    return sums[static_cast<size_t>(p.y) * width + static_cast<size_t>(p.x)];
  };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      at({x + 1, y + 1}) = at({x, y + 1}) + at({x + 1, y}) - at({x, y}) + codes[static_cast<size_t>(y * size.x + x)];
  for (const int parts : {3, 4, 5, 6, 7}) {  // eighths of the picture's width
    const glm::ivec2 window = size * parts / 8;
    Part best{{0, 0}, window};
    double most = -1;
    for (int y = 0; y + window.y <= size.y; y += 8)
      for (int x = 0; x + window.x <= size.x; x += 8) {
        const glm::ivec2 a(x, y), b = a + window;
        const double sum = at(b) - at({a.x, b.y}) - at({b.x, a.y}) + at(a);
        if (sum > most) most = sum, best.first = a;
      }
    if (most >= kEnough * at(size)) return best;
  }
  return {{0, 0}, size};
}

// Shrunk or stretched: each pixel the mean of what it covers.
Image resampled(const Image& from, const Part& part, glm::ivec2 size) {
  Image out{size, {}};
  const glm::dvec2 step = glm::dvec2(part.size) / glm::dvec2(size);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::ivec2 low = part.first + glm::ivec2(glm::floor(glm::dvec2(x, y) * step));
      const glm::ivec2 high = glm::max(part.first + glm::ivec2(glm::floor(glm::dvec2(x + 1, y + 1) * step)), low + 1);
      glm::dvec3 sum(0);
      for (int j = low.y; j < high.y; ++j)
        for (int i = low.x; i < high.x; ++i)
          for (int k = 0; k < 3; ++k)
            sum[k] += from.rgba[4 * static_cast<size_t>(j * from.size.x + i) + static_cast<size_t>(k)];
      const glm::ivec2 covered = high - low;
      for (int k = 0; k < 3; ++k)
        out.rgba.push_back(static_cast<uint8_t>(std::lround(sum[k] / (covered.x * covered.y))));
      out.rgba.push_back(255);
    }
  return out;
}

Image beside(const PitfallStrip& s, int width) {
  const glm::ivec2 tile(width, width * s.broken.size.y / s.broken.size.x);
  Image out{{3 * tile.x + 2 * kGap, tile.y}, {}};
  out.rgba.assign(4 * static_cast<size_t>(out.size.x) * static_cast<size_t>(out.size.y), 255);
  int left = 0;
  for (const Image* from : {&s.broken, &s.fixed, &s.difference}) {
    const Image small = resampled(*from, {{0, 0}, from->size}, tile);
    for (int y = 0; y < tile.y; ++y)
      std::copy_n(small.rgba.begin() + 4 * y * tile.x, 4 * tile.x, out.rgba.begin() + 4 * (y * out.size.x + left));
    left += tile.x + kGap;
  }
  return out;
}

bool shows_the_same(const fs::path& path, const Image& picture) {
  if (!fs::exists(path)) return false;
  const Image old = read_png(path);
  if (old.size != picture.size) return false;
  for (size_t i = 0; i < old.rgba.size(); ++i)
    if (std::abs(int(old.rgba[i]) - int(picture.rgba[i])) > kSameWithin) return false;
  return true;
}

}  // namespace

PitfallStrip draw_strip(Lab& lab, const PitfallEntry& e) {
  const Image broken = picture_of_side(lab, e, PitfallSide::broken),
              fixed = picture_of_side(lab, e, PitfallSide::fixed);
  const std::vector<double> codes = differences(broken, fixed);
  PitfallStrip out{.most_codes = std::max(kCommonMost, percentile(codes, 0.999))};
  const Image difference = coloured(codes, kDrawn, out.most_codes);
  const Part part = where_it_shows(codes, kDrawn);
  out.broken = resampled(broken, part, part.size), out.fixed = resampled(fixed, part, part.size);
  out.difference = resampled(difference, part, part.size);
  return out;
}

void write_strip(const fs::path& path, const PitfallStrip& strip) {
  fs::path tried = path;
  tried += ".tmp";
  for (const int width : {400, 360, 320, 288, 256, 224, 192, 160, 128}) {
    const Image picture = beside(strip, width);
    if (shows_the_same(path, picture)) {
      fs::remove(tried);
      return;
    }
    write_png(tried, picture);
    if (fs::file_size(tried) <= kMostBytes) break;
  }
  fs::rename(tried, path);
}

}  // namespace gbl
