// The chart in the window: its mapping, its keys, the mouse in it, and rows of every sort.
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>

#include "renderer/study/study.h"
#include "tests/study/study_rows.h"
#include "tests/ui/ui_desk.h"
#include "ui/panels/chart_view.h"
#include "ui/plot.h"

namespace gbl::ui {
namespace {

// ---- values and places -----------------------------------------------------------------------------------------
PlotAxis axis_of(const ChartAxis& scale, float from = 100, float to = 700) { return {scale, from, to}; }

TEST(PlotAxis, AValueComesBackFromItsPlace) {
  const PlotAxis axes[] = {axis_of({.logarithmic = true, .low = 1e-4, .high = 30}),
                           axis_of({.logarithmic = true, .low = 2, .high = 3}, 700, 100),
                           axis_of({.logarithmic = false, .low = -5, .high = 80}),
                           axis_of({.logarithmic = false, .low = 1000, .high = 1001}, 500, 20)};
  for (const PlotAxis& axis : axes) {
    EXPECT_FLOAT_EQ(axis.place(axis.scale.low), axis.from);
    EXPECT_FLOAT_EQ(axis.place(axis.scale.high), axis.to);
    for (int k = 0; k <= 20; ++k) {
      const double share = k / 20.0;
      const double value = axis.scale.logarithmic ? axis.scale.low * std::pow(axis.scale.high / axis.scale.low, share)
                                                  : axis.scale.low + share * (axis.scale.high - axis.scale.low);
      EXPECT_NEAR(axis.value(axis.place(value)), value, 1e-5 * std::abs(value) + 1e-6);
    }
  }
}

TEST(PlotAxis, AZeroOnALogarithmicAxisStandsAtItsOwnTick) {
  const ChartAxis scale = axis_for(chart_error_column("over_1_255_display"), {0, 0.01, 0.1});
  const PlotAxis axis = axis_of(scale);
  ASSERT_TRUE(scale.zero_at);
  EXPECT_EQ(axis.place(0), axis.place(*scale.zero_at));
  EXPECT_GT(axis.place(0), axis.from);
  EXPECT_TRUE(axis.shows(0));
  EXPECT_EQ(ticks_seen(scale).front().label, "0");
  ChartAxis closer = scale;
  closer.low = 0.005;
  EXPECT_NE(ticks_seen(closer).front().label, "0") << "out of sight";
  EXPECT_FALSE(axis_of(closer).shows(0));
}

TEST(PlotAxis, ZoomingKeepsThePlaceAndHasItsLimits) {
  const Span whole{0, 10};
  const Span closer = zoomed(whole, 2, 2, whole);
  EXPECT_NEAR(closer.width(), 5, 1e-12);
  EXPECT_NEAR((2 - closer.low) / closer.width(), 0.2, 1e-12);
  const Span back = zoomed(closer, 2, 0.5, whole);
  EXPECT_NEAR(back.low, 0, 1e-12);
  EXPECT_NEAR(back.high, 10, 1e-12);
  Span s = whole;
  for (int k = 0; k < 200; ++k) s = zoomed(s, 2, 2, whole);
  EXPECT_GT(s.width(), 1e-4);
  for (int k = 0; k < 400; ++k) s = zoomed(s, 2, 0.5, whole);
  EXPECT_LT(s.width(), 100);
  s = moved(whole, 1000, whole);
  EXPECT_NEAR((s.low + s.high) / 2, 10, 1e-12) << "something stays in sight";
  EXPECT_FALSE(ticks_seen({.logarithmic = true, .low = 3.1, .high = 3.100001}).empty());
}

TEST(PlotMarks, SixteenSeriesDifferWithoutTheirColoursAndNeighboursInBoth) {
  std::set<std::tuple<Mark, bool, ImU32>> seen;
  std::set<std::pair<Mark, bool>> shapes;
  for (size_t i = 0; i < 112; ++i) {
    const SeriesLook a = series_look(i), b = series_look(i + 1);
    EXPECT_TRUE(seen.insert({a.mark, a.hollow, a.colour}).second) << i;
    if (i < 16) {
      EXPECT_TRUE(shapes.insert({a.mark, a.hollow}).second) << i;
    }
    EXPECT_NE(a.mark, b.mark) << i;
    EXPECT_NE(a.colour, b.colour) << i;
  }
}

// ---- a desk with a chart -----------------------------------------------------------------------------------------
struct Numbers {
  double ms, over;
  LightMethod method = LightMethod::clustered;
  NormalEncoding normal = NormalEncoding::oct16;
};

class ChartDesk : public Desk {
 public:
  explicit ChartDesk(ImVec2 display = {1600, 900}, bool present = false) : Desk(display, present) {
    input.size = {320, 180};
    input.studies = {{"normals", "Normal encodings: x", "bytes_per_pixel", "normal_deg_p99", "normal.encoding"},
                     {"tradeoff", "Speed against accuracy: x", "time_ms_total_median", "rmse_linear", "lights.method"}};
    chart = &input;
  }

  void add(const Numbers& n) {
    Settings s = settings;
    s.lights.method = n.method;
    s.normal.encoding = n.normal;
    s.lights.cull = LightCull::flip_safe;
    s.lights.volume.clip = VolumeClip::none;
    s.size = {320, 180};
    s.view = {};
    StudyCase c{fmt::format("case {}", input.rows.size()), s, {}};
    c.at = {{"lights.method", row(n.method).id}, {"normal.encoding", row(n.normal).id}};
    MeasuredColumns columns{{}, s};
    for (const StudyColumn& e : chart_error_columns()) columns.cells.push_back({e.id, n.over});
    for (const StudyColumn& e : cost_columns()) columns.cells.push_back({e.id, n.ms});
    columns.cells.push_back({"time_ms_total_p10", n.ms * 0.9});
    columns.cells.push_back({"time_ms_total_p90", n.ms * 1.2});
    columns.cells.push_back({"frames", 9});
    columns.cells.push_back({"pairs_lit", 1000});
    input.rows.push_back(measured_row("tradeoff", c, columns));
    input.settings.push_back(s);
  }
  void add_preset(const char* id, double ms, double over) {
    add({ms, over});
    input.rows.back().at = {{"preset", id}};
  }
  void add_failed(const char* why) {
    add({1, 1});
    input.rows.back() = failed_row("tradeoff", {"case f", input.settings.back(), {}}, why);
    input.rows.back().key = "failed";
  }

  // As many as the largest built-in study has, of every method, preset labels among them.
  void add_many() {
    int k = 0;
    for (const ValueRow& m : rows<LightMethod>())
      for (const ValueRow& n : rows<NormalEncoding>()) {
        const double ms = 3 + k % 37 + 0.5 * m.value, over = (k % 5) * 1e-4 * (1 + n.value);
        add({ms, over, static_cast<LightMethod>(m.value), static_cast<NormalEncoding>(n.value)});
        ++k;
      }
    for (const Preset& p : presets()) add_preset(p.id, 5 + k % 7, 0.001 * (1 + k % 3)), ++k;
    add_failed("needs compute, which is not available here");
    input.current = 3;
    input.done = 100, input.total = 272, input.seconds_left = 250, input.running = "tradeoff";
    input.note =
        "tradeoff stopped after 100 of 272: the truth has changed (camera.position); its rows come back with "
        "its own truth. R goes on.";
  }

  // Everything that is drawn, as one number: what a key must change to have done something visible.
  size_t drawn() {
    frame();
    size_t h = 0;
    const auto mix = [&h](size_t v) { h ^= v + 0x9e3779b97f4a7c15u + (h << 6) + (h >> 2); };
    const ImDrawData* data = ImGui::GetDrawData();
    for (int l = 0; l < data->CmdListsCount; ++l)
      for (const ImDrawVert& v : data->CmdLists[l]->VtxBuffer) {
        mix(std::hash<float>()(v.pos.x)), mix(std::hash<float>()(v.pos.y));
        mix(std::hash<float>()(v.uv.x)), mix(std::hash<float>()(v.uv.y)), mix(v.col);
      }
    return h;
  }
  ChartRequest last() const { return requests.chart; }

  ChartInput input;
};

Settings applied(const Settings& before, Settings row) {
  row.size = before.size, row.view = before.view, row.time_s = before.time_s, row.camera = before.camera;
  return row;
}

TEST(Chart, F3OpensAndClosesItAndEscClosesIt) {
  ChartDesk desk;
  EXPECT_FALSE(desk.last().open);
  desk.press("F3");
  EXPECT_TRUE(desk.last().open);
  EXPECT_EQ(desk.last().study, "quick");
  EXPECT_EQ(desk.visible(), 3) << "final, and the two below it: the others are under the chart";
  EXPECT_TRUE(desk.requests.visible[static_cast<size_t>(View::final)]);
  EXPECT_EQ(desk.requests.picture_size, glm::ivec2(800, 450));
  desk.press("F3");
  EXPECT_FALSE(desk.last().open);
  desk.press("F3");
  desk.press("Esc");
  EXPECT_FALSE(desk.last().open);
}

TEST(Chart, OpenedForTheFirstTimeItBeginsAQuickStudy) {
  ChartDesk desk;
  const std::vector<ChartInput::Study> known = desk.input.studies;
  desk.input.studies.clear();
  desk.press("F3");
  EXPECT_FALSE(desk.last().run) << "nobody knows the studies yet";
  desk.input.studies = known;
  desk.frame();
  EXPECT_TRUE(desk.last().run);
  EXPECT_EQ(desk.last().study, "quick");
  desk.frame();
  EXPECT_FALSE(desk.last().run) << "once";
  desk.press("F3");
  desk.press("F3");
  EXPECT_FALSE(desk.last().run);
}

TEST(Chart, ALargePictureMovesBesideIt) {
  ChartDesk desk;
  desk.press("3");
  EXPECT_EQ(desk.requests.picture_size, glm::ivec2(1200, 675));
  desk.press("F3");
  EXPECT_EQ(desk.requests.picture_size, glm::ivec2(800, 450));
  EXPECT_EQ(desk.visible(), 1);
}

TEST(Chart, NoTextIsCutAtAnySizeOrScale) {
  for (const ImVec2 display : {ImVec2{1600, 900}, {1280, 720}, {1920, 1080}, {2560, 1080}})
    for (const bool present : {false, true})
      for (const bool rows : {false, true}) {
        ChartDesk desk(display, present);
        if (rows) desk.add_many();
        desk.press("F3");
        for (size_t y = 0; y < chart_error_columns().size(); ++y) {
          desk.press("Right");
          EXPECT_TRUE(desk.ui.cut_texts().empty())
              << display.x << "x" << display.y << (present ? " presenting " : " ") << desk.ui.cut_texts().front();
          desk.press("y");
          desk.press("x");
          desk.press("g");
        }
      }
}

TEST(Chart, EnterAppliesTheSelectedPointAndEveryPointIsReached) {
  ChartDesk desk;
  const NormalEncoding normals[] = {NormalEncoding::oct8, NormalEncoding::xyz8, NormalEncoding::xyz16f,
                                    NormalEncoding::oct12};
  for (int k = 0; k < 4; ++k) desk.add({10.0 + k % 2, 0.01 * k, LightMethod::clustered, normals[k]});
  desk.press("F3");
  std::set<NormalEncoding> reached;
  for (int k = 0; k < 4; ++k) {
    const Settings before = desk.settings;
    desk.press("Right");
    EXPECT_EQ(desk.settings, before) << "choosing changes nothing";
    desk.press("Enter");
    EXPECT_NE(desk.settings, before);
    reached.insert(desk.settings.normal.encoding);
    bool one = false;
    for (const Settings& row : desk.input.settings) one |= desk.settings == applied(before, row);
    EXPECT_TRUE(one);
  }
  EXPECT_EQ(reached.size(), 4u);
  desk.press("Home");
  EXPECT_EQ(desk.settings, preset("start").make());
}

TEST(Chart, IsSaidInWordsForThoseWhoDoNotSeeIt) {
  ChartDesk desk;
  desk.add({10, 0.01, LightMethod::clustered, NormalEncoding::oct8});
  desk.press("F3");
  desk.frame();
  EXPECT_NE(desk.requests.in_words.find("\nPanel chart: "), std::string::npos) << desk.requests.in_words;
  EXPECT_EQ(desk.requests.in_words.find("Chosen: "), std::string::npos) << "none is";
  desk.press("Right");
  desk.frame();
  EXPECT_NE(desk.requests.in_words.find("Chosen: "), std::string::npos) << desk.requests.in_words;
  EXPECT_NE(desk.requests.in_words.find(", cost 10 ms"), std::string::npos) << desk.requests.in_words;
  desk.press("F3");
  desk.frame();
  EXPECT_EQ(desk.requests.in_words.find("Panel chart"), std::string::npos) << "it is closed";
}

TEST(Chart, ShiftWalksTheFrontAlone) {
  ChartDesk desk;
  desk.add({1, 0.5, LightMethod::clustered, NormalEncoding::oct8});
  desk.add({2, 0.9, LightMethod::clustered, NormalEncoding::xyz8});  // beaten
  desk.add({3, 0.1, LightMethod::clustered, NormalEncoding::oct16});
  desk.press("F3");
  std::vector<NormalEncoding> path;
  for (int k = 0; k < 3; ++k) {
    desk.press("Right", true);
    desk.press("Enter");
    path.push_back(desk.settings.normal.encoding);
  }
  EXPECT_EQ(path, (std::vector{NormalEncoding::oct8, NormalEncoding::oct16, NormalEncoding::oct8}));
}

TEST(Chart, EnterWithoutASelectionChangesNothing) {
  ChartDesk desk;
  desk.add_many();
  desk.press("F3");
  const Settings before = desk.settings;
  desk.press("Enter");
  EXPECT_EQ(desk.settings, before);
}

TEST(Chart, ARowOfAnotherSceneBringsItsCamera) {
  ChartDesk desk;
  desk.add({1, 0.5});
  desk.input.settings[0].scene = "builtin:hall";
  desk.input.settings[0].camera.position = {1, 2, 3};
  desk.press("F3");
  desk.press("Right");
  desk.press("Enter");
  EXPECT_EQ(desk.settings.scene, "builtin:hall");
  EXPECT_EQ(desk.settings.camera.position, glm::dvec3(1, 2, 3));
}

TEST(Chart, EveryKeyDoesSomethingThatIsSeen) {
  const std::pair<const char*, bool> keys[] = {
      {"x", false},    {"x", true},   {"y", false},    {"y", true},    {"l", false}, {"k", false},
      {"f", false},    {"g", false},  {"g", true},     {"1", false},   {"8", false}, {"1", true},
      {"+", false},    {"-", false},  {"=", false},    {"s", false},   {"s", true},  {"Right", false},
      {"Left", false}, {"Up", false}, {"Down", false}, {"Right", true}};
  for (const auto& [key, shift] : keys) {
    ChartDesk desk;
    desk.add_many();
    desk.press("F3");
    const Settings settings = desk.settings;
    desk.frame();
    const size_t before = desk.drawn();
    EXPECT_EQ(desk.drawn(), before) << "nothing moves by itself";
    desk.press(key, shift);
    desk.seconds += 10;  // the caption is gone: what is left is the chart's doing
    EXPECT_NE(desk.drawn(), before) << key << shift;
    EXPECT_EQ(desk.settings, settings) << key << ": the chart's, not the picture's";
  }
}

TEST(Chart, ZeroFitsEverythingAgain) {
  ChartDesk desk;
  desk.add_many();
  desk.press("F3");
  const size_t before = desk.drawn();
  for (const char* key : {"+", "+", "-", "-", "-"}) desk.press(key);
  EXPECT_NE(desk.drawn(), before);
  desk.press("0");
  EXPECT_EQ(desk.drawn(), before);
}

TEST(Chart, LettersAreItsOwnOnlyWhileItIsOpen) {
  ChartDesk desk;
  desk.add_many();
  const Settings before = desk.settings;
  desk.press("F3");
  desk.press("l");
  EXPECT_EQ(desk.settings, before);
  desk.press("n");
  EXPECT_NE(desk.settings, before) << "and others work as ever: the ring moves";
  desk.press("n", true);
  desk.press("Esc");
  desk.press("l");
  EXPECT_NE(desk.settings, before);
}

TEST(Chart, TheCameraStandsStillUnderTheKeyS) {
  ChartDesk desk;
  desk.press("F3");
  const Settings before = desk.settings;
  desk.held = {"s"};
  desk.seconds += 0.1;
  desk.frame();
  EXPECT_EQ(desk.settings, before);
}

TEST(Chart, RRunsTheChosenStudyOnceAndStopsWhatRuns) {
  ChartDesk desk;
  desk.press("F3");
  desk.press("s");
  EXPECT_EQ(desk.last().study, "normals");
  desk.press("r");
  EXPECT_TRUE(desk.last().run);
  EXPECT_FALSE(desk.last().stop);
  desk.frame();
  EXPECT_FALSE(desk.last().run);
  desk.input.running = "normals";
  desk.press("r");
  EXPECT_TRUE(desk.last().stop);
  EXPECT_FALSE(desk.last().run);
}

// Where a value stands on the screen, told from where the mouse finds it: over the whole plot, in small steps.
std::optional<ImVec2> place_of_a_point(ChartDesk& desk, const Settings& wanted) {
  const Settings before = desk.settings;
  for (int y = 110; y < 560; y += 5)
    for (int x = 860; x < 1590; x += 5) {
      const ImVec2 at{static_cast<float>(x), static_cast<float>(y)};
      desk.click(at);
      if (desk.settings == before) continue;
      const bool found = desk.settings == applied(before, wanted);
      desk.settings = before;
      if (found) return at;
    }
  return {};
}

TEST(Chart, AClickAppliesAPointAndADragDoesNot) {
  ChartDesk desk;
  desk.add({10, 0.01, LightMethod::clustered, NormalEncoding::oct8});
  desk.add({100, 0.1, LightMethod::quads, NormalEncoding::xyz8});
  desk.press("F3");
  const std::optional<ImVec2> at = place_of_a_point(desk, desk.input.settings[1]);
  ASSERT_TRUE(at);
  const Settings before = desk.settings;
  const size_t drawn = desk.drawn();
  desk.point(*at, true);
  desk.point({at->x - 60, at->y + 30}, true);
  desk.point({at->x - 60, at->y + 30}, false);
  EXPECT_EQ(desk.settings, before);
  EXPECT_NE(desk.drawn(), drawn) << "it pans";
}

TEST(Chart, TheWheelZoomsAboutTheMouse) {
  ChartDesk desk;
  desk.add_many();
  desk.press("F3");
  desk.point({1200, 300});
  desk.frame();
  const size_t before = desk.drawn();
  ImGui::GetIO().MouseWheel = 1;
  desk.frame();
  ImGui::GetIO().MouseWheel = 0;
  EXPECT_NE(desk.drawn(), before);
  desk.press("0");
  EXPECT_EQ(desk.drawn(), before);
}

// ---- the view that is drawn -----------------------------------------------------------------------------------
struct Model {
  explicit Model(const ChartInput& rows)
      : state({}, false),
        input{.scene = scene, .lights = lights, .features = {}, .report = report, .chart = &rows},
        frame{state, settings, input, requests, {}, {}, Painter(*ImGui::GetBackgroundDrawList(), state.cut_texts)} {}
  ChartView view() { return chart_view(frame); }
  Scene scene;
  std::vector<Light> lights;
  FrameReport report;
  Settings settings;
  Requests requests;
  State state;
  Input input;
  FrameContext frame;
};

TEST(ChartViews, FamiliesThatAreOffLeaveThePlotAndTheFront) {
  ChartDesk desk;
  desk.add({1, 0.5, LightMethod::clustered});
  desk.add({2, 0.9, LightMethod::quads});
  Model m(desk.input);
  EXPECT_EQ(m.view().shown.size(), 2u);
  EXPECT_EQ(m.view().front.size(), 1u);
  toggle_family(m.state.of<ChartState>(), "clustered");
  ASSERT_EQ(m.view().shown.size(), 1u);
  EXPECT_EQ(m.view().front.size(), 1u) << "now the best of what is shown";
  EXPECT_EQ(m.view().point(m.view().front[0]).family, "quads");
  EXPECT_NE(counts_text(desk.input, m.view()).find("1 of families that are off"), std::string::npos);
  toggle_family(m.state.of<ChartState>(), "clustered");
  EXPECT_EQ(m.view().shown.size(), 2u);
}

TEST(ChartViews, AFamilyKeepsItsKeyColourAndShapeWhileAStudyGoesOn) {
  ChartDesk desk;
  desk.add({1, 0.5, LightMethod::quads});
  Model m(desk.input);
  const SeriesLook alone = m.view().look(0);
  desk.add({2, 0.9, LightMethod::forward});
  const ChartView v = m.view();
  EXPECT_EQ(v.look(0).mark, alone.mark);
  EXPECT_EQ(v.look(0).colour, alone.colour);
  EXPECT_EQ(v.families.front().name, "forward") << "in the order of the options table";
  EXPECT_EQ(v.families.back().number, static_cast<size_t>(LightMethod::quads));
}

TEST(ChartViews, EveryFamilyPathHasAKeyForEachOfItsValues) {
  for (const FamilyPath& family : family_paths()) EXPECT_LE(option(family.path).values.size(), 16u) << family.path;
}

TEST(ChartViews, LogarithmicAndLinearShowTheSamePointsZerosToo) {
  ChartDesk desk;
  for (const double over : {0.0, 0.0, 0.001, 0.5}) desk.add({1 + over, over});
  Model m(desk.input);
  for (const bool logarithmic : {true, false}) {
    m.state.of<ChartState>().log_y = logarithmic;
    const ChartView v = m.view();
    EXPECT_EQ(v.y.logarithmic, logarithmic);
    EXPECT_EQ(v.y.zero_at.has_value(), logarithmic);
    for (const size_t i : v.shown) EXPECT_TRUE(PlotAxis{v.y}.shows(v.point(i).error));
  }
}

TEST(ChartViews, FailedRowsAndRowsWithoutAValueAreCountedInWords) {
  ChartDesk desk;
  desk.add({1, 0.5});
  desk.add({1, std::numeric_limits<double>::quiet_NaN()});
  desk.add({1, 0.5});
  test::put(desk.input.rows.back(), "over_1_255_display", std::numeric_limits<double>::infinity());
  desk.input.rows.back().key = "another";
  desk.add_failed("no memory");
  Model m(desk.input);
  const std::string words = counts_text(desk.input, m.view());
  EXPECT_EQ(words, "1 point, 2 without a value on these axes, 1 failed");
}

TEST(ChartViews, TheSettingsAtHandStayInSightWhenTheirFamilyIsOff) {
  ChartDesk desk;
  desk.add({1, 0.5, LightMethod::clustered});
  desk.add({500, 0.9, LightMethod::quads});
  desk.input.current = 1;
  Model m(desk.input);
  toggle_family(m.state.of<ChartState>(), "quads");
  const ChartView v = m.view();
  ASSERT_TRUE(v.current);
  EXPECT_TRUE(PlotAxis{v.x}.shows(500));
}

TEST(ChartViews, ARowSaysWhatItIsAndWhatItCosts) {
  ChartDesk desk;
  desk.add({12.5, 0.25, LightMethod::quads, NormalEncoding::xyz8});
  Model m(desk.input);
  std::string words = row_title(desk.input, 0);
  for (const Field& field : row_fields(desk.input, m.view(), 0)) words += " | " + field.label + " " + field.text;
  for (const char* part : {row(LightMethod::quads).label, row(NormalEncoding::xyz8).label, "0.25", "12.5 ms",
                           "p10 11.25", "p90 15", "1 000 lit", "sound yes"})
    EXPECT_NE(words.find(part), std::string::npos) << part << " in: " << words;
  desk.input.settings[0].lights.method = LightMethod::disc;
  EXPECT_NE(row_fields(desk.input, m.view(), 0).back().text.find(id_of(row(LightMethod::disc).pitfall)),
            std::string::npos);
}

// ---- rows of every sort ------------------------------------------------------------------------------------------
TEST(Chart, NoRowsOneRowAllZerosAndNonsenseAreDrawn) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<Numbers>> sorts = {{},
                                                   {{1, 1}},
                                                   {{0, 0}, {0, 0}},
                                                   {{kNan, kNan}, {kInf, 1}, {1, -kInf}},
                                                   {{-3, -2}, {1e-30, 1e30}},
                                                   {{5, 5}, {5, 5}, {5, 5}}};
  const char* keys[] = {"Right", "Up", "Enter", "+", "-", "l", "k", "+", "0", "f", "1", "2", "g", "y", "x", "r", "s"};
  for (const std::vector<Numbers>& rows : sorts) {
    ChartDesk desk;
    for (const Numbers& n : rows) desk.add(n);
    if (!rows.empty()) desk.input.current = 0;
    desk.press("F3");
    for (const char* key : keys) {
      desk.press(key);
      for (const ImDrawVert& v : ImGui::GetDrawData()->CmdLists[0]->VtxBuffer)
        ASSERT_TRUE(std::isfinite(v.pos.x) && std::isfinite(v.pos.y)) << key;
      EXPECT_TRUE(desk.ui.cut_texts().empty()) << desk.ui.cut_texts().front();
    }
  }
}

TEST(Chart, EmptyRowsDoNotCrashIt) {
  ChartDesk desk;
  desk.input.rows = {StudyRow{}, test::row_of("nothing measured", {}), test::failed_row_of("failed", "")};
  desk.input.current = 7;
  desk.press("F3");
  for (const char* key : {"Right", "Enter", "+", "1"}) desk.press(key);
  desk.input.current = 1;
  desk.frame();
  desk.input.rows.clear();  // gone while one was selected
  for (const char* key : {"Right", "Enter", "+", "1"}) desk.press(key);
}

}  // namespace
}  // namespace gbl::ui
