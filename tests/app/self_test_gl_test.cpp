// The self-test that a bug report holds: every picture can be drawn here, holds, and is the one that its hash says.
#include "app/self_test.h"

#include <set>

#include "app/bench.h"
#include "app/driver_report.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "tests/gl_fixture.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

class SelfTest : public GlTest {};

TEST_F(SelfTest, EveryPictureHolds) {
  Lab lab({});
  std::set<std::string> ids, hashes;
  const std::vector<SelfTestResult> all = run_self_test(lab, [](const SelfTestResult&) {});
  EXPECT_EQ(all.size(), 12u);
  for (const SelfTestResult& r : all) {
    ids.insert(r.id);
    EXPECT_EQ(r.failed, "") << r.id;
    if (!r.skipped.empty()) {
      EXPECT_TRUE(!gl::device().features.has(Feature::compute) && r.id == "tiled") << r.id << ": " << r.skipped;
      continue;
    }
    EXPECT_TRUE(r.holds()) << r.id << ": FLIP " << r.flip_mean;
    EXPECT_EQ(r.hash.size(), 16u);
    hashes.insert(r.hash);
  }
  EXPECT_EQ(ids.size(), all.size());
  EXPECT_GE(hashes.size(), 9u) << "pictures of different settings differ";
}

TEST_F(SelfTest, WithoutAFeatureItsPictureIsSkippedWithTheReason) {
  FeatureSet off;
  off.add(Feature::compute);
  Lab lab(off);
  for (const SelfTestResult& r : run_self_test(lab, [](const SelfTestResult&) {}))
    EXPECT_EQ(contains(r.skipped, "compute"), r.id == "tiled") << r.id;
  gl::probe_device({});
}

TEST(SelfTestResult, HoldsOnlyWithinItsBoundAndFinite) {
  EXPECT_TRUE((SelfTestResult{.flip_mean = 0.1, .flip_at_most = 0.1}.holds()));
  EXPECT_FALSE((SelfTestResult{.flip_mean = 0.11, .flip_at_most = 0.1}.holds()));
  EXPECT_FALSE((SelfTestResult{.flip_mean = 0.1, .flip_at_most = 0.1, .nonfinite_pixels = 1}.holds()));
  EXPECT_FALSE((SelfTestResult{.skipped = "no compute", .flip_at_most = 0.1}.holds()));
  EXPECT_FALSE((SelfTestResult{.failed = "a shader", .flip_at_most = 0.1}.holds()));
}

// To judge a row a frame without lights is drawn into the same targets.
TEST_F(SelfTest, TheBenchsPictureIsOfTheFrameThatWasMeasured) {
  Lab lab({});
  Settings s = preset("compact").make();
  s.size = {64, 36};
  lab.open(s.scene);
  Bench bench(lab.renderer(), lab.cost(), lab.machine(), 1);
  bench.start(s, lab.gpu_scene(), {.errors = true, .times = false});
  bench.step(true);
  const Image measured = bench.picture();
  lab.draw(s);
  lab.draw_view(View::final);
  EXPECT_TRUE(measured == lab.image_of(View::final));
}

TEST(DriverTable, ComparesWithTheFirst) {
  const TemporaryFolder folder("driver-table");
  const auto write = [&](const char* name, const char* hash, bool tiled) {
    Json report{{"gl", "4.5"}, {"device", name}, {"self_test", Json::array()}};
    report["format_checks"] = {{{"id", "depth.format=d16"}, {"holds", true}},
                               {{"id", "depth.format=d24"}, {"holds", tiled}}};
    report["self_test"].push_back({{"id", "exact"}, {"hash", hash}, {"flip_mean", 0.25}, {"holds", true}});
    if (tiled)
      report["self_test"].push_back({{"id", "tiled"}, {"hash", "b"}, {"flip_mean", 0.5}, {"holds", false}});
    else
      report["self_test"].push_back({{"id", "tiled"}, {"skipped", "no compute"}});
    write_text_file(folder / (std::string(name) + ".json"), report.dump());
    return folder / (std::string(name) + ".json");
  };
  const std::string table =
      driver_table({write("one", "a", true), write("two", "a", false), write("three", "x", true)});
  EXPECT_TRUE(contains(table, "| one | 4.5, one | 2 | 1 | 2 | 0.50000 |  | 2 of 2 |")) << table;
  EXPECT_TRUE(contains(table, "| two | 4.5, two | 1 | 1 | 1 | 0.25000 | tiled | 1 of 2 |")) << table;
  EXPECT_TRUE(contains(table, "| three | 4.5, three | 2 | 1 | 1 | 0.50000 |  |")) << table;
  write_text_file(
      folder / "four.json",
      R"({"gl": "4.5", "device": "four", "format_checks": [], "self_test": [{"id": "exact", "failed": "a shader", "holds": false}]})");
  EXPECT_TRUE(contains(driver_table({folder / "four.json", folder / "four.json"}), "| four | 4.5, four | 1 | 0 | 0 |"))
      << "what was not drawn equals nothing";
  write_text_file(folder / "no.json", "{\"self_test\": 3}");
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [&] { driver_table({folder / "no.json"}); }), "no.json"));
}

}  // namespace
}  // namespace gbl::test
