#include <gtest/gtest.h>

#include "renderer/options/options.h"
#include "renderer/options/presets.h"

namespace gbl {
namespace {

TEST(Cured, LeavesNothingUnsoundAndChangesNothingElse) {
  for (const Preset& p : presets()) {
    const Settings s = p.make(), c = cured(s);
    EXPECT_TRUE(sound(c)) << p.id;
    for (const Option& o : options()) {
      bool unsound = false;
      for (const Unsound& u : unsound_choices(s)) unsound |= u.path == o.path;
      EXPECT_EQ(o.get(c) == o.get(s), !unsound) << p.id << ": " << o.path;
    }
  }
}

TEST(Cured, EveryUnsoundValueAndEveryMistakeHasACure) {
  for (const Option& o : options()) {
    if (o.kind != Kind::choice || o.group != Group::method) continue;
    for (const ValueRow& r : o.values) {
      Settings s;
      o.set(s, OptionValue(std::string(r.id)), o);
      EXPECT_TRUE(sound(cured(s))) << o.path << "=" << r.id;
    }
  }
  Settings s;
  for (const MistakeRow& m : mistakes()) s.mistakes.insert(m.mistake);
  EXPECT_TRUE(cured(s).mistakes.empty());
  EXPECT_EQ(cured(Settings{}), Settings{});
}

}  // namespace
}  // namespace gbl
