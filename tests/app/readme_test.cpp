// The documents say what the program says: its tables, its version.
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>
#include <unistd.h>

#include "app/commands.h"
#include "app/docs_pages.h"
#include "renderer/figures/handout.h"
#include "renderer/inspect/views.h"
#include "renderer/study/pitfalls/pages.h"
#include "tests/test_paths.h"

namespace gbl {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(test::source_folder() / path);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Documents, EveryTableIsWhatTheProgramPrints) {
  std::set<std::string> written;
  for (const DocsPage& page : docs_pages()) {
    const std::string name = std::string(page.list) + ".md";
    EXPECT_EQ(text_of("docs/tables/" + name), docs_text(page)) << "run: gbufferlab list --docs docs/tables";
    written.insert(name);
  }
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() / "docs/tables"))
    EXPECT_TRUE(written.count(entry.path().filename().string())) << entry.path() << " belongs to no page";
}

TEST(Documents, CommandsNameViewsThatThereAre) {
  static const std::regex kOnly(R"(gbufferlab render[^\n]* --only ([a-z0-9,-]+))");
  std::vector<std::filesystem::path> pages = {"README.md"};
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() / "docs"))
    if (entry.path().extension() == ".md") pages.push_back("docs" / entry.path().filename());
  size_t named = 0;
  for (const std::filesystem::path& page : pages) {
    const std::string text = text_of(page);
    for (std::sregex_iterator m(text.begin(), text.end(), kOnly), end; m != end; ++m) {
      std::istringstream list((*m)[1].str());
      for (std::string id; std::getline(list, id, ','); ++named) EXPECT_NO_THROW(view_by_id(id)) << page << ": " << id;
    }
  }
  EXPECT_GT(named, 5u);
}

TEST(Documents, TheLectureIsPrintedFromItsLesson) {
  EXPECT_EQ(text_of("docs/lecture.md"), lecture_script(load_lesson("ten-minutes"), "ten-minutes"))
      << "run: gbufferlab handout ten-minutes --script -o docs, and rename it";
}

// Without what was measured: numbers, and where.
std::string words_of_page(const std::string& page) {
  static const std::regex kMeasured(R"(Measured at [^\n]*|[Bb]oth are judged by[^\n]*|not measured|up to \d+ codes)");
  static const std::regex kNumbers(R"(-?\d+(\.\d+)?(e[+-]\d+)?|inf)");
  return std::regex_replace(std::regex_replace(page, kMeasured, "#"), kNumbers, "#");
}

TEST(Documents, EveryPitfallHasItsPageAndItsPicture) {
  std::vector<JudgedPitfall> all;
  std::set<std::string> written = {"README.md"};
  for (const PitfallEntry& e : load_pitfalls()) {
    all.push_back({e, {.broken = 1, .fixed = 1, .blind = 1}});
    EXPECT_EQ(words_of_page(text_of("docs/pitfalls/" + e.id + ".md")),
              words_of_page(pitfall_page(all.back(), 0, {}, {}, "")))
        << "run: gbufferlab pitfalls -o docs/pitfalls";
    EXPECT_LE(std::filesystem::file_size(test::source_folder() / "docs/pitfalls" / (e.id + ".png")), 120'000u) << e.id;
    written.insert(e.id + ".md"), written.insert(e.id + ".png");
  }
  EXPECT_EQ(words_of_page(text_of("docs/pitfalls/README.md")), words_of_page(pitfall_index(all, {}, "")));
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() / "docs/pitfalls"))
    EXPECT_TRUE(written.count(entry.path().filename().string())) << entry.path() << " belongs to no pitfall";
}

// Relative links of a Markdown file: [words](path) and ![words](path).
TEST(Documents, EveryLinkLeadsToAFile) {
  static const std::regex kLink(R"(\]\(([^)#:]+)\))");
  std::vector<std::filesystem::path> files = {"README.md", "CHANGELOG.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source_folder() / "docs"))
    if (entry.path().extension() == ".md") files.push_back(std::filesystem::relative(entry, test::source_folder()));
  for (const std::filesystem::path& file : files) {
    const std::string text = text_of(file);
    for (auto link = std::sregex_iterator(text.begin(), text.end(), kLink); link != std::sregex_iterator(); ++link)
      EXPECT_TRUE(std::filesystem::exists(test::source_folder() / file.parent_path() / std::string((*link)[1])))
          << file << " links to " << (*link)[1];
  }
}

TEST(Documents, TheNewestChangeIsOfTheVersionThatTheProgramPrints) {
  const std::string changes = text_of("CHANGELOG.md");
  std::smatch newest;
  ASSERT_TRUE(std::regex_search(changes, newest, std::regex(R"(\n## (\d+\.\d+\.\d+) - \d{4}-\d\d-\d\d\n)")));
  const char* const words[] = {"gbufferlab", "--version"};
  EXPECT_EXIT(
      {
        dup2(STDERR_FILENO, STDOUT_FILENO);  // EXPECT_EXIT reads standard error only
        std::exit(run_program(2, words));
      },
      testing::ExitedWithCode(0), "gbufferlab " + std::string(newest[1]));
}

}  // namespace
}  // namespace gbl
