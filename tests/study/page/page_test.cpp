// The page of a study: what stands in it whatever its texts, how large it gets, and that nothing breaks out of it.
#include "renderer/study/page/page.h"

#include <gtest/gtest.h>

#include "renderer/base/json.h"
#include "renderer/base/random.h"
#include "renderer/study/page/html_text.h"
#include "tests/study/study_rows.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

constexpr const char* kHostile = "</script><script>alert(1)</script>\"'><img src=x onerror=alert(2)>&<!--";

size_t count(const std::string& text, std::string_view part) {
  size_t n = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

Image noise(glm::ivec2 size) {
  Pcg32 random(5);
  Image image{size, {}};
  for (int i = 0; i < 4 * size.x * size.y; ++i) image.rgba.push_back(static_cast<uint8_t>(random.in(0, 256)));
  return image;
}

IndexedImage palette_noise(glm::ivec2 size) {
  Pcg32 random(6);
  IndexedImage image{size, {}, {}};
  for (const ErrorStep& s : kErrorSteps) image.palette.push_back(s.colour);
  for (int i = 0; i < size.x * size.y; ++i)
    image.index.push_back(static_cast<uint8_t>(random.in(0, double(kErrorSteps.size()))));
  return image;
}

// As many rows and numbers as the largest built-in study has.
Page page_of(size_t rows, const std::string& text, const Thumbnails& thumbnails) {
  Page page{.title = text, .how_to_read = text, .rows_are = "The set-ups", .pictures = true};
  page.machine = {{"device", text}};
  page.columns = {{text, text}, {"b", "b"}};
  for (int i = 0; i < 80; ++i) page.details.push_back("column " + std::to_string(i));
  PageChart chart{.title = text, .note = text};
  chart.families = {text};
  for (size_t i = 0; i < rows; ++i) {
    chart.points.push_back(
        {.x = double(i + 1), .y = double(i + 1), .words = text, .row = i, .label = i < 15 ? text : ""});
    PageRow row{
        .words = text, .unsound = i % 2 ? text : "", .command = "gbufferlab bench " + text, .thumbnails = thumbnails};
    row.cells = {{text}, {"1", 1.0}};
    row.details.assign(page.details.size(), "0.001234");
    page.rows.push_back(row);
  }
  std::vector<double> values;
  for (const PagePoint& p : chart.points) values.push_back(p.x);
  chart.x = page_axis(cost_column("mib"), values), chart.y = page_axis(chart_error_column("rmse_linear"), values);
  page.charts = {chart};
  return page;
}

TEST(HtmlText, StaysText) {
  EXPECT_EQ(html_text("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
  EXPECT_EQ(html_text("two\nlines"), "two&#10;lines");
  EXPECT_EQ(html_text("\xff"), "\xef\xbf\xbd") << "what is no UTF-8 is replaced";
  EXPECT_EQ(html_text(std::string_view("\x01", 1)), " ");
}

TEST(HtmlText, JsonCannotEndItsScriptElement) {
  const Json json = {{"a", kHostile}};
  const std::string text = json_for_script(json);
  EXPECT_EQ(text.find('<'), std::string::npos) << text;
  EXPECT_EQ(Json::parse(text), json) << "and says the same";
}

TEST(Page, NoTextIsMarkup) {
  const std::string html = page_html(page_of(3, kHostile, {}));
  const std::string plain = page_html(page_of(3, "plain", {}));
  for (const char* part : {"<script", "</script", "<img", "<!--", "onerror=alert(2)>"})
    EXPECT_EQ(count(html, part), count(plain, part)) << part;
}

TEST(Page, FetchesNothing) {
  const std::string html = page_html(page_of(2, "plain", {"\xff\xd8\xff", "\x89PNG"}));
  for (const char* part : {"http://", "https://", "url(", "@import", "<link", "src=\"/"})
    EXPECT_EQ(count(html, part), 0u) << part;
  EXPECT_TRUE(contains(html, "default-src 'none'"));
}

TEST(Page, EveryRowHasItsCommandAndItsPictures) {
  Page page = page_of(4, "plain", {"\xff\xd8\xff", "\x89PNG"});
  page.rows[2].thumbnails = {};
  page.rows[3].failed = "no memory";
  const std::string html = page_html(page);
  EXPECT_EQ(count(html, "<code>gbufferlab bench plain</code>"), 4u);
  EXPECT_EQ(count(html, "src=\"data:image/jpeg;base64,/9j/\""), 2u);
  EXPECT_EQ(count(html, "src=\"data:image/png;base64,"), 2u);
  EXPECT_EQ(count(html, "no picture</span>"), 1u) << "a row without one says so";
  EXPECT_EQ(count(html, "no error map</span>"), 1u);
  EXPECT_EQ(count(html, "failed: no memory"), 1u);
}

TEST(Page, IsReadableWithoutItsScript) {
  const std::string html = page_html(page_of(3, "plain", {}));
  EXPECT_EQ(count(html, "<g class=\"dot f0\""), 3u + 1) << "drawn here, and one in the legend";
  EXPECT_EQ(count(html, "<title>plain</title>"), 3u + 1) << "a dot's words are what the browser shows by itself";
  EXPECT_EQ(count(html, "<tr data-row="), 3u);
}

TEST(Page, HasNoRowsOrOne) {
  for (const size_t rows : {0u, 1u}) {
    const std::string html = page_html(page_of(rows, "plain", {}));
    EXPECT_EQ(count(html, "<tr data-row="), rows);
    EXPECT_EQ(html.find("nan"), std::string::npos) << "a place that is no number";
    EXPECT_TRUE(html.ends_with("</html>\n"));
  }
}

// The worst pictures there are, of 265 rows with commands of 1 KB: the bound of a study as large as `tradeoff`.
TEST(Page, Of265RowsTakesSixMegabytesAtMost) {
  const Thumbnails worst{jpeg_bytes(noise(kThumbnailSize), 75), png_bytes(palette_noise(kThumbnailSize))};
  EXPECT_LT(page_html(page_of(265, std::string(1000, 'x'), worst)).size(), 6'000'000u);
}

TEST(PageAxis, CanBeLogarithmicAndLinear) {
  const PageAxis axis = page_axis(chart_error_column("over_1_255_display"), {0, 0.01, 0.1});
  EXPECT_TRUE(axis.shown.logarithmic);
  EXPECT_FALSE(axis.other->logarithmic);
  EXPECT_TRUE(contains(axis.title, "[%]"));
  EXPECT_FALSE(page_axis(chart_error_column("psnr_display"), {30, 40}).shown.logarithmic);
  EXPECT_FALSE(page_axis(cost_column("mib"), {-1, 2}).other) << "what is negative has no logarithm";
}

TEST(PageSvg, ZeroHasARowOfItsOwn) {
  PageChart chart{.title = "t",
                  .note = "n",
                  .x = page_axis(cost_column("mib"), {1, 2}),
                  .y = page_axis(chart_error_column("over_1_255_display"), {0, 0.1})};
  chart.families = {"a"};
  chart.points = {{.x = 1, .y = 0}, {.x = 2, .y = 0.1, .sound = false}};
  const std::string svg = page_svg(chart, 0);
  EXPECT_EQ(count(svg, "class=\"zero\""), 1u);
  EXPECT_TRUE(contains(svg, ">10 %<"));
  EXPECT_EQ(count(svg, "dot f0 unsound\" role"), 1u);
  EXPECT_TRUE(contains(svg, "Sound (filled)") && contains(svg, "Unsound"));
}

}  // namespace
}  // namespace gbl
