// The look `raw`: the stored codes, undecoded.
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class RawLook : public GlTest {};

TEST_F(RawLook, IsWhatRenderWritesWithRawAndOfItsViewAlone) {
  Stage& stage = shared_stage(yard());
  const Settings plain = settings_for(yard(), {64, 36});
  stage.draw(plain);
  int differ = 0;
  for (const View v : frame_views()) {
    if (!why_missing(v, plain).empty()) continue;
    Settings s = plain;
    ViewLook look;
    look.raw = true;
    set_look(s.view.looks, row(v).id, look);
    const Image raw = stage.view(v, s);
    EXPECT_TRUE(raw == stage.view(v, plain, {.raw = true})) << row(v).id;
    differ += !(raw == stage.view(v, plain));
    const View other = v == View::final ? View::normal : View::final;
    EXPECT_TRUE(stage.view(other, s) == stage.view(other, plain)) << row(v).id;
  }
  EXPECT_GE(differ, 5);
}

}  // namespace
}  // namespace gbl::test
