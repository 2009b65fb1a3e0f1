// The README's tables are those that the program prints: between <!-- list WHAT --> and <!-- end -->.
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

#include "app/commands.h"
#include "tests/test_paths.h"

namespace gbl {
namespace {

std::string readme() {
  std::ifstream file(test::source_folder() / "README.md");
  EXPECT_TRUE(file);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Readme, TablesAreWhatListPrints) {
  const std::string text = readme();
  static const std::regex kMark("<!-- list ([a-z-]+) -->\n");
  int tables = 0;
  for (auto mark = std::sregex_iterator(text.begin(), text.end(), kMark); mark != std::sregex_iterator(); ++mark) {
    const std::string what = (*mark)[1];
    const size_t from = size_t(mark->position() + mark->length()), to = text.find("<!-- end -->", from);
    ASSERT_NE(to, std::string::npos) << what;
    EXPECT_EQ(text.substr(from, to - from), list_markdown(what)) << "put in: gbufferlab list " << what << " --md";
    ++tables;
  }
  EXPECT_GT(tables, 0);
}

}  // namespace
}  // namespace gbl
