// `exercise` as a student and a lecturer use it: the program itself, its exit codes and its words.
#include <fmt/format.h>
#include <fstream>
#include <sys/wait.h>

#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/gbuffer/layout_file.h"
#include "renderer/options/settings_json.h"
#include "tests/gl_fixture.h"
#include "tests/test_paths.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

namespace fs = std::filesystem;

struct Ran {
  int exit_code;
  std::string out;  // and what went to standard error
};
Ran run(const std::string& words) {
  std::FILE* pipe = popen(fmt::format("'{}' {} 2>&1", program(), words).c_str(), "r");
  Ran ran{-1, ""};
  char block[4096];
  while (const size_t got = std::fread(block, 1, sizeof block, pipe)) ran.out.append(block, got);
  ran.exit_code = WEXITSTATUS(pclose(pipe));
  return ran;
}

fs::path answers() { return source_folder() / "tests/exercises/answers"; }

class ExerciseCommand : public ::testing::Test {
 protected:
  TemporaryFolder folder{"exercise"};
  std::string file(const std::string& name, const std::string& text) {
    make_folder((folder / name).parent_path());
    write_text_file(folder / name, text);
    return (folder / name).string();
  }
};

TEST_F(ExerciseCommand, RightIsZeroWrongIsOneAndNoAnswerIsTwo) {
  const auto check = [](const char* exercise, const std::string& answer) {
    return run(fmt::format("exercise {} --check '{}'", exercise, answer));
  };
  const Ran right = check("octahedral-decode", (answers() / "octahedral-decode/right.glsl").string());
  EXPECT_EQ(right.exit_code, 0) << right.out;
  EXPECT_TRUE(contains(right.out, "octahedral-decode: right")) << right.out;
  const Ran wrong = check("octahedral-decode", (answers() / "octahedral-decode/wrong1.glsl").string());
  EXPECT_EQ(wrong.exit_code, 1) << wrong.out;
  EXPECT_TRUE(contains(wrong.out, "off by") && contains(wrong.out, "hint: ")) << wrong.out;
  const std::string broken = file("broken.json", "{\n  \"answer\": }\n");
  const Ran none = check("quad-space", broken);
  EXPECT_EQ(none.exit_code, 2) << none.out;
  EXPECT_TRUE(contains(none.out, broken + ":2:13: not valid JSON")) << none.out;
  const Ran unknown = run("exercise quad-spase");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(contains(unknown.out, "did you mean 'quad-space'")) << unknown.out;
  EXPECT_EQ(run("exercise --check x.json").exit_code, 2) << "of which exercise?";
}

TEST_F(ExerciseCommand, CompileErrorsHaveTheStudentsLine) {
  const std::string mine = file("mine.glsl", "// one\nvec3 decode_octahedral(vec2 p) {\n  return p;\n}\n");
  const Ran ran = run(fmt::format("exercise octahedral-decode --check '{}'", mine));
  EXPECT_EQ(ran.exit_code, 2) << ran.out;
  EXPECT_TRUE(contains(ran.out, mine + ":3: ")) << ran.out;
}

TEST_F(ExerciseCommand, AnAnswerMayComeByStandardInput) {
  const Ran ran =
      run(fmt::format("exercise shown-depth --check - < '{}'", (answers() / "shown-depth/right.glsl").string()));
  EXPECT_EQ(ran.exit_code, 0) << ran.out;
  const Ran broken = run("exercise quad-space --check - < /dev/null");
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_TRUE(contains(broken.out, "standard input: is empty")) << broken.out;
}

// llvmpipe ends every loop after 65536 turns, so that the turns of this one are long: minutes on any processor.
TEST_F(ExerciseCommand, AnEndlessLoopIsAWrongAnswer) {
  std::string code = "vec3 decode_octahedral(vec2 p) {\n  float x = p.x, y = p.y;\n  while (x < 2.0) {\n";
  for (int i = 1; i <= 600; ++i)
    code += fmt::format("    x = fract(sin(x * {}.0 + y) * 43758.5 + pow(abs(y) + 0.1, x)); y = cos(y + x);\n", i);
  const std::string mine = file("endless.glsl", code + "  }\n  return vec3(x);\n}\n");
  const Ran ran = run(fmt::format("exercise octahedral-decode --limit 2 --check '{}'", mine));
  EXPECT_EQ(ran.exit_code, 1) << ran.out;
  EXPECT_TRUE(contains(ran.out, "did not end within 2 s")) << ran.out;
}

TEST_F(ExerciseCommand, AClassIsGradedAndNothingStopsIt) {
  const auto copy = [&](const std::string& from, const std::string& to) {
    fs::create_directories((folder / to).parent_path());
    fs::copy_file(answers() / from, folder / to);
  };
  copy("octahedral-decode/right.glsl", "ada/octahedral-decode.glsl");
  copy("glass-last/wrong1.json", "ada/glass-last.json");
  copy("glass-last/right.json", "grace-marie-glass-last.json");
  file("bob/glass-last.json", "{\"answer\": \"first\",,}");
  file("bob/octahedral-decode.glsl", "vec3 decode_octahedral(vec2 p) { return 1 }\n");
  file("bob/glas-last.json", "{}");
  file("bob/state.json", "{}");
  file("bob/.hidden.json", "{}");
  file("notes.md", "no answer");
  const Ran ran = run(fmt::format("exercise --grade '{}' --csv", folder.path().string()));
  EXPECT_EQ(ran.exit_code, 0) << ran.out;
  std::vector<std::string> lines;
  std::istringstream text(ran.out);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 7u) << ran.out;
  EXPECT_EQ(lines[0], "student,exercise,right,measure,note");
  EXPECT_TRUE(lines[1].starts_with("ada,glass-last,no,")) << lines[1];
  EXPECT_TRUE(lines[2].starts_with("ada,octahedral-decode,yes,largest error=")) << lines[2];
  EXPECT_TRUE(lines[3].starts_with("bob,glas-last,no,") && contains(lines[3], "did you mean 'glass-last'")) << lines[3];
  EXPECT_TRUE(lines[4].starts_with("bob,glass-last,no,") && contains(lines[4], ":1:20: not valid JSON")) << lines[4];
  EXPECT_TRUE(lines[5].starts_with("bob,octahedral-decode,no,") && contains(lines[5], "octahedral-decode.glsl:1: "))
      << lines[5];
  EXPECT_EQ(lines[6], "grace-marie,glass-last,yes,,");
  EXPECT_EQ(run(fmt::format("exercise --grade '{}/nowhere' --csv", folder.path().string())).exit_code, 2);
}

TEST_F(ExerciseCommand, OpensIntoAFolderAndKeepsAnAnswerThatWasBegun) {
  const std::string words = fmt::format("exercise shown-depth -o '{}'", (folder / "task").string());
  const Ran ran = run(words);
  EXPECT_EQ(ran.exit_code, 0) << ran.out;
  for (const char* name : {"task.md", "state.json", "shown-depth.glsl", "final.png", "depth.png"})
    EXPECT_TRUE(fs::exists(folder / "task" / name)) << name;
  EXPECT_EQ(read_settings(folder / "task" / "state.json").view.main, "depth");
  file("task/shown-depth.glsl", "// begun\n");
  run(words);
  EXPECT_EQ(read_text_file(folder / "task" / "shown-depth.glsl"), "// begun\n");
}

// ---- --layout-file -------------------------------------------------------------------------------------------------

class LayoutFileOption : public ExerciseCommand {};

TEST_F(LayoutFileOption, BytesAreReportedAndTheStateNamesTheContent) {
  const std::string mine = file("mine.glsl", read_text_file(answers() / "pack-smaller/right.glsl"));
  const std::string out = (folder / "out").string();
  const Ran ran =
      run(fmt::format("render --scene builtin:room --size 64x36 --set normal.encoding=oct16 --set depth.format=d32f "
                      "--layout-file '{}' --only final,metal --sheet --json -o '{}'",
                      mine, out));
  ASSERT_EQ(ran.exit_code, 0) << ran.out;
  EXPECT_TRUE(contains(ran.out, "\"bytes_per_pixel\": 18"))
      << ran.out << "\n10 of the layout, 4 each of normal and depth";
  EXPECT_TRUE(contains(read_text_file(fs::path(out) / "packing.svg"), "mine.glsl: 18 bytes per pixel"));
  const fs::path state = fs::path(out) / "settings.json";
  EXPECT_EQ(read_settings(state).layout_file, name_layout_file(mine));

  const std::string unasked = fmt::format("render --state '{}' --only final -o '{}'", state.string(), out);
  const Ran refused = run(unasked);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(contains(refused.out, mine + ": is shader text, named by a file and asked for by nobody")) << refused.out;
  const std::string again = unasked + " --run-layouts";
  EXPECT_EQ(run(again).exit_code, 0);
  file("mine.glsl", read_text_file(mine) + "// changed\n");
  const Ran changed = run(again);
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_TRUE(contains(changed.out, "was changed; give --layout-file")) << changed.out;
  EXPECT_EQ(run(again + fmt::format(" --layout-file '{}'", mine)).exit_code, 0);
  fs::remove(mine);
  const Ran gone = run(again);
  EXPECT_EQ(gone.exit_code, 2);
  EXPECT_TRUE(contains(gone.out, mine + ": cannot be read")) << gone.out;
  EXPECT_EQ(run(again + " --set layout=exact").exit_code, 0) << "another layout is chosen";
}

TEST_F(LayoutFileOption, AStudyAndABenchNameIt) {
  const std::string mine = file("mine.glsl", read_text_file(answers() / "pack-smaller/right.glsl"));
  const Ran bench = run(fmt::format("bench --size 64x36 --frames 0 --layout-file '{}' --json", mine));
  ASSERT_EQ(bench.exit_code, 0) << bench.out;
  EXPECT_EQ(parse_json(bench.out.substr(bench.out.find('{')), "bench")["settings"]["layout-file"],
            name_layout_file(mine));
}

}  // namespace
}  // namespace gbl::test
