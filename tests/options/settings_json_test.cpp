#include "renderer/options/settings_json.h"

#include <fstream>
#include <limits>

#include "renderer/base/json.h"
#include "renderer/options/presets.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

void patch(Settings& s, std::string_view json) { apply_patch(s, parse_patch(json, "here"), "here"); }

// Refuses the patch, changes nothing, and gives the line.
std::string refused(const Json& json) {
  const Settings before = preset("start").make();
  Settings s = before;
  const std::string line = error_line(ExitCode::bad_input, [&] { apply_patch(s, read_patch(json, "here"), "here"); });
  EXPECT_TRUE(s == before) << json;
  EXPECT_EQ(line.rfind("here: ", 0), 0u) << line;
  return line;
}

std::string refused(const std::string& path, const Json& value) { return refused(Json{{path, value}}); }

std::string refused_file(const std::string& text) {
  return error_line(ExitCode::bad_input, [&] { from_json(parse_json(text, "file.json"), "file.json"); });
}

TEST(Patch, DottedAndNestedFormsAreOne) {
  Settings dotted, nested, mixed;
  patch(dotted, R"({"lights.volume.level": 3, "lights.cull": "none", "camera.fov": 60})");
  patch(nested, R"({"lights": {"volume": {"level": "3"}, "cull": "none"}, "camera": {"fov": 60}})");
  patch(mixed, R"({"lights": {"volume.level": 3, "cull": "none"}, "camera.fov": 60})");
  EXPECT_EQ(dotted.lights.volume.level, VolumeLevel::l3);
  EXPECT_EQ(dotted.lights.cull, LightCull::none);
  EXPECT_EQ(dotted.camera.fov, 60);
  EXPECT_TRUE(nested == dotted);
  EXPECT_TRUE(mixed == dotted);
  patch(mixed, "{}");
  patch(mixed, R"({"lights": {}})");
  EXPECT_TRUE(mixed == dotted);
}

TEST(Patch, AFailingPartUndoesTheWhole) {
  refused(parse_json(R"({"lights.count": 3, "camera.fov": 60, "lights.cull": "bakc"})", ""));
  refused(parse_json(R"({"lights": {"count": 3, "nonsense": 1}})", ""));
}

TEST(Patch, UnknownNamesAreRefusedWithTheNearest) {
  EXPECT_TRUE(contains(refused("lights.cul", "none"), "here: lights.cul: unknown option; did you mean 'lights.cull'?"));
  EXPECT_TRUE(contains(refused(parse_json(R"({"lights": {"cul": "none"}})", "")), "did you mean 'lights.cull'?"));
  EXPECT_TRUE(contains(refused("lights.cull", "bakc"), "unknown value 'bakc'; did you mean 'back'?"));
  EXPECT_TRUE(contains(refused("view.main", "normals"), "did you mean 'normal'?"));
  EXPECT_TRUE(contains(refused("lights", 3), "here: lights: unknown option"));  // a group is no option
  for (const char* text : {R"({"nonsense": {}})", R"({"": {"exposure": 2}})", R"({"": 2})", R"({"lights.": 2})",
                           R"({"lights": {"volume": 2}})", R"({"camera.position": {"x": 1}})", R"({"version": 1})"})
    refused(parse_json(text, ""));
  for (const char* text : {"[]", "3", "null", "\"lights.count\""}) {
    Settings s;
    EXPECT_THROW(patch(s, text), Error) << text;
  }
}

TEST(Patch, EveryOptionRefusesEveryWrongType) {
  const std::string wrong[] = {"true", "null", "{}", R"({"a": 1})", "[true]", R"(["x", "y"])", "[[1], [2]]"};
  for (const Option& o : options()) {
    for (const std::string& value : wrong)
      EXPECT_TRUE(contains(refused(o.path, parse_json(value, "")), o.path)) << o.path << " " << value;
    const Json not_this = o.kind == Kind::text ? Json(1) : Json("no such id");
    EXPECT_TRUE(contains(refused(o.path, not_this), not_this.is_string() ? "no such id" : "1 is not a text in quotes"));
    const bool whole = o.kind == Kind::choice || o.kind == Kind::integer;
    EXPECT_TRUE(!whole || contains(refused(o.path, 2.5), "2.5 is not "));
    if (o.kind != Kind::vector) continue;
    Json shorter = to_json(o.get(Settings{})), longer = shorter;
    shorter.erase(shorter.size() - 1);
    longer.push_back(1);
    EXPECT_TRUE(contains(refused(o.path, shorter), "is not an array of")) << o.path;
    EXPECT_TRUE(contains(refused(o.path, longer), "is not an array of")) << o.path;
  }
  EXPECT_TRUE(contains(refused("lights.count", 2.5), "2.5 is not a whole number"));
  EXPECT_TRUE(contains(refused("size", Json{640.5, 360}), "640.5 is not a whole number"));
  EXPECT_TRUE(contains(refused("camera.orientation", Json{0, 0, 0, 0}), "length is 0"));
  EXPECT_TRUE(contains(refused("mistakes", Json{"no-such-mistake"}), "mistakes"));
}

TEST(Patch, EveryNumberRefusesWhatIsOutOfRangeOrNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Option& o : options()) {
    if (o.kind != Kind::integer && o.kind != Kind::number && o.kind != Kind::vector) continue;
    const auto with = [&](double x) {
      Json v = to_json(o.get(Settings{}));
      (v.is_array() ? v.back() : v) = x;
      return v;
    };
    const double below = o.kind == Kind::number ? std::nextafter(o.min, -kInfinity) : o.min - 1;
    const double above = o.kind == Kind::number ? std::nextafter(o.max, kInfinity) : o.max + 1;
    for (const double x : {below, above, -1e300, 1e300}) {
      const std::string line = refused(o.path, with(x));
      EXPECT_TRUE(contains(line, o.path) && contains(line, " is not in ")) << line;
    }
    for (const double x : {std::nan(""), kInfinity, -kInfinity})
      EXPECT_TRUE(contains(refused(o.path, with(x)), "is not a finite number")) << o.path;
  }
  EXPECT_TRUE(contains(refused("lights.count", 16385), "lights.count: 16385 is not in 0 ... 16384"));
}

TEST(File, VersionIsAskedForAndNewerOnesAreRefusedWithBothNumbers) {
  const std::string newer = refused_file(R"({"version": 2})");
  EXPECT_TRUE(contains(newer, "file.json: written by a newer program: version 2, this one reads up to 1")) << newer;
  EXPECT_TRUE(contains(newer, "update the program")) << newer;
  EXPECT_TRUE(contains(refused_file(R"({"version": 2, "from the future": 1})"), "newer program"));
  EXPECT_TRUE(contains(refused_file("{}"), "no \"version\""));
  EXPECT_TRUE(contains(refused_file("[1]"), "must be a JSON object"));
  for (const char* version : {"0", "-1", "1.5", "\"1\"", "null", "18446744073709551615"})
    EXPECT_TRUE(contains(refused_file(std::string(R"({"version": )") + version + "}"), "version")) << version;
  EXPECT_TRUE(contains(refused_file(R"({"version": 1, "lights": {"count": -1}})"), "file.json: lights.count: -1"));
  EXPECT_TRUE(contains(refused_file(R"({"version": 1, "ambiant": 1})"), "did you mean 'ambient'?"));
}

// A link holds what differs from the defaults, and nothing else.
TEST(Link, BringsBackWhatItWasMadeOf) {
  EXPECT_EQ(settings_link(Settings{}), R"({"version":1})");
  Settings one;
  one.lights.count = 7;
  EXPECT_EQ(settings_link(one), R"({"version":1,"lights":{"count":7}})");
  for (const Preset& p : presets()) {
    Settings s = p.make();
    s.camera.position = {0.1, -1e-7, 1e6};
    s.mistakes.clear();
    s.view.zoom = 2;
    const std::string link = settings_link(s);
    EXPECT_TRUE(parse_settings(link, "link") == s) << p.id << ": " << link;
    EXPECT_EQ(link.find('\n'), std::string::npos);
    EXPECT_LT(link.size(), settings_text(s).size() / 2) << p.id;
  }
}

TEST(File, BadJsonTellsLineAndColumn) {
  EXPECT_EQ(refused_file("{\n  \"version\" 1\n}").rfind("file.json:2:13: not valid JSON", 0), 0u);
  EXPECT_EQ(refused_file("{\"a\": \"abc\n}\n").rfind("file.json:1:11: ", 0), 0u);  // the line's end itself is bad
  EXPECT_EQ(refused_file("{\n\"a\": 1\n").rfind("file.json:3:1: ", 0), 0u);        // ends too early
  EXPECT_EQ(refused_file("").rfind("file.json:1:1: ", 0), 0u);
  for (const char* text : {"{\"version\": 1, \"exposure\": NaN}", "{\"version\": 1, \"exposure\": Infinity}",
                           "{\"version\": 1, \"scene\": \"\xff\"}", "{\"version\": 1,}"})
    EXPECT_TRUE(contains(refused_file(text), "not valid JSON")) << text;
  EXPECT_TRUE(contains(refused_file("{\"version\": 1, \"exposure\": 1e999}"), "beyond the range of double"));
}

TEST(File, NestingWithoutEndIsRefusedNotACrash) {
  const std::string deep(200000, '[');
  EXPECT_TRUE(contains(refused_file("{\"version\": 1, \"scene\": " + deep + std::string(200000, ']') + "}"), "nested"));
  EXPECT_TRUE(contains(refused_file(deep), "nested"));
  std::string objects;
  for (int i = 0; i < 200000; ++i) objects += "{\"a\":";
  EXPECT_TRUE(contains(refused_file(objects), "nested"));
  Settings s;
  error_line(ExitCode::bad_input, [&] { apply_assignment(s, "exposure=" + deep); });
  EXPECT_TRUE(contains(refused_file("{\"version\": 1, \"scene\": [[[[[[[[1]]]]]]]]}"), "is not a text"));
}

TEST(File, IsReadOrRefusedByName) {
  const TemporaryFolder folder("json");
  std::ofstream(folder / "s.json") << to_json(preset("nclgl-fixed").make()).dump();
  EXPECT_TRUE(from_json(read_json(folder / "s.json"), "s") == preset("nclgl-fixed").make());
  for (const std::string name : {"missing.json", ""}) {  // "": the folder itself
    const std::string line = error_line(ExitCode::bad_input, [&] { read_json(folder / name); });
    EXPECT_TRUE(contains(line, "cannot be read")) << line;
    EXPECT_TRUE(contains(line, folder.path().string())) << line;
  }
}

TEST(Assignment, ValueIsJsonOrElseText) {
  Settings s;
  apply_assignment(s, "lights.cull=none");
  apply_assignment(s, "lights.volume.level=4");
  apply_assignment(s, "normal.encoding=\"xyz8\"");
  apply_assignment(s, "shading.exponent=from-roughness");
  apply_assignment(s, "camera.position=[1, 2, 3.5]");
  apply_assignment(s, "lights.seed=4294967295");
  apply_assignment(s, "lights.rig=a=b.json");
  EXPECT_EQ(s.lights.cull, LightCull::none);
  EXPECT_EQ(s.lights.volume.level, VolumeLevel::l4);
  EXPECT_EQ(s.normal.encoding, NormalEncoding::xyz8);
  EXPECT_EQ(s.shading.exponent, kExponentFromRoughness);
  EXPECT_EQ(s.camera.position, glm::dvec3(1, 2, 3.5));
  EXPECT_EQ(s.lights.seed, 4294967295u);
  EXPECT_EQ(s.lights.rig, "a=b.json");
  apply_assignment(s, "lights.rig=\"\"");
  apply_assignment(s, "shading.exponent=33");
  EXPECT_EQ(s.lights.rig, "");
  EXPECT_EQ(s.shading.exponent, 33);
}

TEST(Assignment, BadOnesNameTheirPathAndChangeNothing) {
  const Settings before;
  Settings s;
  for (const char* bad : {"",
                          "lights.count",
                          "=3",
                          "lights.count=",
                          "lights.count=three",
                          "lights.count=1e999",
                          "lights.count=-1",
                          "lights.count=2.5",
                          "lights.seed=-1",
                          "lights.seed=4294967296",
                          "lights=3",
                          "camera={\"fov\": 60}",
                          "exposure=\xff",
                          "lights.rig=\xff",
                          "lights.cull=\xff",
                          "\xff=1",
                          "lights.cull=Back",
                          "version=1",
                          "shading.exponent=-1",
                          "lights.only=true"}) {
    const std::string line = error_line(ExitCode::bad_input, [&] { apply_assignment(s, bad); });
    EXPECT_FALSE(line.empty()) << bad;
    EXPECT_TRUE(s == before) << bad;
  }
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [&] { apply_assignment(s, "exposure"); }), "write path=value"));
}

}  // namespace
}  // namespace gbl
