// `study`, `advise` and `bench` as programs: what stands in their files, what goes wrong and how they say it.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "tests/test_paths.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

namespace fs = std::filesystem;

class Program : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("gbl-study-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Runs the program; its output and errors are kept. -> exit code
  int run(const std::string& arguments, const std::string& before = "") {
    const std::string line = before + " \"" + test::program() + "\" " + arguments + " >\"" +
                             (folder_ / "out").string() + "\" 2>\"" + (folder_ / "err").string() + "\"";
    return WEXITSTATUS(std::system(line.c_str()));
  }
  std::string text(const char* file) const {
    std::ifstream in(folder_ / file);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
  }
  size_t lines(const char* file) const {
    const std::string all = text(file);
    return static_cast<size_t>(std::count(all.begin(), all.end(), '\n'));
  }
  // A spec of small frames: n light counts.
  std::string spec(int n, const std::string& more = "") {
    std::string counts;
    for (int i = 1; i <= n; ++i) counts += (i > 1 ? "," : "") + std::to_string(i);
    std::ofstream(folder_ / "spec.json")
        << R"({"version": 1, "name": "small", "label": "small", "base": {"scene": "builtin:layers", "size": "64x36"},)"
        << R"("permute": {"lights": [)" << counts << "]" << more << R"(}, "x": "bytes_per_pixel", "y": "rmse_linear",)"
        << R"("family": "layout"})";
    return "study \"" + (folder_ / "spec.json").string() + "\" -o \"" + folder_.string() + "\"";
  }
  fs::path folder_;
};

TEST_F(Program, AStudyWritesItsFilesAndGoesOnWhereItStopped) {
  EXPECT_EQ(run(spec(3) + " --shard 1/3"), 0) << text("err");
  EXPECT_EQ(lines("rows.jsonl"), 1u);
  EXPECT_EQ(run(spec(3)), 0) << text("err");
  EXPECT_EQ(lines("rows.jsonl"), 3u);
  EXPECT_TRUE(contains(text("out"), "2 rows measured, 1 found"));
  for (const char* file : {"study.csv", "study.json", "study.html"}) EXPECT_GT(text(file).size(), 100u) << file;
  const Json study = parse_json(text("study.json"), "study.json");
  ASSERT_EQ(study["rows"].size(), 3u);
  for (const Json& row : study["rows"]) {
    EXPECT_GT(row["compared_pixels"].get<double>(), 100) << "errors are measured";
    EXPECT_GT(row["frames"].get<int>(), 0) << "a time never stands without its error, nor an error without its time";
    EXPECT_TRUE(row["driver"].is_string());
    for (const char* ending : {".jpg", ".png"})
      EXPECT_TRUE(fs::exists(folder_ / "thumbs" / (row["key"].get<std::string>() + ending))) << "of either run";
  }
  EXPECT_FALSE(contains(text("study.html"), "no picture"));
}

// Nothing is lost but the row under way.
TEST_F(Program, AKilledStudyKeepsItsRows) {
  const std::string command = spec(60);
  const pid_t child = fork();
  if (child == 0) {
    const std::string line = "exec \"" + test::program() + "\" " + command + " >/dev/null 2>&1";
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(127);
  }
  for (int k = 0; k < 600 && lines("rows.jsonl") < 2; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  const size_t kept = lines("rows.jsonl");
  ASSERT_GE(kept, 2u);
  ASSERT_LT(kept, 60u);
  EXPECT_EQ(run(spec(static_cast<int>(kept) + 1)), 0) << text("err");
  EXPECT_TRUE(contains(text("out"), "1 rows measured")) << text("out");
}

TEST_F(Program, ARowThatFailsIsARowWithItsReasonAndTheStudyGoesOn) {
  std::ofstream(folder_ / "spec.json") << R"({"version": 1, "name": "small", "label": "small",
    "base": {"scene": "builtin:layers", "size": "64x36"},
    "permute": [{"lights.source": ["rig"], "lights.rig": ["nothere.json"]}, {"lights": [1, 2]}],
    "x": "bytes_per_pixel", "y": "rmse_linear", "family": "layout"})";
  const std::string command = "study \"" + (folder_ / "spec.json").string() + "\" -o \"" + folder_.string() + "\"";
  EXPECT_EQ(run(command), 1) << text("err");
  EXPECT_TRUE(contains(text("out"), "2 rows measured, 0 found, 1 failed")) << text("out");
  const Json study = parse_json(text("study.json"), "study.json");
  EXPECT_TRUE(contains(study["rows"][0]["failed"].get<std::string>(), "nothere.json"));
  EXPECT_FALSE(study["rows"][1].contains("failed"));
}

TEST_F(Program, BadSpecsAreRefusedInOneLine) {
  const auto refused = [&](const std::string& spec_text, const char* names) {
    std::ofstream(folder_ / "bad.json") << spec_text;
    EXPECT_EQ(run("study \"" + (folder_ / "bad.json").string() + "\" -o \"" + folder_.string() + "\""), 2);
    EXPECT_TRUE(contains(text("err"), names)) << text("err");
    EXPECT_TRUE(contains(text("err"), "bad.json")) << text("err");
    EXPECT_EQ(lines("err"), 1u) << text("err");
    EXPECT_FALSE(fs::exists(folder_ / "study.csv"));
  };
  refused("{", "bad.json");
  refused(R"({"name": "a", "label": "a", "permute": {"lights.metod": ["tiled"]}})", "lights.metod");
  refused(R"({"name": "a", "label": "a", "permute": {"lights": []}})", "lights");
  EXPECT_EQ(run("study nosuch"), 2);
  EXPECT_TRUE(contains(text("err"), "tradeoff")) << text("err");
  EXPECT_EQ(run(spec(1) + " --shard 3/2"), 2);
}

TEST_F(Program, WithoutGnuplotTheTablesAreWritten) {
  fs::create_directories(folder_ / "empty");
  EXPECT_EQ(run(spec(1), "PATH=\"" + (folder_ / "empty").string() + "\""), 4);
  EXPECT_TRUE(contains(text("err"), "gnuplot")) << text("err");
  EXPECT_GT(text("study.csv").size(), 100u);
  EXPECT_GT(text("study.json").size(), 100u);
}

TEST_F(Program, AdviceHoldsTheBudgetAndItsStateIsDrawable) {
  const std::string state = " -o \"" + folder_.string() + "\"";
  ASSERT_EQ(run("advise --scene builtin:layers --size 96x54 --budget 1 --cost bytes --json --apply" + state), 0)
      << text("err");
  const Json advice = parse_json(text("out"), "out");
  EXPECT_LE(advice["best"]["worst"]["share_over"].get<double>(), 0.001);
  EXPECT_LE(advice["best"]["cost"].get<double>(), advice["runner_up"]["cost"].get<double>());
  EXPECT_GT(advice["left_out"].size(), 3u);
  EXPECT_TRUE(contains(text("advice.html"), "<b>chosen:</b>"));
  const std::string file = (folder_ / "settings.json").string();
  EXPECT_EQ(run("render --state \"" + file + "\" --only final" + state), 0) << text("err");
  EXPECT_EQ(run("advise --budget 0"), 2);
  EXPECT_EQ(run("advise --budget 1 --budget-max 1"), 2);
  EXPECT_EQ(run("advise --cost money"), 2);
}

TEST_F(Program, AStudyOfAxesNeedsNoSpecStopsInTimeAndGoesOn) {
  const std::string command =
      "study --axes accumulation.targets,depth.format --scene builtin:layers --lights 4 --size 64x36 -o \"" +
      folder_.string() + "\"";
  EXPECT_EQ(run(command + " --budget 0.01s"), 0) << text("err");
  EXPECT_EQ(lines("rows.jsonl"), 1u) << "it stops between rows";
  EXPECT_TRUE(contains(text("out"), "the same command goes on")) << text("out");
  const Json first = parse_json(text("rows.jsonl"), "rows.jsonl");
  EXPECT_EQ(first["at"].size(), 1u) << "the values of an axis alone come first";
  EXPECT_EQ(run(command), 0) << text("err");
  EXPECT_TRUE(contains(text("out"), "1 found, 0 failed, 0 left")) << text("out");
  EXPECT_EQ(run("study --axes accumulation.target -o \"" + folder_.string() + "\""), 2);
  EXPECT_TRUE(contains(text("err"), "accumulation.targets")) << text("err");
  EXPECT_EQ(run("study tradeoff --axes layout"), 2);
  EXPECT_EQ(run(command + " --budget soon"), 2);
  EXPECT_EQ(run("study --axes layout --set layout=exact"), 2) << text("err");
}

TEST_F(Program, ShardsAreMergedIntoTheRowsOfASingleRun) {
  const auto in = [&](const char* name) { return "\"" + (folder_ / name).string() + "\""; };
  spec(4);
  const std::string study = "study " + in("spec.json");
  ASSERT_EQ(run(study + " -o " + in("single")), 0) << text("err");
  for (const char* i : {"1", "2"})
    ASSERT_EQ(run(study + " --shard " + i + "/2 -o " + in((std::string("shard") + i).c_str())), 0) << text("err");
  ASSERT_EQ(run("study --merge " + in("shard2") + " " + in("shard1") + " -o " + in("merged")), 0) << text("err");
  const auto cases = [&](const char* file) {
    std::vector<std::string> names;
    const Json study_json = parse_json(text(file), file);
    for (const Json& row : study_json["rows"]) names.push_back(row["case"]);
    return names;
  };
  EXPECT_EQ(cases("merged/study.json"), cases("single/study.json"));
  EXPECT_FALSE(contains(text("merged/study.html"), "no picture"));
  EXPECT_EQ(run("study " + in("merged/spec.json") + " -o " + in("merged")), 0) << "and it can be gone on with";
  EXPECT_TRUE(contains(text("out"), "0 rows measured, 4 found")) << text("out");

  ASSERT_EQ(run(study + " --set ambient=0.3 -o " + in("other")), 0) << text("err");
  EXPECT_EQ(run("study --merge " + in("shard1") + " " + in("other") + " -o " + in("never")), 2);
  EXPECT_TRUE(contains(text("err"), "other settings")) << text("err");
  EXPECT_FALSE(fs::exists(folder_ / "never")) << "nothing half-written";
  EXPECT_EQ(run("study --merge " + in("shard1")), 2) << "without -o";
  EXPECT_EQ(run("study quick --merge " + in("shard1") + " -o " + in("never")), 2);
}

TEST_F(Program, ASweepTakesASceneOfOnesOwn) {
  const std::string into = " -o \"" + folder_.string() + "\"";
  EXPECT_EQ(run("stability volume-level --scene builtin:layers --lights 4 --size 64x36" + into), 0) << text("err");
  EXPECT_TRUE(contains(text("out"), "--scene builtin:layers")) << text("out");
  EXPECT_GT(text("stability.html").size(), 1000u);
  EXPECT_EQ(run("stability near-corner --scene builtin:layers" + into), 2);
  EXPECT_TRUE(contains(text("err"), "near-corner")) << text("err");
  EXPECT_EQ(run("stability volume-level --set lights.volume.fit=inscribed" + into), 2);
  EXPECT_TRUE(contains(text("err"), "lights.volume.fit")) << text("err");
}

TEST_F(Program, ReferenceAndErrorAreViewsOnRequest) {
  const std::string into = " --size 96x54 -o \"" + folder_.string() + "\"";
  EXPECT_EQ(run("render --only reference,error,final" + into), 0) << text("err");
  for (const char* file : {"reference.png", "error.png", "final.png"}) EXPECT_TRUE(fs::exists(folder_ / file)) << file;
  fs::remove(folder_ / "reference.png");
  EXPECT_EQ(run("render" + into), 0) << text("err");
  EXPECT_FALSE(fs::exists(folder_ / "reference.png")) << "it takes a second or more: only when it is asked for";
  EXPECT_EQ(run("render --only error --set view.error.of=albedo --set lights.method=forward" + into), 2);
}

}  // namespace
}  // namespace gbl::test
