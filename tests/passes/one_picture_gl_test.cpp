// Sound settings with the same truth and the same stored bits give one picture, whatever the method: over a generated
// list in which every value of every axis meets every value of every other, and over method x layout and method x
// normal in full.
#include "renderer/options/settings_json.h"
#include "tests/passes/all_pairs.h"

namespace gbl::test {
namespace {

class OnePicture : public GlTest {};

Picture lit_of(const Settings& s) { return shared_stage(yard()).lit(s); }

// The twin's picture; many settings share one.
const Picture& twin_of(const Settings& s) {
  static std::map<std::string, Picture> pictures;
  const Settings twin = plain_twin(s);
  auto [at, fresh] = pictures.try_emplace(settings_text(twin));
  if (fresh) at->second = lit_of(twin);
  return at->second;
}

TEST_F(OnePicture, EveryPairOfValuesOfAnyTwoAxes) {
  AllPairs pairs;
  EXPECT_GT(pairs.all(), 3000u);
  int drawn = 0, compared = 0;
  for (; pairs.open() > 0; ++drawn) {
    const Settings s = pairs.next();
    SCOPED_TRACE(settings_text(s));
    const Picture as_chosen = lit_of(s);
    ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    if (!sound(s)) continue;
    EXPECT_EQ(nonfinite(as_chosen), 0u);
    const Settings judged = comparable(s);
    EXPECT_TRUE(like(lit_of(judged), twin_of(judged), same_picture(judged)));
    ++compared;
  }
  RecordProperty("drawn", drawn);
  RecordProperty("compared", compared);
  EXPECT_LE(drawn, 400) << "for " << pairs.all() << " pairs";
}

// With every other axis at a sound value: unsound ones have proofs of their own.
template <class E>
void expect_one_picture_with_each_method(void (*set)(Settings&, E)) {
  for_each_row<LightMethod>([&](LightMethod method, auto& m) {
    for_each_row<E>([&](E value, auto& v) {
      Settings s = settings_of({});
      s.lights.method = method;
      set(s, value);
      if (!sound(s) || !validate(s, limits_here()).empty()) return;
      s = comparable(s);
      EXPECT_TRUE(like(lit_of(s), twin_of(s), same_picture(s))) << m.id << " with " << v.id;
    });
  });
}

TEST_F(OnePicture, EveryMethodWithEveryLayout) {
  expect_one_picture_with_each_method<Layout>([](Settings& s, Layout l) { s.layout = l; });
}

TEST_F(OnePicture, EveryMethodWithEveryNormal) {
  expect_one_picture_with_each_method<NormalEncoding>([](Settings& s, NormalEncoding e) { s.normal.encoding = e; });
}

}  // namespace
}  // namespace gbl::test
