#include "renderer/options/settings.h"

#include <algorithm>

#include "renderer/base/json.h"
#include "renderer/base/random.h"
#include "renderer/inspect/views.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/image.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

double random_number(const Option& o, Pcg32& random) {
  switch (random.next() % 4) {
    case 0: return o.min;
    case 1: return o.max;
    case 2: return std::clamp(random.in(-1, 1), o.min, o.max);  // all bits of the mantissa in use
    default: return random.in(o.min, o.max);
  }
}

// Any value that this option takes, from the table alone.
OptionValue random_value(const Option& o, Pcg32& random) {
  const OptionValue now = o.get(Settings{});
  switch (o.kind) {
    case Kind::choice: return o.values[random.next() % o.values.size()].id;
    case Kind::integer: return std::floor(random_number(o, random));
    case Kind::number: return random_number(o, random);
    case Kind::set: return OptionList();
    case Kind::vector: {
      OptionList v;
      for (const OptionValue& part : std::get<OptionList>(now)) {
        const double x = random_number(o, random);
        v.emplace_back(std::get<Number>(part).whole ? std::floor(x) : x);
      }
      if (std::string(o.path) == "camera.orientation") v[random.next() % 4].emplace<Number>(0.5);  // not all 0
      return v;
    }
    case Kind::text: break;
  }
  if (std::string(o.path) == "view.main") return views()[random.next() % views().size()].id;
  if (std::string(o.path) == "layout-file") {  // a name with its content's hash: the file is not looked at yet
    constexpr const char* kNames[] = {"", "a \"quoted\" \\ name@0123456789abcdef", "caf\u00e9.glsl@fedcba9876543210"};
    return kNames[random.next() % std::size(kNames)];
  }
  constexpr const char* kTexts[] = {"", "builtin:terrain", "a \"quoted\" \\ name", "caf\u00e9/\u6c34.gltf",
                                    "{\"x\": 1}"};
  return kTexts[random.next() % std::size(kTexts)];
}

Settings random_settings(Pcg32& random) {
  Settings s;
  for (const Option& o : options()) o.set(s, random_value(o, random), o);
  return s;
}

std::string text_of(const Settings& s) { return to_json(s).dump(1); }  // shortest digits that read back to the bit

TEST(Settings, EveryPresetRoundTripsThroughJson) {
  for (const Preset& p : presets()) {
    const Settings s = p.make();
    const Settings again = from_json(parse_json(text_of(s), p.id), p.id);
    EXPECT_TRUE(again == s) << p.id;
    EXPECT_EQ(text_of(again), text_of(s)) << p.id;  // to the bit: == takes -0 for 0
  }
}

TEST(Settings, FiveHundredRandomSettingsRoundTripToTheBit) {
  Pcg32 random(1);
  for (int i = 0; i < 500; ++i) {
    const Settings s = random_settings(random);
    const std::string text = text_of(s);
    const Settings again = from_json(parse_json(text, "random"), "random");
    ASSERT_TRUE(again == s) << i << "\n" << text;
    ASSERT_EQ(text_of(again), text) << i;
  }
}

TEST(Settings, RoundTripThroughThePictureTheyMade) {
  const TemporaryFolder folder("settings");
  const auto file = folder / "picture.png";
  Pcg32 random(2);
  for (int i = 0; i < 20; ++i) {
    const Settings s = random_settings(random);
    write_png(file, {{1, 1}, {1, 2, 3, 255}}, {{kSettingsKey, to_json(s).dump()}});
    const Settings again = from_json(parse_json(read_png_text(file, kSettingsKey), "picture"), "picture");
    EXPECT_EQ(text_of(again), text_of(s)) << i;
  }
}

TEST(Settings, VersionAloneGivesTheBase) {
  const Json only_version{{"version", 1}};
  EXPECT_TRUE(from_json(only_version, "here") == Settings{});
  const Settings base = preset("nclgl-fixed").make();
  EXPECT_TRUE(from_json(only_version, "here", base) == base);
  Settings expected = base;
  expected.lights.count = 3;
  EXPECT_TRUE(from_json(Json{{"version", 1}, {"lights", {{"count", 3}}}}, "here", base) == expected);
}

TEST(Options, EveryChoiceTakesEachOfItsValuesAndOnlyItsOwnMemberChanges) {
  for (const Option& o : options())
    for (const ValueRow& r : o.values) {
      const Settings before = preset("start").make();
      Settings s = before;
      o.set(s, r.id, o);
      EXPECT_TRUE(o.get(s) == OptionValue(r.id)) << o.path;
      EXPECT_EQ(chosen(o, s), r.value) << o.path;
      for (const Option& other : options())
        EXPECT_TRUE(&other == &o || other.get(s) == other.get(before)) << o.path << " changed " << other.path;
    }
}

TEST(Options, EveryRangeTakesBothEndsAndItsDefaultReadsBack) {
  for (const Option& o : options()) {
    Settings s;
    const OptionValue now = o.get(s);
    o.set(s, now, o);
    EXPECT_TRUE(o.get(s) == now) << o.path;
    EXPECT_TRUE(s == Settings{}) << o.path;
    if (o.kind != Kind::integer && o.kind != Kind::number) continue;
    const double middle = (o.min + o.max) / 2;
    for (const double x : {o.min, o.max, o.kind == Kind::integer ? std::floor(middle) : middle}) {
      o.set(s, x, o);
      EXPECT_EQ(std::get<Number>(o.get(s)).value, x) << o.path;
    }
  }
}

TEST(Options, ANumberChangesItsOwnMemberOnly) {
  Pcg32 random(3);
  for (const Option& o : options()) {
    if (o.kind == Kind::choice || o.kind == Kind::set) continue;
    const Settings before;
    Settings s;
    for (int i = 0; i < 50 && o.get(s) == o.get(before); ++i) o.set(s, random_value(o, random), o);
    EXPECT_TRUE(o.get(s) != o.get(before)) << o.path;
    for (const Option& other : options())
      EXPECT_TRUE(&other == &o || other.get(s) == other.get(before)) << o.path << " changed " << other.path;
  }
}

TEST(Options, CycleVisitsAllRowsForwardsAndBackwards) {
  FeatureSet all;
  for (const FeatureRow& f : kFeatures) all.add(f.feature);
  for (const Option& o : options()) {
    if (o.kind != Kind::choice) continue;
    Settings s = preset("start").make();
    const int start = chosen(o, s), n = static_cast<int>(o.values.size());
    for (int i = 1; i <= n; ++i) {
      cycle(o, s, 1, all);
      EXPECT_EQ(chosen(o, s), (start + i) % n) << o.path;
    }
    for (int i = 1; i <= n; ++i) {
      cycle(o, s, -1, all);
      EXPECT_EQ(chosen(o, s), (start - i + n) % n) << o.path;
    }
    for (int i = 0; i < n; ++i) {
      cycle(o, s, 1, FeatureSet{});
      EXPECT_EQ(o.values[chosen(o, s)].needs, Feature::none) << o.path;
    }
  }
}

TEST(Settings, SameTruthIsBlindToMethodAndViewOnly) {
  Pcg32 random(4);
  const Settings a = preset("start").make();
  for (const Option& o : options()) {
    Settings b = a;
    for (int i = 0; i < 50 && o.get(b) == o.get(a); ++i) o.set(b, random_value(o, random), o);
    const bool differs = o.get(b) != o.get(a);
    EXPECT_EQ(differs, o.values.size() != 1 && o.kind != Kind::set) << o.path;  // nothing else to set there
    EXPECT_EQ(same_truth(a, b), o.group != Group::truth || !differs) << o.path;
    EXPECT_EQ(same_truth(b, a), same_truth(a, b)) << o.path;
  }
}

TEST(Settings, UnsoundChoicesAreThoseOfTheRowsInUse) {
  for (const Option& o : options())
    for (const ValueRow& r : o.values) {
      Settings s;
      s.height_map = HeightMap::on;  // else no choice of parallax is in use
      ASSERT_TRUE(sound(s));
      o.set(s, r.id, o);
      const std::vector<Unsound> found = unsound_choices(s);
      ASSERT_EQ(found.size(), r.sound() ? 0u : 1u) << o.path << "=" << r.id;
      EXPECT_EQ(sound(s), r.sound());
      if (r.sound()) continue;
      EXPECT_EQ(found[0].path, o.path);
      EXPECT_EQ(found[0].value, r.id);
      EXPECT_EQ(found[0].pitfall, id_of(r.pitfall));
    }
}

TEST(Settings, UnsoundChoicesOfPresetsAndOfAMethodWithoutVolumes) {
  Settings s = preset("start").make();
  ASSERT_EQ(unsound_choices(s).size(), 2u);
  EXPECT_EQ(unsound_choices(s)[0].path, "lights.cull");
  EXPECT_EQ(unsound_choices(s)[1].path, "lights.volume.clip");
  EXPECT_TRUE(sound(preset("nclgl-fixed").make()));
  s.lights.method = LightMethod::fullscreen;  // draws no volume: what they do wrong is not seen
  EXPECT_TRUE(sound(s));
  s.mistakes = {Mistake::specular_ungated};
  ASSERT_EQ(unsound_choices(s).size(), 1u);
  EXPECT_EQ(unsound_choices(s)[0].pitfall, "specular-ungated");
}

TEST(Presets, AreFoundByIdAndBySettings) {
  for (const Preset& p : presets()) {
    EXPECT_EQ(&preset(p.id), &p);
    Settings s = p.make();
    EXPECT_EQ(preset_of(s), &p);
    s.size = {64, 64};
    s.time_s = 5;
    s.view.main = "depth";
    EXPECT_EQ(preset_of(s), &p) << "size, time and view are not part of a preset";
    s.ambient += 1;
    EXPECT_EQ(preset_of(s), nullptr);
  }
  const std::string line = error_line(ExitCode::bad_input, [] { preset("strat"); });
  EXPECT_TRUE(contains(line, "did you mean 'start'?")) << line;
}

}  // namespace
}  // namespace gbl
