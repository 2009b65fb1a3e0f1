#include "renderer/gbuffer/layout_file.h"

#include <fmt/format.h>

#include "renderer/base/files.h"
#include "renderer/gbuffer/layout_header.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

std::string refused(const std::string& header) {
  return error_line(ExitCode::bad_input, [&] { parse_layout_header(fmt::format("{}\ncode\n", header), "mine.glsl"); });
}

// The column of `part` in the line, as the message must have it.
void expect_refused_at(const std::string& header, const std::string& part, const std::string& because) {
  const std::string line = refused(header);
  const size_t column = header.find(part) + 1;
  EXPECT_TRUE(line.starts_with(fmt::format("mine.glsl:1:{}: ", column))) << line << "\nwanted column " << column;
  EXPECT_TRUE(contains(line, because)) << line;
}

TEST(LayoutHeader, SaysWhatTheAttachmentsAre) {
  const LayoutHeader h = parse_layout_header(
      "// attachments: material RGBA8 { rgb: base colour, sRGB-coded; a: roughness } reflectance RG8 { r: metal; g: "
      "occlusion }\nrest",
      "mine.glsl");
  ASSERT_EQ(h.attachments.size(), 2u);
  EXPECT_EQ(h.attachments[0].name, "gbuffer.material");
  EXPECT_EQ(h.attachments[1].format, Format::rg8);
  EXPECT_EQ(h.attachments[0].contents, "rgb: base colour, sRGB-coded; a: roughness");
  EXPECT_EQ(h.bytes(), 6);
  const LayoutRow row = h.row();
  EXPECT_FALSE(row.words);
  EXPECT_TRUE(row.keeps.metal && row.keeps.occlusion && row.keeps.reflectance);
  EXPECT_FALSE(row.keeps_emission || row.keeps.exponent || row.keeps.ambient || row.floats || row.alpha_marks);
  EXPECT_EQ(row.shows, MaterialView::roughness);
  EXPECT_STREQ(row.material[1].name, "gbuffer.reflectance");
  EXPECT_EQ(row.material[2].name, nullptr);
}

TEST(LayoutHeader, WordsMayHoldANormal) {
  const LayoutHeader h = parse_layout_header(
      "// attachments: material RG32UI { r: normal 28, roughness bits 6-9; g: albedo 9 9 8 sRGB-coded, roughness bits "
      "0-5 }",
      "mine.glsl");
  EXPECT_EQ(h.normal_bits, 28);
  EXPECT_TRUE(h.row().words);
  EXPECT_EQ(h.row().normal_bits, 28);
}

TEST(LayoutHeader, EachMistakeHasItsColumn) {
  expect_refused_at("vec4 x;", "vec4", "must begin with");
  expect_refused_at("// attachments: colour RGBA8 { rgb: albedo }", "colour", "unknown attachment 'colour'");
  EXPECT_TRUE(contains(refused("// attachments: emission RGBA8 { rgb: emission }"), "no attachment is the material"));
  expect_refused_at("// attachments: material RGBA9 { rgb: albedo }", "RGBA9", "did you mean 'RGBA8'");
  expect_refused_at("// attachments: material D24 { r: albedo }", "D24", "unknown format");
  expect_refused_at("// attachments: material RGBA8 rgb: albedo", "rgb", "in { }");
  expect_refused_at("// attachments: material RGBA8 { rgb: albedo", " rgb", "has no }");
  expect_refused_at("// attachments: material RG8 { rgb: albedo }", "b:", "'b' is no channel of RG8");
  expect_refused_at("// attachments: material RGBA8 { rgb: albedo; b: metal }", "b: metal", "described twice");
  expect_refused_at("// attachments: material RGBA8 { rgb: albdo }", "albdo", "did you mean 'albedo'");
  expect_refused_at("// attachments: material R32UI { r: albedo 12 12 12 }", "albedo", "36 bits");
  expect_refused_at("// attachments: material R32UI { r: albedo }", "albedo", "how many bits");
  expect_refused_at("// attachments: material RGBA8 { rgb: albedo } reflectance R32UI { r: metal 8 }", "R32UI",
                    "both be words of bits");
  expect_refused_at("// attachments: material R32UI { r: albedo 8 8 8 } shininess R32UI { r: exponent 8 }",
                    "R32UI { r: exp", "holds numbers");
  expect_refused_at(
      "// attachments: material RGBA8 { rgb: albedo } ambient RGBA8 { rgb: ambient colour } ambient RG8 { r: "
      "roughness }",
      "ambient RG8", "named twice");
}

constexpr const char* kText =
    "// attachments: material RGBA8 { rgb: albedo, sRGB-coded; a: roughness }\nStored pack_material(Surface s) {}\n";

TEST(LayoutFile, ItsNameSaysItsContent) {
  const TemporaryFolder folder("layout-file");
  const std::string path = (folder.path() / "mine.glsl").string();
  write_text_file(path, kText);
  const std::string unasked = name_unasked_layout_file(path);
  const auto use = [&] { layout_of_file(unasked); };
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, use), "asked for by nobody: it is not run"));
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [&] { shader_of_layout_file(unasked); }), "--layout-file"));
  const std::string name = name_layout_file(path);
  EXPECT_EQ(name, unasked);
  EXPECT_NO_THROW(use());
  EXPECT_TRUE(names_content(name));
  EXPECT_EQ(path_of_layout_file(name), path);
  EXPECT_STREQ(layout_of_file(name).axis.id, "mine.glsl");
  EXPECT_STREQ(layout_of_file(name).axis.cost, "4 B/px");

  write_text_file(path, fmt::format("{}// changed\n", kText));
  const std::string changed = name_layout_file(path);
  EXPECT_NE(changed, name) << "two contents of one path are two layouts";
  EXPECT_NE(shader_of_layout_file(changed), shader_of_layout_file(name));
  EXPECT_STREQ(layout_of_file(name).axis.id, "mine.glsl") << "what was read goes on being what it was";
}

TEST(LayoutFile, OneThatIsGoneOrChangedIsRefused) {
  const TemporaryFolder folder("layout-file-gone");
  const std::string path = (folder.path() / "mine.glsl").string();
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [&] { name_layout_file(path); }), "cannot be read"));
  EXPECT_TRUE(
      contains(error_line(ExitCode::bad_input, [&] { layout_of_file(fmt::format("{}@0123456789abcdef", path)); }),
               "cannot be read"));
  write_text_file(path, kText);
  const std::string line =
      error_line(ExitCode::bad_input, [&] { layout_of_file(fmt::format("{}@0123456789abcdef", path)); });
  EXPECT_TRUE(contains(line, "was changed")) << line;
  EXPECT_TRUE(contains(line, "--layout-file")) << line;
}

}  // namespace
}  // namespace gbl
