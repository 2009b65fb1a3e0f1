// A layout from a file is drawn like one of the lab's own, and what is wrong with it is said with its own lines.
#include "renderer/gbuffer/layout_file.h"

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/resources.h"
#include "renderer/frame/attachments.h"
#include "renderer/frame/stored_fields.h"
#include "tests/gl_fixture.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

class LayoutFiles : public GlTest {
 protected:
  TemporaryFolder folder{"layout-files"};

  Settings with(const std::string& header, const std::string& code) {
    write_text_file(folder / "mine.glsl", header + "\n" + code);
    Settings s = settings_for(yard());
    s.layout_file = name_layout_file((folder / "mine.glsl").string());
    return s;
  }
};

// The header that a row of layouts.inc would have.
std::string header_of(const LayoutRow& row) {
  constexpr std::pair<Stores, const char*> kWords[] = {{Stores::material, "material"},
                                                       {Stores::reflectance, "reflectance"},
                                                       {Stores::emission, "emission"},
                                                       {Stores::ambient, "ambient"},
                                                       {Stores::shininess, "shininess"}};
  std::string out = "// attachments:";
  for (const MaterialTexel& t : row.material)
    for (const auto& [stores, word] : kWords)
      if (t.name && t.stores == stores)
        out += fmt::format(" {} {} {{ {} }}", word, gbl::row(t.format).label, t.contents);
  return out;
}

TEST_F(LayoutFiles, TheLabsOwnAsAFileGiveTheSameBits) {
  for (const Layout l : {Layout::albedo_roughness, Layout::compact, Layout::exact, Layout::viewspace}) {
    Settings own = settings_for(yard());
    own.layout = l;
    own.normal.encoding = NormalEncoding::oct14;
    std::string header = header_of(facts(l));
    Settings mine = with(header, resource("shaders/" + shader_of(l)));
    mine.normal.encoding = NormalEncoding::oct14;
    Stage& stage = shared_stage(yard());
    stage.draw(own);
    const auto expected = stored(stage.targets);
    const FrameReport report = stage.draw(mine);
    const auto drawn = stored(stage.targets);
    ASSERT_EQ(drawn.size(), expected.size()) << gbl::row(l).id;
    for (size_t i = 0; i < drawn.size(); ++i) {
      const auto off = std::mismatch(drawn[i].begin(), drawn[i].end(), expected[i].begin());
      EXPECT_TRUE(off.first == drawn[i].end())
          << gbl::row(l).id << ", attachment " << i << ", byte " << off.first - drawn[i].begin() << ": "
          << int(*off.first) << ", not " << int(*off.second);
    }
    EXPECT_EQ(report.gbuffer_bytes_per_pixel, gbuffer_bytes_per_pixel(own)) << gbl::row(l).id;
    EXPECT_EQ(stage.view(View::material, mine), stage.view(View::material, own)) << gbl::row(l).id;
  }
}

constexpr const char* kHeader = "// attachments: material RGBA8 { rgb: albedo, sRGB-coded; a: roughness }";
constexpr const char* kPack =
    "Stored pack_material(Surface s) {\n  Stored t;\n  t.material = vec4(albedo8(s.albedo), kept8(s.roughness));\n"
    "  return t;\n}\n";

TEST_F(LayoutFiles, ErrorsOfTheCompilerHaveTheUsersLine) {
  const Settings s =
      with(kHeader, std::string(kPack) + "void unpack_material(Stored t, inout Surface s) {\n  s.albdo = t;\n}\n");
  const std::string line = error_line(ExitCode::bad_input, [&] { Stage(yard()).draw(s); });
  EXPECT_TRUE(line.starts_with((folder / "mine.glsl").string() + ":8:")) << line;
}

TEST_F(LayoutFiles, IncludesStayInTheShadersFolder) {
  const Settings s = with(kHeader, "#include \"../../secret.txt\"\n" + std::string(kPack));
  const std::string line = error_line(ExitCode::bad_input, [&] { Stage(yard()).draw(s); });
  EXPECT_TRUE(contains(line, "leaves the shaders' folder")) << line;
}

TEST_F(LayoutFiles, AChangedFileIsAnotherProgram) {
  const std::string unpack =
      "void unpack_material(Stored t, inout Surface s) {\n  s.albedo = albedo_of8(t.material.rgb);\n"
      "  set_roughness(s, t.material.a);\n  s.ambient = ambient_of(s);\n}\n";
  Stage& stage = shared_stage(yard());
  const Settings first = with(kHeader, kPack + unpack);
  const Picture before = stage.lit(first);
  std::string darker = unpack;
  darker.replace(darker.find("albedo_of8(t.material.rgb)"), 26, "vec3(0.0)");
  const Settings second = with(kHeader, kPack + darker);
  EXPECT_FALSE(first == second);
  EXPECT_NE(stage.lit(second).texels, before.texels);
  EXPECT_EQ(stage.lit(first).texels, before.texels) << "the first is still what it was";
}

}  // namespace
}  // namespace gbl::test
