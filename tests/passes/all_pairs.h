#pragma once
// Few settings in which each value of each axis meets each value of every other: generated from the options table, so
// new rows join by themselves.
#include <set>

#include "renderer/base/random.h"
#include "renderer/frame/resolve.h"
#include "renderer/frame/validate.h"
#include "renderer/options/options.h"
#include "tests/gl_fixture.h"

namespace gbl::test {

struct Choice {
  const Option* option;
  const ValueRow* value;
};
using Axis = std::vector<Choice>;

inline DeviceLimits limits_here() {
  return {gl::device().features, gl::device().max_size, gl::device().max_draw_buffers};
}

// Every value that this device can draw, of every axis that a frame of a given scene depends on.
inline std::vector<Axis> all_axes() {
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

inline Settings settings_of(const std::vector<Choice>& choices, glm::ivec2 size = {160, 90}) {
  Settings s = settings_for(yard(), size);
  s.lights.count = 16;
  s.lights.cull = LightCull::front;
  s.shadow.max_lights = 1;  // a point light's six maps: more say no more
  for (const Choice& c : choices) c.option->set(s, c.value->id, *c.option);
  return s;
}

// Can the two values stand together in some settings, both with an effect? Another choice may have to give way.
class AllPairs {
 public:
  AllPairs() {
    for (size_t a = 0; a < axes_.size(); ++a)
      for (size_t b = a + 1; b < axes_.size(); ++b)
        for (const Choice& x : axes_[a])
          for (const Choice& y : axes_[b])
            if (!completed({x, y}).empty()) open_.insert({x.value, y.value});
    all_ = open_.size();
  }
  size_t all() const { return all_; }
  size_t open() const { return open_.size(); }

  Settings next() {
    std::vector<Choice> chosen;
    for (const Axis& axis : axes_)
      for (const Choice& c : axis)
        if (c.value == open_.begin()->first || c.value == open_.begin()->second) chosen.push_back(c);
    chosen = completed(chosen);
    for (const Axis& axis : axes_)
      if (!names(chosen, axis)) take_best(axis, chosen);
    Settings s = settings_of(chosen);
    EXPECT_TRUE(validate(s, limits_here()).empty());
    for (const Choice& x : chosen)
      for (const Choice& y : chosen)
        if (in_use(*x.option, s) && in_use(*y.option, s)) open_.erase({x.value, y.value});
    return s;
  }

 private:
  static bool works(const std::vector<Choice>& chosen, size_t wanted) {
    const Settings s = settings_of(chosen);
    for (size_t i = 0; i < wanted; ++i)
      if (!in_use(*chosen[i].option, s)) return false;
    return validate(s, limits_here()).empty();
  }
  static bool names(const std::vector<Choice>& chosen, const Axis& axis) {
    for (const Choice& c : chosen)
      if (c.option == axis[0].option) return true;
    return false;
  }
  // The choices, with one or two more if they need them to be possible and in use; empty if nothing helps.
  std::vector<Choice> completed(const std::vector<Choice>& chosen) const {
    if (works(chosen, chosen.size())) return chosen;
    for (const Axis& axis : axes_) {
      if (names(chosen, axis)) continue;
      for (const Choice& c : axis) {
        std::vector<Choice> with = chosen;
        with.push_back(c);
        if (works(with, chosen.size())) return with;
        for (const Axis& second : helpers_) {
          if (names(with, second)) continue;
          for (const Choice& d : second) {
            with.push_back(d);
            if (works(with, chosen.size())) return with;
            with.pop_back();
          }
        }
      }
    }
    return {};
  }
  // A value must not put the others out of use; of equal gains, the one that leaves most options in use.
  void take_best(const Axis& axis, std::vector<Choice>& chosen) const {
    const Choice* found = nullptr;
    int best_gain = -1;
    for (const Choice& c : axis) {
      std::vector<Choice> with = chosen;
      with.push_back(c);
      if (!works(with, 2)) continue;
      const Settings s = settings_of(with);
      int gain = 0;
      for (const Choice& x : chosen)
        if (in_use(*x.option, s) && in_use(*c.option, s))
          gain += 100 * int(open_.count({x.value, c.value}) + open_.count({c.value, x.value}));
      for (const Axis& other : axes_) gain += in_use(*other[0].option, s);
      if (gain > best_gain) found = &c, best_gain = gain;
    }
    if (found) chosen.push_back(*found);
  }

  static std::vector<Axis> helper_axes() {
    std::vector<Axis> out;
    for (const Axis& a : all_axes())
      for (const std::string_view path : {"lights.method", "layout", "lights.cull", "accumulation.targets"})
        if (path == a[0].option->path) out.push_back(a);
    return out;
  }
  std::vector<Axis> axes_ = all_axes(), helpers_ = helper_axes();
  std::set<std::pair<const ValueRow*, const ValueRow*>> open_;
  size_t all_ = 0;
};

// A random value for every choice, seeded; only what can be drawn.
inline Settings random_choices(Pcg32& random, glm::ivec2 size = {160, 90}) {
  for (;;) {
    std::vector<Choice> chosen;
    for (const Axis& axis : all_axes()) chosen.push_back(axis[random.next() % axis.size()]);
    Settings s = settings_of(chosen, size);
    if (validate(s, limits_here()).empty()) return s;
  }
}

// ---- sound settings with the same truth and the same stored bits give one picture ------------------------------

// What the full-screen loop makes of the same stored bits: the picture that all sound settings share.
inline Settings plain_twin(const Settings& settings) {
  Settings s = settings;
  const Shading shading = shading_of(s.lights.method);
  s.lights.method = LightMethod::fullscreen;
  s.accumulation.targets = AccumulationTargets::split;
  s.background.skip = BackgroundSkip::depth;
  s.draw_order = DrawOrder::near_far;
  if (shading == Shading::forward) {  // it stores nothing: compared where nothing is lost
    s.layout = Layout::float32;
    s.normal = {NormalEncoding::xyz32f, NormalSpace::world};
    s.position.source = PositionSource::view32f;
  }
  return s;
}

// Settings to compare: light is summed in float; what stores less than a G-buffer does so without loss.
inline Settings comparable(Settings s) {
  s.accumulation.format = AccumulationFormat::rgba32f;
  if (shading_of(s.lights.method) == Shading::light_prepass) {
    s.layout = Layout::float32;
    s.normal = {NormalEncoding::xyz32f, NormalSpace::world};
    s.position.source = PositionSource::view32f;
  }
  return s;
}

// Equal terms summed in another order: each of at most 64 is rounded to 2^-24 of the largest sum. Forward shading also
// interpolates what the others store, and where two surfaces have the very same depth its passes may take either.
inline Tolerance same_picture(const Settings& s) {
  const bool stray =
      s.position.source == PositionSource::world16f || s.position.source == PositionSource::view16f ||
      s.position.source == PositionSource::view_scaled ||
      (s.position.source == PositionSource::depth && s.position.reconstruct != PositionReconstruct::view_ray);
  if (shading_of(s.lights.method) == Shading::deferred && stray)
    return {.max_abs = 4e-6,
            .failing_fraction = 0.02,
            .why =
                "these positions stray from their pixel: at a light's rim, methods that look at pixels and methods "
                "that look at positions leave out different ones"};
  if (shading_of(s.lights.method) == Shading::deferred) return {.max_abs = 4e-6, .why = "float sums in another order"};
  return {.max_abs = 1e-4, .failing_fraction = 2e-4, .why = "no bits are stored between; two surfaces at one depth"};
}

}  // namespace gbl::test
