// `layout-file` stands in the place of `layout`: whichever is set last counts, and files keep both.
#include <fmt/format.h>

#include "renderer/base/files.h"
#include "renderer/gbuffer/layout_file.h"
#include "renderer/options/settings_json.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

class LayoutFileOption : public ::testing::Test {
 protected:
  TemporaryFolder folder{"layout-file-option"};
  std::string file = (folder / "mine.glsl").string();
  void SetUp() override { write_text_file(file, "// attachments: material RG8 { r: metal; g: roughness }\n"); }
};

TEST_F(LayoutFileOption, APathBecomesANameThatSaysItsContent) {
  Settings s;
  apply_assignment(s, fmt::format("layout-file={}", file));
  EXPECT_EQ(s.layout_file, name_layout_file(file));
  EXPECT_EQ(layout_of(s).material[0].format, Format::rg8);
  EXPECT_EQ(parse_settings(settings_text(s), "again"), s);
}

TEST_F(LayoutFileOption, TheLastOneSetCounts) {
  Settings s;
  apply_assignment(s, "layout=exact");
  apply_assignment(s, fmt::format("layout-file={}", file));
  EXPECT_FALSE(s.layout_file.empty());
  apply_assignment(s, "layout=compact");
  EXPECT_TRUE(s.layout_file.empty());
  EXPECT_EQ(&layout_of(s), &facts(Layout::compact));
  cycle(option("layout"), s, 1, {});
  apply_assignment(s, fmt::format("layout-file={}", file));
  cycle(option("layout"), s, 1, {});
  EXPECT_TRUE(s.layout_file.empty()) << "the key of layouts goes on";
  apply_assignment(s, fmt::format("layout-file={}", file));
  apply_assignment(s, "layout-file=\"\"");
  EXPECT_TRUE(s.layout_file.empty());
}

// A state is read as it is; that its file is gone is said when it is to be drawn.
TEST_F(LayoutFileOption, AStateIsReadWithoutItsFile) {
  Settings s;
  apply_assignment(s, fmt::format("layout-file={}", file));
  const std::string text = settings_text(s);
  write_text_file(file, "// attachments: material RGBA8 { rgb: albedo }\n");
  const Settings read = parse_settings(text, "state");
  EXPECT_EQ(read, s);
  Settings now = read;
  apply_assignment(now, fmt::format("layout-file={}", file));
  EXPECT_FALSE(now == read) << "another content is another layout";
}

}  // namespace
}  // namespace gbl
