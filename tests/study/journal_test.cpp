#include "renderer/study/journal.h"

#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

#include "renderer/options/presets.h"
#include "renderer/study/row_json.h"
#include "tests/disk_room.h"
#include "tests/study/study_rows.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}
void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

StudyRow good(const char* key, int n = 0) {
  StudyRow row = test::row_of(key, {});
  test::put(row, "frames", n);
  return row;
}
StudyRow bad(const char* key, const char* why) { return test::failed_row_of(key, why); }
std::string line(const StudyRow& row) { return journal_line(row); }

TEST(RowKey, IsOfTheSettingsAndNotOfTheView) {
  Settings a = preset("start").make(), b = a;
  EXPECT_TRUE(std::regex_match(row_key(a), std::regex("[0-9a-f]{16}"))) << row_key(a);
  b.view.main = "normal", b.view.pick = 3;
  EXPECT_EQ(row_key(a), row_key(b));
  b.lights.seed = 2;
  EXPECT_NE(row_key(a), row_key(b));
}

TEST(Journal, KeepsRowsAndKnowsThemAgain) {
  const TemporaryFolder folder("journal");
  const fs::path path = folder / "rows.jsonl";
  {
    Journal journal(path);
    EXPECT_TRUE(journal.rows().empty());
    journal.append(good("a", 1));
    EXPECT_TRUE(journal.has("a"));
    EXPECT_EQ(text_of(path), line(good("a", 1))) << "on the disk at once";
    journal.append(good("b", 2));
  }
  Journal again(path);
  EXPECT_TRUE(again.has("a"));
  EXPECT_TRUE(again.has("b"));
  EXPECT_FALSE(again.has("c"));
  EXPECT_TRUE(again.rows() == (std::vector<StudyRow>{good("a", 1), good("b", 2)}));
}

// A number of another version, or of other shaders, is another measurement.
TEST(Journal, WhatAnotherProgramMeasuredIsMeasuredAgain) {
  const TemporaryFolder folder("journal-version");
  const fs::path path = folder / "rows.jsonl";
  StudyRow old = good("a", 1), ours = good("a", 2);
  old.made_by = "0.1.0 0123456789abcdef", ours.made_by = "0.9.0 0123456789abcdef";
  write(path, line(old) + line(good("b")));
  {
    Journal journal(path, ours.made_by);
    EXPECT_FALSE(journal.has("a"));
    EXPECT_FALSE(journal.has("b")) << "a program that did not say who it was";
    EXPECT_TRUE(journal.rows().at(0) == old) << "it is shown until it is measured again";
    journal.append(ours);
    EXPECT_TRUE(journal.has("a"));
  }
  Journal again(path, ours.made_by);
  EXPECT_TRUE(again.has("a"));
  EXPECT_TRUE(again.rows().at(0) == ours);
}

TEST(Journal, AFileThatIsDeletedUnderTheStudyIsAnError) {
  const TemporaryFolder folder("journal-deleted");
  const fs::path path = folder / "rows.jsonl";
  Journal journal(path);
  journal.append(good("a"));
  fs::remove(path);
  EXPECT_TRUE(contains(error_line(ExitCode::unfinished, [&] { journal.append(good("b")); }), "deleted or replaced"));
  write(path, "");  // another file of that name is not the study's
  EXPECT_TRUE(contains(error_line(ExitCode::unfinished, [&] { journal.append(good("b")); }), "deleted or replaced"));
}

TEST(Journal, ATornLastLineIsDropped) {
  const TemporaryFolder folder("journal-torn");
  const fs::path path = folder / "rows.jsonl";
  // Cut short, whole but for its end of line, and what a crash leaves of a block.
  for (const std::string& torn :
       {std::string(R"({"key": "b", "n)"), line(good("b")).substr(0, line(good("b")).size() - 1),
        std::string(20, '\0') + "\n", std::string("{\"no\": \"key\"}\n"), std::string("\n")}) {
    write(path, line(good("a")) + torn);
    Journal journal(path);
    EXPECT_EQ(text_of(path), line(good("a"))) << torn;
    EXPECT_FALSE(journal.has("b"));
    journal.append(good("b"));
    EXPECT_EQ(text_of(path), line(good("a")) + line(good("b")));
  }
  write(path, "{\"key\"");
  EXPECT_TRUE(Journal(path).rows().empty());
  EXPECT_EQ(text_of(path), "");
}

TEST(Journal, ABadLineElsewhereIsNamed) {
  const TemporaryFolder folder("journal-bad");
  const fs::path path = folder / "rows.jsonl";
  for (const std::string middle : {"{\"key\": \"b\", \"n\n", "[1]\n", "\n", "{\"key\": 5}\n"}) {
    write(path, line(good("a")) + middle + line(good("c")));
    const std::string message = error_line(ExitCode::bad_input, [&] { Journal journal(path); });
    EXPECT_TRUE(contains(message, "rows.jsonl:2: ")) << message;
    EXPECT_EQ(text_of(path), line(good("a")) + middle + line(good("c"))) << "untouched";
  }
}

TEST(Journal, OfConcatenatedFilesTheFirstRowOfAKeyWins) {
  const TemporaryFolder folder("journal-two");
  const fs::path path = folder / "rows.jsonl";
  write(path, line(good("a", 1)) + line(good("b", 1)) + line(good("b", 2)) + line(good("c", 2)) + line(bad("a", "no")));
  EXPECT_TRUE(Journal(path).rows() == (std::vector<StudyRow>{good("a", 1), good("b", 1), good("c", 2)}));
}

TEST(Journal, WhatFailedIsTriedAgainAndTheNewerRowCounts) {
  const TemporaryFolder folder("journal-failed");
  const fs::path path = folder / "rows.jsonl";
  {
    Journal journal(path);
    journal.append(bad("a", "first"));
    EXPECT_FALSE(journal.has("a"));
    journal.append(bad("a", "second"));
    journal.append(good("b"));
    EXPECT_TRUE(journal.rows() == (std::vector<StudyRow>{bad("a", "second"), good("b")}));
    journal.append(good("a"));
    EXPECT_TRUE(journal.has("a"));
  }
  EXPECT_TRUE(Journal(path).rows() == (std::vector<StudyRow>{good("a"), good("b")}));
}

// The write is cut short, the next one refused.
TEST(Journal, OnAFullDiskNothingHalfWrittenIsKept) {
  const TemporaryFolder folder("journal-full");
  const fs::path path = folder / "rows.jsonl";
  Journal journal(path);
  journal.append(good("a"));
  for (const size_t left : {5, 0}) {
    const DiskRoom room(line(good("a")).size() + left);
    const std::string message = error_line(ExitCode::unfinished, [&] { journal.append(good("b")); });
    EXPECT_TRUE(contains(message, "rows.jsonl: cannot be written")) << message;
    EXPECT_EQ(text_of(path), line(good("a")));
    EXPECT_FALSE(journal.has("b"));
  }
  journal.append(good("b"));
  EXPECT_EQ(text_of(path), line(good("a")) + line(good("b")));
}

TEST(Journal, RefusesWhatItCannotKeepRowsIn) {
  const TemporaryFolder folder("journal-odd");
  error_line(ExitCode::unfinished, [&] { Journal journal(folder / "no-such-folder/rows.jsonl"); });
  error_line(ExitCode::unfinished, [&] { Journal journal(folder.path()); });
  const std::string device = error_line(ExitCode::bad_input, [&] { Journal journal("/dev/full"); });
  EXPECT_TRUE(contains(device, "is not a file")) << device;
  Journal first(folder / "rows.jsonl");
  const std::string second = error_line(ExitCode::unfinished, [&] { Journal journal(folder / "rows.jsonl"); });
  EXPECT_TRUE(contains(second, "another study writes to it")) << second;
}

TEST(Journal, TextThatIsNotUtf8DoesNotStopAStudy) {
  const TemporaryFolder folder("journal-utf8");
  Journal journal(folder / "rows.jsonl");
  journal.append(bad("a", "bad byte \xff"));
  EXPECT_EQ(journal.rows().size(), 1u);
}

}  // namespace
}  // namespace gbl
