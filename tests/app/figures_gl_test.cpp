// Figures: made from data, made again from their own files.
#include <fmt/format.h>

#include "app/figure_sets.h"
#include "app/figure_writer.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/picture_difference.h"
#include "tests/gl_fixture.h"
#include "tests/test_paths.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

class FiguresGl : public GlTest {
 protected:
  Lab& lab() {  // made when a context is current
    if (!lab_) lab_.emplace(FeatureSet{});
    return *lab_;
  }

 private:
  std::optional<Lab> lab_;
};

FigureSpec figure(const char* members) {
  const std::string text = fmt::format(
      R"({{"id": "f", "title": "T", "caption": "C.", "scene": "builtin:yard", "size": [96, 54], "set": {{"lights.count": 4}}, {}}})",
      members);
  return parse_figure(parse_json(text, "test"), "test");
}

// Of the picture inside the first tile, without its frame, badge and legend.
double inside_difference(const Image& a, const Image& b) {
  EXPECT_EQ(a.size, b.size);
  double most = 0;
  for (int y = 34; y < 50; ++y)
    for (int x = 24; x < 100; ++x)
      for (size_t k = 0; k < 3; ++k) {
        const size_t i = 4 * (static_cast<size_t>(y) * static_cast<size_t>(a.size.x) + static_cast<size_t>(x)) + k;
        most = std::max(most, std::abs(double(a.rgba[i]) - b.rgba[i]));
      }
  return most;
}

TEST_F(FiguresGl, APictureMakesItselfAgain) {
  const TemporaryFolder folder("figures");
  const FigureSpec f = figure(R"("panels": [{"view": "final"}, {"view": "depth", "set": {"exposure": 2}}])");
  FigureMaker maker(lab(), {});
  write_figure(folder.path(), f, maker, lab().machine(), {.look = {}, .set = "test"});
  const FigureSet again = figures_named((folder / "f.png").string());
  ASSERT_EQ(again.figures.size(), 1u);
  EXPECT_EQ(maker.picture(again.figures[0]), read_png(folder / "f.png"));
  const Settings state = parse_settings(read_png_text(folder / "f.png", kSettingsKey), "f.png");
  EXPECT_EQ(state, maker.settings()) << "and keeps its first panel's settings";
  EXPECT_NE(read_text_file(folder / "f.tex").find("\\label{fig:f}"), std::string::npos);
  EXPECT_NE(read_text_file(folder / "f.md").find("(f.png)"), std::string::npos);
}

TEST_F(FiguresGl, AMissingViewIsRefusedBeforeAnythingIsDrawn) {
  FigureMaker maker(lab(), {});
  const FigureSpec f = figure(R"("panels": [{"view": "specular-light", "set": {"accumulation.targets": "one"}}])");
  try {
    maker.check(f);
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("f: panel 1: view 'specular-light'"), std::string::npos) << e.what();
  }
  EXPECT_FALSE(lab().has_drawn());
}

TEST_F(FiguresGl, TheOtherSideAndDrawingsAreCheckedToo) {
  FigureMaker maker(lab(), {});
  const char* near = R"("panels": [{"view": "final", "against": {"set": {"camera.near": 99999}}}])";
  EXPECT_THROW(maker.check(figure(near)), Error);
  EXPECT_THROW(maker.check(figure(R"("drawing": "light-from-side", "preset": "start", "set": {"view.pick": 99})")),
               Error);
}

TEST_F(FiguresGl, AgainstShowsTheOtherSettingsRightOfTheLine) {
  FigureMaker maker(lab(), {});
  const char* both = R"("columns": 1, "panels": [{{"view": "albedo", "set": {{"albedo": "{}"}}{}}}])";
  const auto made = [&](const std::string& albedo, const std::string& rest) {
    return maker.picture(figure(fmt::format(fmt::runtime(both), albedo, rest).c_str()));
  };
  const Image textured = made("textured", ""), white = made("white", "");
  ASSERT_GT(inside_difference(textured, white), 50);
  const auto against = [&](const char* from) {
    return made("textured", fmt::format(R"(, "against": {{"set": {{"albedo": "white"}}, "from": {}}})", from));
  };
  EXPECT_EQ(inside_difference(against("1"), textured), 0);
  EXPECT_EQ(inside_difference(against("0"), white), 0);
  EXPECT_GT(inside_difference(against("0.5"), white), 50);
  EXPECT_GT(inside_difference(against("0.5"), textured), 50);
}

TEST_F(FiguresGl, AnInsetNumbersAndAZoomChangeThePicture) {
  FigureMaker maker(lab(), {});
  const Image plain = maker.picture(figure(R"("columns": 1, "panels": [{"view": "depth"}])"));
  const Image inset = maker.picture(figure(
      R"("columns": 1, "panels": [{"view": "depth", "inset": {"scale": 6, "centre": [0.2, 0.2], "corner": "bottom right"}}])"));
  EXPECT_GT(largest_square_difference(plain, inset, 8), 10);
  const char* close =
      R"("columns": 1, "set": {{"lights.count": 4, "view.zoom": 60, "view.centre": [0.50521, 0.50926]}}, "panels": [{{"view": "depth", "numbers": {}}}])";
  const Image without = maker.picture(figure(fmt::format(fmt::runtime(close), "false").c_str()));
  const Image with = maker.picture(figure(fmt::format(fmt::runtime(close), "true").c_str()));
  EXPECT_GT(largest_square_difference(without, plain, 8), 10);
  EXPECT_GT(largest_square_difference(without, with, 8), 10);
}

TEST_F(FiguresGl, ScaleWidthGreyAndPaper) {
  const FigureSpec f = figure(R"("panels": [{"view": "normal"}, {"view": "final"}])");
  const Image one = FigureMaker(lab(), {}).picture(f), twice = FigureMaker(lab(), {.scale = 2}).picture(f);
  EXPECT_NEAR(twice.size.x, 2 * one.size.x, 2) << "margins and tiles are whole pixels";
  EXPECT_NEAR(twice.size.y, 2 * one.size.y, 8) << "type comes in whole sizes";
  const FigureLook printed{.width_cm = 12};
  const Image wide = FigureMaker(lab(), printed).picture(f);
  EXPECT_NEAR(wide.size.x, 12 * 300 / 2.54, 12);
  EXPECT_NEAR(pixels_per_cm(wide, printed), wide.size.x / 12.0, 1e-9);
  const Image grey = FigureMaker(lab(), {.grey = true}).picture(f),
              paper = FigureMaker(lab(), {.light = true}).picture(f);
  for (size_t i = 0; i < grey.rgba.size(); i += 4)
    ASSERT_TRUE(grey.rgba[i] == grey.rgba[i + 1] && grey.rgba[i] == grey.rgba[i + 2]);
  EXPECT_EQ(paper.rgba[0], 255);
  EXPECT_LT(one.rgba[0], 60);
}

TEST_F(FiguresGl, FramesAreNumberedAndMove) {
  const TemporaryFolder folder("frames");
  const FigureSpec f = figure(
      R"("columns": 1, "panels": [{"view": "depth"}], "frames": {"count": 3, "keys": [{"camera": "20,5,40:0,0:45"}, {"camera": "20,5,20:0,0:45"}]})");
  FigureMaker maker(lab(), {});
  const FigureWords words = write_figure(folder.path(), f, maker, lab().machine(), {.look = {}, .set = "test"}).value();
  const Image first = read_png(folder / "f/0001.png"), last = read_png(folder / "f/0003.png");
  EXPECT_GT(largest_square_difference(first, last, 8), 10);
  EXPECT_TRUE(std::filesystem::exists(folder / words.file)) << words.file;
  EXPECT_FALSE(std::filesystem::exists(folder / "f/0004.png"));
  const std::atomic<bool> stop = true;
  const FigureOptions stopped{.look = {}, .set = "test", .numbers = true, .interrupted = &stop};
  std::filesystem::remove(folder / "f.md");
  EXPECT_FALSE(write_figure(folder.path(), f, maker, lab().machine(), stopped)) << "before its first picture";
  EXPECT_FALSE(std::filesystem::exists(folder / "f.md"));
}

TEST_F(FiguresGl, AnOutdatedPictureIsNamed) {
  const TemporaryFolder folder("outdated");
  FigureMaker maker(lab(), {});
  const FigureSpec f = figure(R"("panels": [{"view": "albedo"}])"),
                   changed = figure(R"("panels": [{"view": "albedo", "set": {"albedo": "white"}}])");
  EXPECT_EQ(why_outdated(folder.path(), f, maker), "f.png is missing");
  write_figure(folder.path(), f, maker, lab().machine(), {.look = {}, .set = "test", .few_colours = true});
  EXPECT_EQ(why_outdated(folder.path(), f, maker), "") << "fewer colours are no change";
  EXPECT_NE(why_outdated(folder.path(), changed, maker), "");
}

// What README and docs show is what the program draws today.
TEST_F(FiguresGl, TheDocumentsPicturesAreCurrent) {
  FigureMaker maker(lab(), {});
  for (const FigureSpec& f : figures_named("docs").figures)
    EXPECT_EQ(why_outdated(source_folder() / "docs/images", f, maker), "")
        << "run: gbufferlab figures docs --pictures-only --few-colours -o docs/images";
}

TEST_F(FiguresGl, EveryFigureOfTheTutorialsCanBeMade) {
  FigureMaker maker(lab(), {});
  for (const FigureSpec& f : figures_named("sources").figures) EXPECT_NO_THROW(maker.check(f)) << f.id;
}

TEST_F(FiguresGl, EveryPitfallAndEveryLessonMakesFigures) {
  FigureMaker maker(lab(), {});
  const FigureSet pitfalls = figures_named("pitfalls");
  EXPECT_EQ(pitfalls.figures.size(), 65u);
  for (const FigureSpec& f : pitfalls.figures) EXPECT_NO_THROW(maker.check(f)) << f.id;
  for (const std::string& id : lesson_ids())
    for (const FigureSpec& f : figures_of(load_lesson(id)).figures) EXPECT_NO_THROW(maker.check(f)) << f.id;
}

}  // namespace
}  // namespace gbl::test
