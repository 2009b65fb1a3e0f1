// Folders that cannot be made, that go while a command runs, and that two commands write to.
#include "tests/faults/child.h"
#include "tests/faults/quick_commands.h"
#include "tests/faults/whole_files.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

namespace fs = std::filesystem;

class Folders : public testing::Test {
 protected:
  // Perhaps a temporary one, which is gone when it is looked at.
  static bool holds_a_file(const fs::path& into) {
    std::error_code none;
    return fs::directory_iterator(into, none) != fs::directory_iterator();
  }
  static size_t lines_in(const fs::path& file) {
    std::error_code none;
    const std::string text = fs::file_size(file, none) > 0 && !none ? read_text_file(file) : "";
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  TemporaryFolder folder_{"folders"};
  const fs::path state_ = folder_ / "state";
  const std::vector<QuickCommand> commands_ = quick_commands(folder_.path());
};

// Nothing can be made below a file, whoever runs the test.
TEST_F(Folders, OneThatCannotBeMadeIsNamed) {
  write_text_file(folder_ / "file", "no folder\n");
  for (const QuickCommand& command : commands_) {
    const fs::path into = folder_ / "file" / "below";
    const Ended ended = Child(command.into(into), state_).wait();
    EXPECT_EQ(ended.code, 4) << ended.said;
    EXPECT_TRUE(contains(complaint(ended.said), into.string() + ": cannot be written")) << ended.said;
  }
}

TEST_F(Folders, OneThatIsRemovedWhileACommandWritesToItIsSaid) {
  for (const QuickCommand& command : commands_) {
    if (command.name != "study" && command.name != "stability" && command.name != "render") continue;
    SCOPED_TRACE(command.name);
    const fs::path into = folder_ / command.name;
    Child child(command.into(into), state_);
    std::error_code again;  // a file was made meanwhile
    ASSERT_TRUE(becomes([&] { return command.journal ? lines_in(into / command.journal) > 0 : holds_a_file(into); }));
    ASSERT_TRUE(becomes([&] { return fs::remove_all(into, again), !fs::exists(into); }));
    const Ended ended = child.wait();
    EXPECT_EQ(ended.code, 4) << ended.said;
    EXPECT_TRUE(contains(complaint(ended.said), into.string())) << ended.said;
    EXPECT_EQ(not_whole(into), "");
    EXPECT_EQ(temporaries(files_in(into)), "");
  }
}

TEST_F(Folders, OfTwoThatMeasureIntoOneTheSecondIsRefused) {
  for (const QuickCommand& command : commands_) {
    if (!command.journal) continue;
    SCOPED_TRACE(command.name);
    const fs::path into = folder_ / command.name;
    Child first(command.into(into), state_);
    ASSERT_TRUE(becomes([&] { return lines_in(into / command.journal) > 0; }));
    const Ended second = Child(command.into(into), state_).wait();
    EXPECT_EQ(second.code, 4) << second.said;
    EXPECT_TRUE(contains(complaint(second.said), "another study writes to it")) << second.said;
    const Ended ended = first.wait();
    EXPECT_EQ(ended.code, 0) << ended.said;
    EXPECT_EQ(not_whole(into), "");
  }
}

TEST_F(Folders, OfTwoThatDrawIntoOneBothEndWell) {
  for (const QuickCommand& command : commands_) {
    if (command.name != "render") continue;
    const fs::path into = folder_ / "shared";
    Child one(command.into(into), state_), other(command.into(into), state_);
    for (Child* child : {&one, &other}) {
      const Ended ended = child->wait();
      EXPECT_EQ(ended.code, 0) << ended.said;
    }
    EXPECT_EQ(not_whole(into), "");
    EXPECT_EQ(temporaries(files_in(into)), "");
  }
}

}  // namespace
}  // namespace gbl::test
