// Files are read with a bound and written whole or not at all.
#include "renderer/base/files.h"

#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "renderer/base/error.h"
#include "tests/test_paths.h"
#include "tests/test_support.h"

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

// A pipe that nobody writes into is no reason to wait for ever; one that somebody does is a file like others.
TEST_F(TextFiles, APipeIsWaitedForAWhile) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string said = error_line(ExitCode::bad_input, [&] { read_text_file(pipe); });
  EXPECT_NE(said.find("pipe"), std::string::npos) << said;
  std::thread writer([&] { std::ofstream(pipe) << std::string(300'000, 'x'); });
  EXPECT_EQ(read_text_file(pipe).size(), 300'000u);
  writer.join();
  EXPECT_NE(error_line(ExitCode::bad_input, [&] { require_regular(pipe); }).find("is no file"), std::string::npos);
  EXPECT_NE(error_line(ExitCode::bad_input, [&] { require_regular(folder_); }).find("folder"), std::string::npos);
  EXPECT_NO_THROW(require_regular(folder_ / "missing")) << "who opens it says so";
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

// In a process of its own, which stays in the middle of it; back when it is there.
pid_t begin_to_write(const fs::path& file) {
  int begun[2] = {};
  if (::pipe(begun) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    write_file(file, [&](std::FILE* f) {
      std::fputs("half", f);
      std::fflush(f);
      static_cast<void>(::write(begun[1], "!", 1) + 0);
      while (true) ::pause();
    });
  }
  char there = 0;
  EXPECT_EQ(::read(begun[0], &there, 1), 1);
  ::close(begun[0]), ::close(begun[1]);
  return child;
}

void kill_it(pid_t child) {
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

int another_program_writes(const fs::path& file) {
  const pid_t child = ::fork();
  if (child == 0) {
    write_text_file(file, "whole");
    ::_exit(0);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  return status;
}

TEST_F(TextFiles, AKilledWriterKeepsTheOldFileAndTheNextOneClearsWhatItLeft) {
  std::ofstream(folder_ / "a.txt") << "old";  // this process has not written there yet: what it forks is like new
  std::ofstream(folder_ / "a.txt.backup") << "of the user";
  const pid_t killed = begin_to_write(folder_ / "a.txt"), works = begin_to_write(folder_ / "b.txt");
  kill_it(killed);
  EXPECT_EQ(read_text_file(folder_ / "a.txt"), "old");
  EXPECT_EQ(count(), 4u) << "what it left, and what another one writes now";
  EXPECT_EQ(another_program_writes(folder_ / "c.txt"), 0);
  EXPECT_EQ(count(), 4u) << "the first is gone, c.txt is there, and who writes now was left alone";
  kill_it(works);
  EXPECT_EQ(another_program_writes(folder_ / "c.txt"), 0);
  EXPECT_EQ(count(), 3u);
  EXPECT_EQ(read_text_file(folder_ / "a.txt.backup"), "of the user");
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
