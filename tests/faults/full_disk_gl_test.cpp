// No room where files are written, by a limit on their size; every file for itself in full_disk_slow_test.cpp.
#include "tests/faults/child.h"
#include "tests/faults/quick_commands.h"
#include "tests/faults/whole_files.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

namespace fs = std::filesystem;

class FullDisk : public testing::Test {
 protected:
  Ended run(const std::vector<std::string>& words, const Room& room) const {
    return Child(words, folder_ / "state", room).wait();
  }
  // Could not finish, in one line that names one of these.
  static void expect_said(const Ended& ended, std::initializer_list<std::string> names) {
    EXPECT_EQ(ended.code, 4) << "signal " << ended.signal << "; " << ended.said;
    const std::string line = complaint(ended.said);
    EXPECT_TRUE(std::any_of(names.begin(), names.end(), [&](const std::string& n) { return contains(line, n); }))
        << ended.said;
  }
  TemporaryFolder folder_{"full-disk"};
};

TEST_F(FullDisk, OldFilesStayWholeAndOneLineSaysWhichCannotBeWritten) {
  for (const QuickCommand& command : quick_commands(folder_.path())) {
    SCOPED_TRACE(command.name);
    const fs::path into = folder_ / command.name;
    write_text_file((make_folder(into), into / "old.json"), "{}\n");
    expect_said(run(command.into(into), {.file_bytes = command.name == "render" ? 3000 : 0}), {into.string()});
    EXPECT_EQ(not_whole(into), "");
    EXPECT_EQ(temporaries(files_in(into)), "");
  }
}

TEST_F(FullDisk, AReportStaysAsItWas) {
  const std::string file = (folder_ / "report.json").string();
  write_text_file(file, "{}\n");
  for (const rlim_t most : {0, 1000}) {
    expect_said(run({"info", "--report", file}, {.file_bytes = most}), {file});
    EXPECT_EQ(read_text_file(file), "{}\n");
    EXPECT_EQ(files_in(folder_.path()).size(), 1u);
  }
}

TEST_F(FullDisk, WhatIsPrintedDoesNotArriveUnnoticed) {
  fs::create_directories(folder_ / "class/ann");
  write_text_file(folder_ / "class/ann/missing-factor.json", "{}\n");
  const std::vector<std::vector<std::string>> printing = {
      {"exercise", "--grade", (folder_ / "class").string(), "--csv"}, {"list", "keys"}, {"info", "--json"}};
  for (const std::vector<std::string>& words : printing)
    expect_said(run(words, {.output = "/dev/full"}), {"standard output: cannot be written"});
}

}  // namespace
}  // namespace gbl::test
