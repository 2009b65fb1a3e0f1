#pragma once
// The first line of a layout file: which attachments it has, and what they hold.
//   // attachments: material RGBA8 { rgb: albedo, sRGB-coded; a: roughness } reflectance RG8 { r: metal; g: occlusion }
// Before the braces what the attachment is to the shaders (the member of Stored) and its format; in them the words of
// renderer/frame/stored_fields.h, checked: channels that the format has, no more bits than a channel, known names.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/gbuffer/layouts.h"

namespace gbl {

struct HeaderAttachment {
  std::string name;  // "gbuffer.material"
  Stores stores{};
  Format format{};
  std::string contents;
  std::vector<std::string> holds;  // names, in their order
};

struct LayoutHeader {
  std::vector<HeaderAttachment> attachments;
  int normal_bits = 0;  // that the material's first word keeps for a normal

  bool holds(std::string_view name) const;
  int bytes() const;      // per pixel, of these attachments
  LayoutRow row() const;  // points into this header; without its value row
};

// Error(bad_input): FILE:1:COLUMN and what is wrong there.
LayoutHeader parse_layout_header(std::string_view text, const std::string& file);

// What an attachment can hold; others are refused with the nearest of these.
std::span<const std::string_view> layout_names();

}  // namespace gbl
