#include "renderer/study/study_merge.h"

#include <fstream>
#include <gtest/gtest.h>

#include "renderer/base/made_by.h"
#include "renderer/study/journal.h"
#include "renderer/study/page/thumbnails.h"
#include "tests/study/study_rows.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

StudySpec spec_called(const std::string& name, int lights = 4) {
  return parse_study(R"({"name": ")" + name + R"(", "base": {"lights": )" + std::to_string(lights) + "}}", "t.json");
}

StudyRow row(const char* key, double draw_calls, const std::string& by = made_by()) {
  StudyRow r = test::row_of(key, {{"draw_calls", draw_calls}});
  r.made_by = by;
  return r;
}

// age_s: how long ago its journal was written.
fs::path folder_with(const TemporaryFolder& root, const char* name, const std::vector<StudyRow>& rows, int age_s) {
  fs::path folder = root / name;
  fs::create_directories(folder);
  write_spec(folder, spec_called("s"));
  {
    Journal journal(folder / "rows.jsonl");
    for (const StudyRow& r : rows) journal.append(r);
  }
  fs::last_write_time(folder / "rows.jsonl", fs::file_time_type::clock::now() - std::chrono::seconds(age_s));
  return folder;
}

double draw_calls_of(const MergedRows& merged, std::string_view key) {
  for (const StudyRow& r : merged.rows)
    if (r.key == key) return r.number("draw_calls").value_or(-1);
  return -2;
}

TEST(MergedRows, HaveEachKeyOnceAndTheNewestWins) {
  const TemporaryFolder root("merge");
  const fs::path old = folder_with(root, "old", {row("a", 1), row("b", 2)}, 100);
  const fs::path newer = folder_with(root, "new", {row("b", 20), row("c", 30)}, 10);
  for (const std::vector<fs::path>& order : {std::vector{old, newer}, std::vector{newer, old}}) {
    const MergedRows merged = merged_rows(order);
    EXPECT_EQ(merged.rows.size(), 3u);
    EXPECT_EQ(draw_calls_of(merged, "a"), 1);
    EXPECT_EQ(draw_calls_of(merged, "b"), 20) << "whatever the order on the line";
  }
}

TEST(MergedRows, WhatWasMeasuredGoesBeforeWhatFailedAndOursBeforeAnothers) {
  const TemporaryFolder root("merge-failed");
  StudyRow failed = test::failed_row_of("a", "no memory");
  failed.made_by = made_by();
  const fs::path old = folder_with(root, "old", {row("a", 1), row("b", 2)}, 100);
  const fs::path newer = folder_with(root, "new", {failed, row("b", 20, "another program")}, 10);
  const MergedRows merged = merged_rows({old, newer});
  EXPECT_EQ(draw_calls_of(merged, "a"), 1);
  EXPECT_EQ(draw_calls_of(merged, "b"), 2);
}

TEST(MergedRows, AShardThatWasKilledGivesItsWholeRows) {
  const TemporaryFolder root("merge-torn");
  const fs::path torn = folder_with(root, "torn", {row("a", 1)}, 1), none = root / "none";
  std::ofstream(torn / "rows.jsonl", std::ios::app) << R"({"study": "s", "ca)";
  fs::create_directories(none);
  write_spec(none, spec_called("s"));
  EXPECT_EQ(merged_rows({torn, none}).rows.size(), 1u);
}

TEST(MergedRows, OtherStudiesAreRefusedInOneLine) {
  const TemporaryFolder root("merge-other");
  const fs::path first = folder_with(root, "first", {row("a", 1)}, 1),
                 other = folder_with(root, "other", {row("b", 1)}, 1);
  const auto refused = [&] { return error_line(ExitCode::bad_input, [&] { merged_rows({first, other}); }); };
  write_spec(other, spec_called("another"));
  EXPECT_TRUE(contains(refused(), "holds the study 'another'"));
  write_spec(other, spec_called("s", 5));
  EXPECT_TRUE(contains(refused(), "other settings"));
  fs::remove(other / "spec.json");
  EXPECT_TRUE(contains(refused(), "no spec.json"));
}

TEST(MergeThumbnails, TakesThemFromTheFolderThatHasThem) {
  const TemporaryFolder root("merge-thumbs");
  const Thumbnails t{"\xff\xd8\xff picture", "\x89PNG map"};
  write_thumbnails(root / "b", "key", t);
  merge_thumbnails({root / "a", root / "b"}, root / "into", {row("key", 1), row("none", 1)});
  EXPECT_EQ(read_thumbnails(root / "into", "key").picture, t.picture);
  EXPECT_EQ(read_thumbnails(root / "into", "none").picture, "");
}

}  // namespace
}  // namespace gbl
