// Every variant of the programs compiles: every value of every axis beside every value of every other.
#include <algorithm>
#include <set>

#include "renderer/options.h"
#include "renderer/passes/programs.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class ShaderVariants : public GlTest {};

struct Choice {
  const Option* option;
  const ValueRow* value;
};
using Axis = std::vector<Choice>;

// Every value that this device can draw, of every axis that a program may depend on. New rows join by themselves.
std::vector<Axis> all_axes() {
  std::vector<Axis> out;
  for (const Option& o : options()) {
    if (o.kind != Kind::choice || o.group == Group::view || o.path == std::string_view("lights.source")) continue;
    Axis axis;
    for (const ValueRow& r : o.values)
      if (gl::device().features.has(r.needs)) axis.push_back({&o, &r});
    if (axis.size() > 1) out.push_back(axis);
  }
  return out;
}

Settings settings_of(const std::vector<Choice>& choices) {
  Settings s = settings_for(yard(), {8, 4});
  s.lights.count = 4;
  for (const Choice& c : choices) c.option->set(s, c.value->id, *c.option);
  return s;
}

// Few settings in which each value meets each value of every other axis: greedily, the value that meets most new ones.
class AllPairs {
 public:
  AllPairs() {
    for (size_t a = 0; a < axes_.size(); ++a)
      for (size_t b = a + 1; b < axes_.size(); ++b)
        for (const Choice& x : axes_[a])
          for (const Choice& y : axes_[b])
            if (means_something(settings_of({x, y}), x, y)) open_.insert({x.value, y.value});
  }
  size_t open() const { return open_.size(); }
  // No fewer settings can do: every value of the longest axis meets every value of the next.
  size_t fewest() const {
    std::vector<size_t> sizes;
    for (const Axis& axis : axes_) sizes.push_back(axis.size());
    std::sort(sizes.rbegin(), sizes.rend());
    return sizes[0] * sizes[1];
  }

  Settings next() {
    std::vector<Choice> chosen;
    for (const Axis& axis : axes_)
      for (const Choice& c : axis)
        if (c.value == open_.begin()->first || c.value == open_.begin()->second) chosen.push_back(c);
    for (const Axis& axis : axes_)
      if (axis[0].option != chosen[0].option && axis[0].option != chosen[1].option)
        chosen.push_back(best(axis, chosen));
    const Settings s = settings_of(chosen);
    EXPECT_TRUE(means_something(s, chosen[0], chosen[1]));
    for (const Choice& x : chosen)
      for (const Choice& y : chosen)
        if (means_something(s, x, y)) open_.erase({x.value, y.value});
    return s;
  }

 private:
  static bool means_something(const Settings& s, const Choice& x, const Choice& y) {
    return in_use(*x.option, s) && in_use(*y.option, s);
  }
  // A value must not put the first two out of use; of equal gains, the one that leaves most options in use.
  Choice best(const Axis& axis, const std::vector<Choice>& chosen) const {
    Choice found = axis[0];
    int best_gain = -1;
    for (const Choice& c : axis) {
      std::vector<Choice> with = chosen;
      with.push_back(c);
      const Settings s = settings_of(with);
      int gain = 0;
      for (const Choice& x : chosen)
        if (means_something(s, x, c))
          gain += 100 * int(open_.count({x.value, c.value}) + open_.count({c.value, x.value}));
      for (const Axis& other : axes_) gain += in_use(*other[0].option, s);
      if (means_something(s, chosen[0], chosen[1]) && gain > best_gain) found = c, best_gain = gain;
    }
    return found;
  }
  std::vector<Axis> axes_ = all_axes();
  std::set<std::pair<const ValueRow*, const ValueRow*>> open_;
};

TEST_F(ShaderVariants, EveryPairOfValuesCompilesAndDraws) {
  AllPairs pairs;
  const size_t all = pairs.open();
  EXPECT_GT(all, 300u);
  Stage stage(yard());
  size_t drawn = 0;
  for (; pairs.open() > 0; ++drawn) {
    const Settings s = pairs.next();
    ASSERT_NO_THROW(stage.draw(s));
    ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  }
  EXPECT_LT(drawn, pairs.fewest() * 3 / 2) << "for " << all << " pairs";
}

// Compiled without a draw: a driver may take ten times as long to make machine code of a program at its first draw.
TEST_F(ShaderVariants, EveryViewCompilesForEveryValue) {
  ProgramCache programs;
  for (const Axis& axis : all_axes())
    for (const Choice& c : axis) {
      const Settings s = settings_of({c});
      for (const ViewRow& v : views())
        for (const int raw : {0, 1}) {
          gl::Defines defines = gbuffer_defines(s);
          defines.push_back({"SPLIT", s.accumulation.targets == AccumulationTargets::split});
          defines.push_back({"VIEW", static_cast<int>(v.view)});
          defines.push_back({"RAW", raw});
          ASSERT_NO_THROW(programs.get("fullscreen.vert", "views.frag", defines)) << v.id << " " << c.value->id;
        }
    }
  EXPECT_GE(programs.size(), 100u);
}

}  // namespace
}  // namespace gbl::test
