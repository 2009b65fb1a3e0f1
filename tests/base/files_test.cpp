// Files are read with a bound and written whole or not at all.
#include "renderer/base/files.h"

#include <fstream>
#include <gtest/gtest.h>
#include <thread>

#include "renderer/base/error.h"
#include "tests/test_paths.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

class TextFiles : public ::testing::Test {
 protected:
  TextFiles()
      : folder_(test::build_folder() / "files" / ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder_);
    make_folder(folder_);
  }
  ~TextFiles() override { fs::remove_all(folder_); }
  size_t count() const { return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), {})); }
  fs::path folder_;
};

std::string refused(const fs::path& path, size_t most = kMostTextBytes) {
  try {
    read_text_file(path, most);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    return e.what();
  }
  return "accepted";
}

TEST_F(TextFiles, WhatIsWrittenIsRead) {
  const std::string text("one\r\ntwo\0three", 14);  // a zero byte and line ends stay as they are
  write_text_file(folder_ / "a.txt", text);
  EXPECT_EQ(read_text_file(folder_ / "a.txt"), text);
  EXPECT_EQ(count(), 1u) << "a temporary file stayed";
}

TEST_F(TextFiles, EndlessEmptyAndMissingOnesAreRefusedByName) {
  EXPECT_NE(refused("/dev/zero", 1 << 20).find("/dev/zero: is longer than 1 MiB"), std::string::npos);
  EXPECT_NE(refused("/dev/null").find("is empty"), std::string::npos);
  EXPECT_NE(refused(folder_ / "nothere").find("No such file"), std::string::npos);
  EXPECT_NE(refused(folder_).find("cannot be read"), std::string::npos);
  std::ofstream(folder_ / "limit") << "12345678";
  EXPECT_EQ(read_text_file(folder_ / "limit", 8), "12345678");
  EXPECT_NE(refused(folder_ / "limit", 7).find("longer"), std::string::npos);
}

TEST_F(TextFiles, ManyWritersOfOneFileLeaveOneOfTheirTexts) {
  const fs::path file = folder_ / "shared.txt";
  std::vector<std::thread> writers;
  for (char c = 'a'; c < 'i'; ++c)
    writers.emplace_back([&, c] {
      for (int n = 0; n < 20; ++n) write_text_file(file, std::string(10000, c));
    });
  for (std::thread& t : writers) t.join();
  const std::string text = read_text_file(file);
  EXPECT_EQ(text, std::string(10000, text[0]));
  EXPECT_EQ(count(), 1u);
}

TEST_F(TextFiles, AFailedWriteKeepsTheOldFile) {
  const fs::path file = folder_ / "kept.txt";
  write_text_file(file, "old");
  EXPECT_THROW(write_file(file, [](std::FILE*) { throw Error(ExitCode::unfinished, "x", "y"); }), Error);
  try {
    write_file(file, [](std::FILE*) { throw std::runtime_error("a library's complaint"); });
    FAIL() << "written";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::unfinished);
    EXPECT_NE(std::string(e.what()).find("kept.txt: cannot be written: a library's complaint"), std::string::npos);
  }
  EXPECT_EQ(read_text_file(file), "old");
  EXPECT_EQ(count(), 1u);
  EXPECT_THROW(write_text_file(folder_ / "no" / "folder.txt", "text"), Error);
}

TEST(Errors, AreOneLineThatATerminalShows) {
  const std::string what = Error(ExitCode::bad_input, "a\xff\nb", "c\x1b[31m é \xc3", "d").what();
  EXPECT_EQ(what, "a? b: c [31m é ?; d");
  const std::string cut = Error(ExitCode::bad_input, "file", std::string(5000, '9')).what();
  EXPECT_LT(cut.size(), 320u);
  EXPECT_TRUE(cut.ends_with("…"));
  EXPECT_EQ(printable("ééé", 4), "éé…") << "no character is cut in two";
}

}  // namespace
}  // namespace gbl
