#pragma once
// A command is killed at random moments: what stands in its folder then, and what the next run makes of it.
#include "renderer/base/random.h"
#include "tests/faults/child.h"
#include "tests/faults/quick_commands.h"
#include "tests/faults/whole_files.h"
#include "tests/test_support.h"

namespace gbl::test {

// What stands in a file and does not depend on how long anything took.
inline std::string without_times(const std::string& name, const std::string& text) {
  const bool has_times = name.starts_with("study.") || name == "rows.jsonl";
  if (has_times && name != "study.json") return "";  // which has all that they have
  if (!has_times) return text;
  Json study = Json::parse(text);
  for (Json& row : study["rows"])
    for (auto it = row.begin(); it != row.end();)
      it = it.key().starts_with("time_ms_") || it.key() == "frames" ? row.erase(it) : std::next(it);
  return study.dump();
}

class Killing {
 public:
  Killing(const QuickCommand& command, uint64_t seed) : command_(command), random_(seed) {
    const auto begun = std::chrono::steady_clock::now();
    const Ended ended = run(clean());
    took_ = std::chrono::steady_clock::now() - begun;
    EXPECT_EQ(ended.code, 0) << ended.said;
    result_ = files_in(clean());
    EXPECT_EQ(not_whole(clean()), "");
  }

  // Over files of an earlier run, all but its journal: each of them stays, or is replaced by a whole one.
  void over_an_older_run(int times) {
    for (int k = 0; k < times; ++k) {
      for (const auto& [name, text] : result_)
        if (name.ends_with(".jsonl")) std::filesystem::remove(clean() / name);
      kill_once(clean());
      EXPECT_EQ(not_whole(clean()), "") << command_.name;
      for (const auto& [name, text] : result_)
        EXPECT_TRUE(name.ends_with(".jsonl") || std::filesystem::exists(clean() / name)) << name;
    }
    EXPECT_EQ(run(clean()).code, 0);
    expect_clear(clean());
  }

  // Into a new folder, where it goes on after each time; then to its end.
  void in_a_new_folder(int times) {
    const std::filesystem::path fresh = folder_ / "fresh";
    for (int k = 0; k < times; ++k) {
      kill_once(fresh);
      EXPECT_EQ(not_whole(fresh), "") << command_.name;
    }
    const Ended ended = run(fresh);
    EXPECT_EQ(ended.code, 0) << ended.said;
    expect_clear(fresh);
    const auto files = files_in(fresh);
    EXPECT_EQ(files.size(), result_.size());
    for (const auto& [name, text] : result_) {
      ASSERT_TRUE(files.contains(name)) << name;
      EXPECT_TRUE(without_times(name, files.at(name)) == without_times(name, text)) << name << " differs";
    }
  }

 private:
  std::filesystem::path clean() const { return folder_ / "clean"; }
  Ended run(const std::filesystem::path& into) const { return Child(command_.into(into), folder_ / "state").wait(); }
  void kill_once(const std::filesystem::path& into) {
    Child child(command_.into(into), folder_ / "state");
    std::this_thread::sleep_for(took_ * random_.unit());
    child.kill();
    child.wait();
  }
  void expect_clear(const std::filesystem::path& into) const {
    EXPECT_EQ(temporaries(files_in(into)), "") << command_.name;
    EXPECT_EQ(not_whole(into), "") << command_.name;
  }

  TemporaryFolder folder_{"killing"};
  const QuickCommand& command_;
  Pcg32 random_;
  std::chrono::duration<double> took_{};
  std::map<std::string, std::string> result_;
};

}  // namespace gbl::test
