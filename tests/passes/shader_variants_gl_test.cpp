// Every variant of the views' programs compiles; what is drawn is covered by one_picture_gl_test.
#include "renderer/passes/frame_block.h"
#include "renderer/passes/programs.h"
#include "tests/passes/all_pairs.h"

namespace gbl::test {
namespace {

class ShaderVariants : public GlTest {};

// Compiled without a draw: a driver may take ten times as long to make machine code of a program at its first draw.
TEST_F(ShaderVariants, EveryViewCompilesForEveryValue) {
  ProgramCache programs;
  for (const Axis& axis : all_axes())
    for (const Choice& c : axis) {
      const ResolvedFrame f = resolve_frame(settings_of({c}, {8, 4}), yard().scene(), gl::device().features);
      for (const View v : frame_views())
        for (const int as : {VIEW_AS_SHOWN, VIEW_AS_STORED, VIEW_AS_NUMBERS, VIEW_AS_LOOK}) {
          gl::Defines defines = gbuffer_defines(f);
          defines.push_back({"SPLIT", f.split});
          defines.push_back({"VIEW_FILE", shader_of(v)});
          defines.push_back({"VIEW_AS", as});
          defines.push_back({"BACKGROUND_TOO", row(v).values.background});
          defines.push_back({"LOOK_STOPS", as == VIEW_AS_LOOK ? 2 : 0});
          defines.push_back({"LOOK_CODED", 0});
          ASSERT_NO_THROW(programs.get("fullscreen.vert", "views.frag", defines)) << row(v).id << " " << c.value->id;
        }
    }
  EXPECT_GE(programs.size(), 100u);
}

}  // namespace
}  // namespace gbl::test
