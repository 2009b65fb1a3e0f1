#include "renderer/study/study_files.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

#include "renderer/base/json.h"
#include "renderer/picture/image.h"
#include "renderer/study/charts/gnuplot.h"
#include "tests/disk_room.h"
#include "tests/study/study_rows.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

const Machine kMachine{"Mesa 22.3", "llvmpipe"};

std::string command_of(const Settings& s) { return "gbufferlab bench --set layout=" + std::string(row(s.layout).id); }

StudySpec spec_with_label(const std::string& label) {
  StudySpec spec = parse_study(R"({"name": "t", "x": "mib", "y": "rmse_linear"})", "t.json");
  spec.label = label;
  return spec;
}

StudyRow row(const char* name, double mib, const ColumnValue& error, std::vector<Assignment> at = {}) {
  return test::row_of(name,
                      {{"mib", mib},
                       {"rmse_linear", error},
                       {"size", "640x360"},
                       {"time_source", "software-rasteriser"},
                       {"device", "llvmpipe"}},
                      std::move(at));
}

std::vector<StudyRow> rows() {
  std::vector<StudyRow> list = {row("a, \"quoted\"\nline", 1, 0.5, {{"layout", "exact"}}), row("b", 2, 0),
                                row("nclgl", 3, 0.25, {{"preset", "nclgl"}}), row("d", 4, {})};
  test::put(list[1], "time_ms_lighting_median", 2.5);  // a column that the first row has not
  list.push_back(test::failed_row_of("e", "no memory"));
  return list;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

bool gnuplot_is_there() {
  try {
    run_gnuplot("set terminal svg\nplot 0\n");
    return true;
  } catch (const Error&) {
    return false;
  }
}
#define NEEDS_GNUPLOT() \
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed: charts are not tested here"

// ---- study.csv --------------------------------------------------------------------------------------------
// RFC 4180, read back.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> table(1, {""});
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    std::string& cell = table.back().back();
    const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (quoted && c == '"' && next == '"')
      cell += c, ++i;
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && c == ',')
      table.back().emplace_back();
    else if (!quoted && c == '\r' && next == '\n') {
      ++i;
      if (i + 1 < text.size()) table.emplace_back(1, "");
    } else
      cell += c;
  }
  return table;
}

TEST(StudyCsv, IsReadBackAsWritten) {
  const auto table = parse_csv(study_csv(rows(), kMachine));
  ASSERT_EQ(table.size(), rows().size() + 1);
  std::vector<std::map<std::string, std::string>> read;
  for (size_t i = 1; i < table.size(); ++i) {
    ASSERT_EQ(table[i].size(), table[0].size()) << i;
    read.emplace_back();
    for (size_t c = 0; c < table[0].size(); ++c) read.back()[table[0][c]] = table[i][c];
  }
  EXPECT_EQ(read[0].size(), table[0].size()) << "a column stands twice";
  EXPECT_EQ(read[0]["case"], "a, \"quoted\"\nline");
  EXPECT_EQ(read[0]["at.layout"], "exact");
  EXPECT_EQ(read[1]["at.layout"], "");
  EXPECT_EQ(read[2]["at.preset"], "nclgl");
  EXPECT_EQ(read[0]["rmse_linear"], "0.5");
  EXPECT_EQ(read[3]["rmse_linear"], "") << "unknown is empty, never zero";
  EXPECT_EQ(read[0]["time_ms_lighting_median"], "");
  EXPECT_EQ(read[1]["time_ms_lighting_median"], "2.5");
  EXPECT_EQ(read[0]["lights.volume.level"], "2");
  EXPECT_EQ(read[0]["size"], "640x360");
  EXPECT_EQ(read[0]["camera.position"], "[0.0,0.0,0.0]");
  EXPECT_EQ(read[4]["failed"], "no memory");
  for (auto& r : read) {
    EXPECT_EQ(r["driver"], "Mesa 22.3");
    EXPECT_EQ(r["device"], "llvmpipe");
  }
  EXPECT_EQ(read[0].count("view.main"), 0u);
}

TEST(StudyCsv, HasAHeaderEvenWithoutRows) {
  EXPECT_TRUE(study_csv({}, kMachine).starts_with("study,case,key,driver,device,scene,"));
}

TEST(StudyJson, HoldsTheSpecTheMachineAndTheRows) {
  const StudySpec spec = spec_with_label("T");
  const Json json = Json::parse(study_json(spec, rows(), kMachine).dump());
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["spec"], *spec.json);
  EXPECT_EQ(json["machine"]["device"], "llvmpipe");
  EXPECT_EQ(json["rows"].size(), rows().size());
}

// ---- the chart --------------------------------------------------------------------------------------------
TEST(StudyFiles, AreAllWritten) {
  NEEDS_GNUPLOT();
  const TemporaryFolder folder("study-files");
  const fs::path out = folder / "new/deep";
  write_study_files(out, spec_with_label("Speed & accuracy"), rows(), kMachine, command_of);
  EXPECT_TRUE(Json::parse(bytes_of(out / "study.json")).is_object());
  const std::string svg = bytes_of(out / "study.svg");
  for (const char* part : {"<svg", "Speed &amp; accuracy", "llvmpipe, 640x360 pixels, times by software-rasteriser",
                           "rows without these numbers: 1", "rows that failed: 1", "all targets of a frame [MiB]",
                           "rmse_linear: root mean square [radiance]", "Pareto front", ">nclgl<", "</svg>"})
    EXPECT_TRUE(contains(svg, part)) << part;
  EXPECT_EQ(read_png(out / "study.png").size, glm::ivec2(1280, 800));
  size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(out)) ++files;
  EXPECT_EQ(files, 5u) << "nothing temporary is left";
  const std::string page = bytes_of(out / "study.html");
  for (const char* part : {"Speed &amp; accuracy", "all targets of a frame [MiB]", "llvmpipe", "Mesa 22.3",
                           "failed: no memory", "Layout:", "gbufferlab bench --set layout=", "no picture"})
    EXPECT_TRUE(contains(page, part)) << part;
}

TEST(StudyFiles, NothingInATextIsACommand) {
  NEEDS_GNUPLOT();
  const TemporaryFolder folder("study-hostile");
  const std::string touched = (folder / "touched").string();
  const std::string hostile = "it's `touch " + touched + "` $(touch " + touched + ") \"';system('touch " + touched +
                              "');' \n!touch " + touched + "\nEOD \\ @x {a}_b %d \xc3\xa4";
  std::vector<StudyRow> list = rows();
  list[0].at.push_back({"lights.method", hostile});
  list[2].at = {{"preset", hostile}};
  test::put(list[0], "device", hostile);
  write_study_files(folder / "out", spec_with_label(hostile), list, kMachine, command_of);
  EXPECT_FALSE(fs::exists(touched));
  const std::string svg = bytes_of(folder / "out/study.svg");
  EXPECT_TRUE(contains(svg, "it&apos;s `touch") || contains(svg, "it's `touch")) << "shown as it is";
}

TEST(StudyFiles, EveryColumnCanBeDrawn) {
  NEEDS_GNUPLOT();
  std::vector<StudyRow> list = rows();
  for (size_t i = 0; i < 3; ++i) {
    for (const ErrorColumn& e : error_columns()) test::put(list[i], e.id, i * 0.1);
    for (const char* id : {"time_ms_total_median", "pairs_shaded", "pairs_lit", "draw_calls"})
      test::put(list[i], id, 5);
  }
  for (const char* x : {"draw_calls", "shaded_per_lit", "mib"})
    for (const StudyColumn& y : chart_error_columns())
      EXPECT_TRUE(
          contains(run_gnuplot(chart_script(chart_points(list, x, y.id, "layout"), {}, ChartFile::svg)), "</svg>"))
          << x << " " << y.id;
}

TEST(StudyFiles, WithoutGnuplotTheTablesAreThere) {
  const TemporaryFolder folder("study-no-gnuplot");
  const char* path = std::getenv("PATH");
  const std::string before = path ? path : "";
  setenv("PATH", folder.path().c_str(), 1);
  const std::string line = error_line(ExitCode::unfinished, [&] {
    write_study_files(folder / "out", spec_with_label("T"), rows(), kMachine, command_of);
  });
  setenv("PATH", before.c_str(), 1);
  EXPECT_TRUE(contains(line, "gnuplot-nox")) << line;
  EXPECT_TRUE(fs::exists(folder / "out/study.csv"));
  EXPECT_TRUE(fs::exists(folder / "out/study.json"));
  EXPECT_TRUE(fs::exists(folder / "out/study.html"));
  EXPECT_FALSE(fs::exists(folder / "out/study.svg"));
}

TEST(StudyFiles, NothingToDrawIsSaid) {
  const TemporaryFolder folder("study-nothing");
  const std::string line = error_line(ExitCode::unfinished, [&] {
    write_study_files(folder.path(), spec_with_label("T"), {rows()[3]}, kMachine, command_of);
  });
  EXPECT_TRUE(contains(line, "no row has both mib and rmse_linear")) << line;
  EXPECT_TRUE(fs::exists(folder / "study.csv"));
  EXPECT_TRUE(contains(bytes_of(folder / "study.html"), "1 have no finite value")) << "the page says so and is there";
}

// All rows failed, or none was measured: the page is there and says so.
TEST(StudyFiles, APageNeedsNoPoint) {
  const TemporaryFolder folder("study-page");
  const std::vector<std::vector<StudyRow>> lists = {{}, {test::failed_row_of("e", "no memory")}};
  for (const std::vector<StudyRow>& list : lists) {
    const std::string page = page_html(study_page(spec_with_label("T"), list, kMachine, command_of, folder.path()));
    EXPECT_TRUE(contains(page, list.empty() ? "None has been measured" : "failed: no memory"));
  }
}

TEST(Gnuplot, ARefusedScriptIsAnErrorOfOneLine) {
  NEEDS_GNUPLOT();
  error_line(ExitCode::unfinished, [] { run_gnuplot("set terminal no-such-terminal\n"); });
}

// gnuplot itself ends well.
TEST(Gnuplot, AChartThatAFullDiskCutShortIsAnError) {
  NEEDS_GNUPLOT();
  for (const char* terminal : {"svg", "pngcairo"}) {
    const std::string script = std::string("set terminal ") + terminal + "\nplot sin(x)\n";
    const size_t whole = run_gnuplot(script).size();
    for (const size_t most : {whole / 2, whole - 8}) {
      const DiskRoom room(most);
      const std::string line = error_line(ExitCode::unfinished, [&] { run_gnuplot(script); });
      EXPECT_TRUE(contains(line, "cut short; make room in /tmp")) << line;
    }
  }
}

}  // namespace
}  // namespace gbl
