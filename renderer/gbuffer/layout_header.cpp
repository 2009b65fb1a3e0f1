#include "renderer/gbuffer/layout_header.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/split.h"

namespace gbl {
namespace {

constexpr std::string_view kBegin = "// attachments:", kChannels = "rgba", kBlank = " \t\r";
constexpr std::string_view kExample = "e.g. // attachments: material RGBA8 { rgb: albedo, sRGB-coded; a: roughness }";

struct StoresWord {
  std::string_view word;
  Stores stores;
  bool as_material;  // numbers or words as the material is; else numbers
};
constexpr StoresWord kStores[] = {{"material", Stores::material, true},
                                  {"reflectance", Stores::reflectance, true},
                                  {"emission", Stores::emission, true},
                                  {"ambient", Stores::ambient, false},
                                  {"shininess", Stores::shininess, false}};

bool as_material(Stores what) {
  return std::any_of(std::begin(kStores), std::end(kStores),
                     [&](const StoresWord& s) { return s.stores == what && s.as_material; });
}

constexpr std::string_view kNames[] = {
    "albedo",          "base colour", "diffuse colour", "roughness",      "metal",  "F0",    "occlusion",
    "specular colour", "emission",    "exponent",       "ambient colour", "normal", "unused"};

constexpr int kNoNumber = -1;
int whole(std::string_view text) {
  int n = kNoNumber;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  return error == std::errc() && end == text.data() + text.size() ? n : kNoNumber;
}

const HeaderAttachment* find(const LayoutHeader& h, Stores what) {
  for (const HeaderAttachment& a : h.attachments)
    if (a.stores == what) return &a;
  return nullptr;
}

bool words_format(Format f) { return row(f).numeric == Numeric::uint; }

// Parts of a line keep their place in it: a view into the line says the column.
class Reader {
 public:
  Reader(std::string_view line, const std::string& file) : line_(line), rest_(line), file_(file) {}

  LayoutHeader read() {
    rest_ = trimmed(rest_);
    if (!rest_.starts_with(kBegin)) bad(rest_, fmt::format("the first line must begin with \"{}\"", kBegin), kExample);
    rest_.remove_prefix(kBegin.size());
    while (!(rest_ = trimmed(rest_)).empty()) read_attachment();
    if (!find(header_, Stores::material)) bad(rest_, "no attachment is the material", kExample);
    return std::move(header_);
  }

 private:
  [[noreturn]] void bad(std::string_view at, const std::string& what, std::string_view fix = {}) const {
    const auto column = at.data() - line_.data() + 1;
    throw Error(ExitCode::bad_input, fmt::format("{}:1:{}", file_, column), what, fix);
  }

  static std::string_view trimmed(std::string_view text) {
    const size_t first = std::min(text.find_first_not_of(kBlank), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(kBlank) + 1);
  }

  std::string_view next_word() {
    rest_ = trimmed(rest_);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t{}"));
    rest_.remove_prefix(word.size());
    return word;
  }

  void read_attachment() {
    HeaderAttachment a;
    const StoresWord& stores = read_stores();
    a.stores = stores.stores, a.name = fmt::format("gbuffer.{}", stores.word);
    a.format = read_format(stores);
    rest_ = trimmed(rest_);
    if (!rest_.starts_with('{')) bad(rest_, "after the format comes what is stored, in { }", kExample);
    rest_.remove_prefix(1);
    const size_t end = rest_.find('}');
    if (end == std::string_view::npos) bad(rest_, "the { has no }");
    const std::string_view contents = trimmed(rest_.substr(0, end));
    a.contents = contents;
    taken_ = {};
    for (const std::string_view group : split(contents, "; ")) read_group(a, group);
    rest_.remove_prefix(end + 1);
    header_.attachments.push_back(std::move(a));
  }

  const StoresWord& read_stores() {
    const std::string_view word = next_word();
    std::vector<std::string_view> known;
    for (const StoresWord& s : kStores) known.push_back(s.word);
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) bad(word, fmt::format("unknown attachment '{}'", word), suggest(word, known));
    const StoresWord& s = kStores[found - known.begin()];
    for (const HeaderAttachment& a : header_.attachments)
      if (a.stores == s.stores) bad(word, fmt::format("'{}' is named twice", word));
    return s;
  }

  Format read_format(const StoresWord& stores) {
    const std::string_view word = next_word();
    std::vector<std::string_view> known;
    for (const FormatRow& f : kFormats)
      if (f.numeric != Numeric::depth) known.emplace_back(f.label);
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) bad(word, fmt::format("unknown format '{}'", word), suggest(word, known));
    const auto* format =
        std::find_if(std::begin(kFormats), std::end(kFormats), [&](const FormatRow& f) { return word == f.label; });
    const bool words = words_format(format->format);
    if (!stores.as_material && words)
      bad(word, fmt::format("{} holds numbers, not whole words of bits", stores.word), "choose a format without UI");
    for (const HeaderAttachment& a : header_.attachments)
      if (stores.as_material && as_material(a.stores) && words_format(a.format) != words)
        bad(word, fmt::format("{} and {} must both be words of bits (UI) or both be numbers", stores.word,
                              a.name.substr(a.name.find('.') + 1)));
    return format->format;
  }

  void read_group(HeaderAttachment& a, std::string_view group) {
    group = trimmed(group);
    const size_t colon = group.find(": ");
    if (colon == std::string_view::npos) bad(group, "expected CHANNELS: WHAT", kExample);
    std::string_view channels = group.substr(0, colon);
    const bool half = channels.ends_with(", where it shines") || channels.ends_with(", elsewhere");
    if (half) channels = channels.substr(0, channels.find(','));
    const bool words = words_format(a.format);
    for (const char& c : channels) take_channel(a, {&c, 1}, half);
    if (channels.empty()) bad(group, "no channel is named", kExample);
    if (words && channels.size() != 1) bad(channels, "of words of bits each channel is described by itself");
    const std::string_view text = group.substr(colon + 2);
    if (!words) return read_numbers(a, text);
    int bits = 0;
    for (const std::string_view item : split(text, ", ")) bits += read_item(a, channels, trimmed(item), bits);
    const int most = row(a.format).channel_bits[kChannels.find(channels)];
    if (bits > most) bad(text, fmt::format("{} bits, and a channel of {} has {}", bits, row(a.format).label, most));
  }

  void take_channel(const HeaderAttachment& a, std::string_view c, bool half) {
    const size_t channel = kChannels.find(c);
    const auto count = static_cast<size_t>(row(a.format).channels);
    if (channel >= count)
      bad(c, fmt::format("'{}' is no channel of {}", c, row(a.format).label),
          fmt::format("it has {}", kChannels.substr(0, count)));
    if (taken_[channel] && !half) bad(c, fmt::format("the channel '{}' is described twice", c));
    taken_[channel] = true;
  }

  void read_numbers(HeaderAttachment& a, std::string_view text) {
    std::string_view name = text.substr(0, text.find(", "));
    if (name == "1" || name == "1 where a surface is") return;
    if (const size_t by = name.find(" / "); by != std::string_view::npos) {
      if (whole(name.substr(by + 3)) < 1) bad(name.substr(by + 3), "expected a whole number from 1 after the /");
      name = name.substr(0, by);
    }
    take_name(a, name);
    if (name == "normal") bad(name, "only the first word of a material in words of bits has room for a normal");
  }

  // "base colour 9 9 8 sRGB-coded": the bits that it takes.
  int read_item(HeaderAttachment& a, std::string_view channel, std::string_view item, int first) {
    std::string_view name = item.substr(0, item.find_first_of("0123456789"));
    // "F0" has a digit of its own.
    if (item.starts_with("F0")) name = item.substr(0, 2);
    name = trimmed(name);
    if (name.ends_with(" bits")) name = name.substr(0, name.size() - 5);
    int bits = 0;
    for (const std::string_view word : split(item.substr(name.size()), " ")) {
      const size_t dash = std::min(word.find('-'), word.size());
      const int n = whole(word), from = whole(word.substr(0, dash));
      const int to = dash < word.size() ? whole(word.substr(dash + 1)) : kNoNumber;
      if (n == 0 || n > 32) bad(word, "a code has 1 to 32 bits");
      if (to != kNoNumber && to < from) bad(word, "the bits of a part run from the lower to the higher");
      if (n != kNoNumber)
        bits += n;
      else if (from != kNoNumber && to != kNoNumber)
        bits += to - from + 1;
    }
    if (name == "shines") name = "unused";  // the bit that says how the others are shared out
    take_name(a, name);
    if (bits == 0) bad(item, "how many bits?", "e.g. roughness 10");
    if (name == "normal") {
      if (a.stores != Stores::material || channel != "r" || first != 0)
        bad(item, "a normal lies in the lowest bits of the material's r");
      header_.normal_bits = bits;
    }
    return bits;
  }

  void take_name(HeaderAttachment& a, std::string_view name) {
    if (std::find(std::begin(kNames), std::end(kNames), name) == std::end(kNames))
      bad(name, fmt::format("'{}' is nothing that a surface has", name), suggest(name, kNames, std::size(kNames)));
    a.holds.emplace_back(name);
  }

  std::string_view line_, rest_;
  const std::string& file_;
  LayoutHeader header_;
  std::array<bool, 4> taken_{};
};

}  // namespace

bool LayoutHeader::holds(std::string_view name) const {
  return std::any_of(attachments.begin(), attachments.end(), [&](const HeaderAttachment& a) {
    return std::find(a.holds.begin(), a.holds.end(), name) != a.holds.end();
  });
}

int LayoutHeader::bytes() const {
  int sum = 0;
  for (const HeaderAttachment& a : attachments) sum += gbl::row(a.format).bytes;
  return sum;
}

LayoutRow LayoutHeader::row() const {
  LayoutRow out;
  const bool specular = holds("F0") || holds("specular colour"), rough = holds("roughness") || holds("exponent");
  out.shows = rough ? MaterialView::roughness : specular ? MaterialView::specular : MaterialView::nothing;
  const char* const shown = holds("roughness") ? "roughness"
                            : rough            ? "exponent"
                            : holds("F0")      ? "F0"
                                               : "specular colour";
  for (const HeaderAttachment& a : attachments)
    for (const std::string& name : a.holds)
      if (name == shown) out.shows_stored = a.stores;
  const HeaderAttachment& material = *find(*this, Stores::material);
  out.words = words_format(material.format);
  out.floats = material.format == Format::rgba32f;
  out.keeps_emission = holds("emission");
  out.keeps = {.reflectance = specular || holds("metal"),
               .metal = holds("metal"),
               .occlusion = holds("occlusion"),
               .ambient = holds("ambient colour"),
               .exponent = holds("exponent")};
  const HeaderAttachment* const ambient = find(*this, Stores::ambient);  // gbuffer_read.glsl asks this one first
  const std::string& marked = (ambient ? *ambient : material).contents;
  out.alpha_marks = (ambient || !out.words) && marked.find("a: 1 where a surface is") != std::string::npos;
  out.normal_bits = normal_bits;
  for (size_t i = 0; i < attachments.size(); ++i) {
    const HeaderAttachment& a = attachments[i];
    out.material[i] = {a.name.c_str(), a.stores, a.format, a.contents.c_str()};
  }
  return out;
}

LayoutHeader parse_layout_header(std::string_view text, const std::string& file) {
  return Reader(text.substr(0, text.find('\n')), file).read();
}

std::span<const std::string_view> layout_names() { return kNames; }

}  // namespace gbl
