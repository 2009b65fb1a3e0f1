#include "renderer/figures/captions.h"

#include <gtest/gtest.h>

#include "renderer/base/base64.h"
#include "renderer/base/json.h"
#include "renderer/figures/handout.h"
#include "renderer/lessons/lessons.h"

namespace gbl {
namespace {

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(Captions, LatexReadsEveryCharacterAsText) {
  EXPECT_EQ(latex_escaped("100 % of a_b & $x^2$ #1 {y} ~ \\"),
            "100 \\% of a\\_b \\& \\$x\\textasciicircum{}2\\$ \\#1 \\{y\\} \\textasciitilde{} \\textbackslash{}");
  EXPECT_EQ(latex_escaped("2×2 µ"), "2×2 µ") << "UTF-8 stays: LaTeX reads it";
}

TEST(Captions, MarkdownReadsEveryCharacterAsText) { EXPECT_EQ(markdown_escaped("a*b_[c]"), "a\\*b\\_\\[c\\]"); }

FigureWords words() {
  return {.id = "lost-light",
          .file = "lost-light.png",
          .title = "T",
          .caption = "50 % lost.",
          .alt = "A hole",
          .source = "tutorial",
          .command = "gbufferlab figures x",
          .made_by = "1.0",
          .width_cm = 8};
}

TEST(Captions, AFigureOfLatexIsWhole) {
  const std::string tex = latex_caption(words());
  for (const char* part : {"\\begin{figure}", "\\includegraphics[width=8cm,alt={A hole}]{lost-light.png}",
                           "\\caption{50 \\% lost. After: tutorial.}", "\\label{fig:lost-light}", "\\end{figure}"})
    EXPECT_TRUE(has(tex, part)) << part << " in\n" << tex;
}

TEST(Captions, MarkdownHasPictureCaptionAndCommand) {
  const std::string md = markdown_caption(words());
  for (const char* part : {"![A hole](lost-light.png)", "*50 % lost. After: tutorial.*", "gbufferlab figures x"})
    EXPECT_TRUE(has(md, part)) << part << " in\n" << md;
}

TEST(Captions, WithoutAnAltTextThePanelsAreNamed) {
  const Json j = {{"id", "f"},
                  {"title", "Two views"},
                  {"caption", "c"},
                  {"preset", "start"},
                  {"panels", {{{"view", "depth"}, {"words", "how far"}}, {{"view", "normal"}}}}};
  const FigureSpec f = parse_figure(j, "f.json");
  EXPECT_TRUE(has(alt_text(f), "Two views. (a) how far. (b) normal: ")) << alt_text(f);
  EXPECT_EQ(panel_words(f), "(a) how far.");
  Json own = j;
  own["alt"] = "Mine";
  EXPECT_EQ(alt_text(parse_figure(own, "f.json")), "Mine");
}

TEST(Base64, TestVectorsOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

struct Paper {
  Lesson lesson = load_lesson("three-ways-to-lose-a-light");
  std::vector<HandoutFigure> figures;
  Paper() {
    for (size_t k = 0; k < lesson.steps.size(); ++k)
      figures.push_back(
          {{.file = "f" + std::to_string(k) + ".png", .alt = "<alt>", .command = "gbufferlab view --state f.png"},
           "Look.",
           "PNG"});
  }
};

TEST(Handout, AnswersStandAfterAllQuestions) {
  const Paper p;
  for (const std::string& text : {handout_markdown(p.lesson, p.figures), handout_html(p.lesson, p.figures)}) {
    const size_t answers = text.find("Answers");
    ASSERT_NE(answers, std::string::npos);
    for (const LessonStep& s : p.lesson.steps) {
      EXPECT_LT(text.find(s.question.substr(0, 20)), answers);
      EXPECT_GT(text.find(s.answer.substr(0, 20)), answers);
      EXPECT_NE(text.find(s.answer.substr(0, 20)), std::string::npos);
    }
  }
}

TEST(Handout, ThePageNeedsNothingElse) {
  const Paper p;
  const std::string html = handout_html(p.lesson, p.figures);
  EXPECT_FALSE(has(html, "<script")) << "no scripts";
  EXPECT_FALSE(has(html, "http")) << "no network";
  EXPECT_TRUE(has(html, "data:image/png;base64,UE5H"));
  EXPECT_FALSE(has(html, "<alt>")) << "escaped";
  EXPECT_TRUE(has(html, "break-before: page"));
}

TEST(Handout, TheScriptSaysWhatToPressAndWhen) {
  const Paper p;
  const std::string script = lecture_script(p.lesson, p.lesson.id);
  EXPECT_TRUE(has(script, "gbufferlab view --lesson three-ways-to-lose-a-light"));
  EXPECT_TRUE(has(script, "`PgDn`"));
  EXPECT_TRUE(has(script, "## 2. At 1:00")) << script.substr(0, 900);
  EXPECT_TRUE(has(script, "`C` Cull: flip")) << "by hand";
}

}  // namespace
}  // namespace gbl
