#include "renderer/frame/stored_fields.h"

#include <algorithm>
#include <charconv>

#include "renderer/base/split.h"
#include "renderer/frame/attachments.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/gbuffer/layouts.h"
#include "renderer/gbuffer/normal_encoding.h"

namespace gbl {
namespace {

constexpr std::string_view kChannels = "rgba", kShines = ", where it shines", kElsewhere = ", elsewhere";

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }
bool whole_number(std::string_view word, int& n) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
  return error == std::errc() && end == word.data() + word.size();
}

class Fields {
 public:
  Fields(const Settings& s, const Attachment& a, bool shines) : s_(s), a_(a), format_(row(a.format)), shines_(shines) {}

  std::vector<StoredField> made() {
    if (format_.numeric == Numeric::depth)
      add_depth();
    else if (a_.stores == Stores::normal)
      add_normal();
    else if (a_.stores == Stores::position)
      add_position();
    else
      for (const std::string_view group : split(a_.contents, "; ")) add_group(group);
    add_unused();
    return std::move(fields_);
  }

 private:
  BitRuns all_of(int channel) const { return {{channel, 0, format_.channel_bits[static_cast<size_t>(channel)]}}; }
  CodeKind kind() const {
    if (format_.numeric == Numeric::floating) return CodeKind::floating;
    return format_.numeric == Numeric::uint ? CodeKind::number : CodeKind::share;
  }

  void add_depth() {
    fields_.push_back({.name = "window depth",
                       .components = {all_of(0)},
                       .kind = format_.channel_bits[0] == 32 ? CodeKind::floating : CodeKind::share});
    if (format_.stencil) fields_.push_back({.name = "stencil", .components = {{{1, 0, 8}}}, .kind = CodeKind::number});
  }

  void add_normal() {
    const EncodingRow& e = row_of(s_.normal.encoding);
    StoredField normal{.name = "normal", .components = {}, .kind = CodeKind::normal};
    for (int c = 0; c < e.channels; ++c)
      normal.components.push_back(
          e.storage() == NormalStorage::word ? BitRuns{{0, c * e.bits_per_channel, e.bits_per_channel}} : all_of(c));
    fields_.push_back(std::move(normal));
  }

  void add_position() {
    constexpr double kViewScale = 1e6;  // shaders/position.glsl
    const PositionSource source = s_.position.source;
    StoredField f{.name = "position in the view", .components = {}, .kind = kind()};
    if (source == PositionSource::linear32f) f.name = "distance";
    if (source == PositionSource::world16f || source == PositionSource::world32f) f.name = "position in the world";
    if (source == PositionSource::view_scaled) f.scale = kViewScale, f.offset = -0.5 * kViewScale;
    for (int c = 0; c < std::min(format_.channels, 3); ++c) f.components.push_back(all_of(c));
    fields_.push_back(std::move(f));
  }

  void add_group(std::string_view group) {
    const size_t colon = group.find(": ");
    std::string_view channels = group.substr(0, colon), text = group.substr(colon + 2);
    const size_t comma = std::min(channels.find(", "), channels.size());
    if (const std::string_view where = channels.substr(comma); where == (shines_ ? kElsewhere : kShines)) return;
    channels = channels.substr(0, comma);
    if (kind() == CodeKind::number && a_.stores != Stores::id)
      for (const std::string_view item : split(text, ", ")) add_item(static_cast<int>(kChannels.find(channels)), item);
    else
      add_numbers(channels, text);
  }

  void add_numbers(std::string_view channels, std::string_view text) {
    StoredField f{.name = std::string(text.substr(0, text.find(", "))), .components = {}, .kind = kind()};
    f.srgb = contains(text, "sRGB-coded");
    if (contains(text, "displayed")) f.scale = 1 / s_.exposure;
    if (const size_t by = f.name.find(" / "); by != std::string::npos) {
      f.scale = std::stod(f.name.substr(by + 3));
      f.name.resize(by);
    }
    const bool light = a_.stores == Stores::light || a_.stores == Stores::diffuse_light ||
                       a_.stores == Stores::specular_light || is_kept_sum();
    if (light) f.scale = 1 / light_sum_scale(s_.exposure);
    for (const char c : channels) f.components.push_back(all_of(static_cast<int>(kChannels.find(c))));
    fields_.push_back(std::move(f));
  }

  // Where the light's sums are kept apart, what would begin them stands beside them, in their units.
  bool is_kept_sum() const { return a_.stores == Stores::emission && layout_of(s_).begins_sum; }

  void add_item(int channel, std::string_view item) {
    int& first = next_[static_cast<size_t>(channel)];
    std::string name;
    std::vector<BitRuns> components;
    bool srgb = false, displayed = false;
    for (const std::string_view word : split(item, " ")) {
      int from = 0, to = 0;
      const size_t dash = word.find('-');
      if (whole_number(word, to)) {
        components.push_back({{channel, first, to}});
        first += to;
      } else if (dash != std::string_view::npos && whole_number(word.substr(0, dash), from) &&
                 whole_number(word.substr(dash + 1), to)) {
        components.push_back({{channel, first, to - from + 1, from}});
        first += to - from + 1;
      } else if (word == "sRGB-coded") {
        srgb = true;
      } else if (word == "displayed") {
        displayed = true;
      } else if (components.empty() && word != "bits") {
        name += (name.empty() ? "" : " ") + std::string(word);
      }
    }
    if (name == kUnusedBits) return;
    if (name == "normal") return add_normal_of_material();
    for (StoredField& f : fields_)
      if (f.name == name) return join(f.components[0], components[0]);
    fields_.push_back({.name = std::move(name),
                       .components = std::move(components),
                       .srgb = srgb,
                       .scale = displayed ? 1 / s_.exposure : 1});
  }

  void add_normal_of_material() {
    if (normal_in_material(s_)) add_normal();
  }

  static void join(BitRuns& code, const BitRuns& part) {
    code.insert(code.end(), part.begin(), part.end());
    std::sort(code.begin(), code.end(), [](const BitRun& a, const BitRun& b) { return a.holds < b.holds; });
  }

  // What is in no field yet, a run of bits each.
  void add_unused() {
    int in_channels = format_.stencil ? 8 : 0;
    for (int c = 0; c < format_.channels; ++c) {
      const int bits = format_.channel_bits[static_cast<size_t>(c)];
      in_channels += bits;
      std::vector<bool> used(static_cast<size_t>(bits), false);
      for (const StoredField& f : fields_)
        for (const BitRuns& code : f.components)
          for (const BitRun& r : code)
            if (r.channel == c) std::fill_n(used.begin() + r.first, r.bits, true);
      for (int first = 0; first < bits;) {
        const auto from = used.begin() + first;
        const int run = static_cast<int>(std::find(from, used.end(), !*from) - from);
        if (!*from) add_unused({c, first, run});
        first += run;
      }
    }
    if (const int padding = format_.bytes * 8 - in_channels; padding > 0) add_unused({kPadding, 0, padding});
  }
  void add_unused(BitRun run) {
    fields_.push_back({.name = kUnusedBits, .components = {{run}}, .kind = CodeKind::number});
  }

  const Settings& s_;
  const Attachment& a_;
  const FormatRow& format_;
  const bool shines_;
  std::array<int, 4> next_{};  // of each channel the lowest bit that no item has taken
  std::vector<StoredField> fields_;
};

}  // namespace

std::vector<StoredField> stored_fields(const Settings& s, const Attachment& a, bool shines) {
  return Fields(s, a, shines).made();
}

}  // namespace gbl
