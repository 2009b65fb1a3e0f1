// Each file that a command writes, in turn the one that cannot be written.
#include <set>

#include "tests/faults/child.h"
#include "tests/faults/quick_commands.h"
#include "tests/faults/whole_files.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

namespace fs = std::filesystem;

class EachFile : public testing::Test {
 protected:
  Ended run(const std::vector<std::string>& words, const Room& room = {}) const {
    return Child(words, folder_ / "state", room).wait();
  }
  std::map<std::string, std::string> made_by(const QuickCommand& command) const {
    const fs::path clean = folder_ / "clean" / command.name;
    const Ended ended = run(command.into(clean));
    EXPECT_EQ(ended.code, 0) << ended.said;
    EXPECT_EQ(not_whole(clean), "");
    return files_in(clean);
  }
  TemporaryFolder folder_{"each-file"};
};

// Some have their times in them: a tenth less is less in every run.
TEST_F(EachFile, IsCutShortByAFullDisk) {
  for (const QuickCommand& command : quick_commands(folder_.path())) {
    std::set<size_t> sizes;
    const auto files = made_by(command);
    for (const auto& [name, text] : files) sizes.insert(text.size() - text.size() / 10 - 1);
    for (const size_t most : sizes) {
      SCOPED_TRACE(testing::Message() << command.name << ", at most " << most << " bytes");
      const fs::path clean = folder_ / "clean" / command.name, into = folder_ / "into";
      fs::remove_all(into);
      fs::copy(clean, into, fs::copy_options::recursive);
      for (const auto& [name, text] : files)
        if (name.ends_with(".jsonl")) fs::remove(into / name);
      const Ended ended = run(command.into(into), {.file_bytes = most});
      EXPECT_EQ(ended.code, 4) << ended.said;
      const std::string line = complaint(ended.said);
      EXPECT_TRUE(contains(line, into.string()) || contains(line, "gnuplot") || contains(line, "convert"))
          << ended.said;
      EXPECT_EQ(not_whole(into), "");
      EXPECT_EQ(temporaries(files_in(into)), "");
      for (const auto& [name, text] : files)
        EXPECT_TRUE(name.ends_with(".jsonl") || fs::exists(into / name)) << name << " is gone";
    }
  }
}

// A folder of its name stands in its place, and cannot be replaced.
TEST_F(EachFile, IsNamedWhereItCannotBeReplaced) {
  for (const QuickCommand& command : quick_commands(folder_.path()))
    for (const auto& [name, text] : made_by(command)) {
      if (name.ends_with(".glsl")) continue;  // an answer that was begun stays
      SCOPED_TRACE(command.name + ": " + name);
      const fs::path into = folder_ / "into";
      fs::remove_all(into);
      fs::create_directories(into / name / "occupied");
      const Ended ended = run(command.into(into));
      EXPECT_EQ(ended.code, name == "captions.json" ? 2 : 4) << ended.said;  // it is read first
      EXPECT_TRUE(contains(complaint(ended.said), (into / name).string())) << ended.said;
      EXPECT_EQ(not_whole(into), "");
      EXPECT_EQ(temporaries(files_in(into)), "");
    }
}

}  // namespace
}  // namespace gbl::test
