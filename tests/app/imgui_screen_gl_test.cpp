#include "app/imgui_screen.h"

#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Screens : public GlTest {};

// The cache of programs deletes the oldest, and that may be the one drawn with last.
TEST_F(Screens, AProgramThatWasDeletedIsNotAskedFor) {
  ImguiScreen screen;
  {
    Stage stage(yard());
    stage.draw(settings_for(yard(), {16, 9}));
  }  // its programs are gone; the last one stays current until another one is used
  GLint current = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &current);
  ASSERT_NE(current, 0);
  screen.picture({64, 36}, [] { ui::draw_start("a line"); });
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace
}  // namespace gbl::test
