#include "renderer/pitfalls/mistakes.h"

#include <set>

#include "renderer/options/options.h"
#include "renderer/options/presets.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

TEST(Mistakes, HaveIdsHelpAndSources) {
  std::set<std::string> ids;
  for (const MistakeRow& m : mistakes()) {
    EXPECT_TRUE(ids.insert(m.id).second) << m.id;
    EXPECT_GT(std::string(m.help).size(), 20u) << m.id;
    EXPECT_GT(std::string(m.source).size(), 10u) << m.id;
    EXPECT_EQ(mistake_by_id(m.id), m.mistake);
    EXPECT_EQ(&row(m.mistake), &m);
  }
}

TEST(Mistakes, AreSetByIdAndUnknownOnesAreRefused) {
  Settings s;
  const Option& o = option("mistakes");
  o.set(s, OptionList{"tbn-precedence", "specular-ungated"}, o);
  EXPECT_EQ(s.mistakes, (std::set<Mistake>{Mistake::tbn_precedence, Mistake::specular_ungated}));
  EXPECT_FALSE(sound(s));
  const std::string line = error_line(ExitCode::bad_input, [&] { o.set(s, OptionList{"tbn-precedense"}, o); });
  EXPECT_TRUE(contains(line, "did you mean 'tbn-precedence'")) << line;
  EXPECT_THROW(o.set(s, OptionList{3}, o), std::runtime_error);
}

TEST(Mistakes, NoFixedPresetMakesOne) {
  for (const Preset& p : presets()) {
    const bool fixed = std::string(p.id).ends_with("-fixed");
    EXPECT_TRUE(!fixed || sound(p.make())) << p.id;
  }
}

}  // namespace
}  // namespace gbl
