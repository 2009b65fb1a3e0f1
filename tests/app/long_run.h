#pragma once
// A lab that is used for a long time, without a window: cycles that visit everything in a random order and then go back
// to where they began.
#include <chrono>
#include <map>
#include <thread>

#include "app/layers_exr.h"
#include "app/picture_texts.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/pitfalls/catalogue.h"
#include "renderer/study/study_here.h"
#include "tests/app/deck.h"
#include "tests/app/viewer_fixture.h"
#include "tests/gltf/gltf_fixture.h"
#include "tests/shader_copy.h"
#include "tests/test_support.h"

namespace gbl::test {

class LongRun {
 public:
  explicit LongRun(uint64_t seed) : random_(seed) {
    start_.size = {160, 90};
    for (const char* name : {"textured.glb", "lit.glb", "material.gltf"})
      for (const Seed& model : seeds())
        if (model.name == name) scenes_.push_back(models_.write(name, model.bytes).string());
    for (const Option& o : options())
      if (o.kind == Kind::choice && o.path != std::string_view("lights.source")) values_.emplace(&o, cards_of(o));
    lab_.open(start_.scene);
    play(start_, showing({View::final}));
    save_picture(start_, {});
    save_layers(start_, {});
    use_what_is_made_once("builtin:terrain", LightSource::generated);  // points
    use_what_is_made_once("builtin:room", LightSource::generated);
    use_what_is_made_once("builtin:room", LightSource::scene);  // and a spot
  }

  // Every scene once in an order of its own, and something in each; then back.
  void cycle() {
    Deck<std::string> scenes(scenes_);
    for (size_t k = 0; k < scenes_.size(); ++k) visit(scenes.deal(random_));
    go_back();
  }

  // As at first: the same programs kept, the same settings, the same views, the same truth, and nothing measured.
  void go_back() {
    compile_the_same();
    Settings elsewhere = start_;
    elsewhere.size = {64, 36};  // what has the picture's size is made anew
    play(elsewhere, showing({View::final}));
    ui::Requests r = at_rest();
    r.reload_shaders = true;
    play(start_, r);
    settle(start_, at_rest());
  }
  std::map<View, Image> pictures() {
    std::map<View, Image> out;
    for (const View v : kShownAtRest) out.emplace(v, lab_.image_of(v));
    return out;
  }

  std::string said() const { return viewer_.input(0).message + viewer_.input(0).banner; }

  // What has not been dealt yet; empty: all of it has.
  std::string left_out() const {
    std::string out;
    const auto add = [&](int rounds, std::string_view what) {
      if (rounds == 0) out += fmt::format(" {}", what);
    };
    for (const auto& [option, deck] : values_) add(deck.rounds(), option->path);
    add(presets_.rounds(), "presets"), add(mistakes_.rounds(), "mistakes"), add(views_.rounds(), "views");
    add(counts_.rounds(), "counts"), add(sizes_.rounds(), "sizes"), add(acts_.rounds(), "acts");
    add(overlays_.rounds(), "overlays");
    return out;
  }
  int compiled() { return lab_.renderer().programs_compiled(); }
  int drawn() const { return drawn_; }      // settings
  int refused() const { return refused_; }  // on purpose

 private:
  static constexpr size_t kPresetsThatFillTheCache = 8;
  static constexpr View kShownAtRest[] = {View::final, View::normal, View::lights_per_pixel, View::error};
  static ui::Requests at_rest() {
    ui::Requests r;
    for (const View v : kShownAtRest) r.visible[static_cast<size_t>(v)] = true;
    return r;
  }
  static std::vector<const ValueRow*> cards_of(const Option& o) {
    std::vector<const ValueRow*> out;
    for (const ValueRow& r : o.values)
      if (gl::device().features.has(r.needs)) out.push_back(&r);
    return out;
  }
  // More programs than are kept, so that none of those before is.
  void compile_the_same() {
    ui::Requests all;
    all.visible.fill(true);
    for (const Preset& p : presets().first(kPresetsThatFillTheCache)) {
      Settings s = p.make();
      s.scene = start_.scene, s.camera = start_.camera, s.size = {64, 36};
      play(s, all, 0);
    }
  }
  bool chance(double p) { return random_.unit() < p; }

  // ---- frames, as the window's loop asks for them ----

  void frame(const Settings& s, const ui::Requests& r, bool moving = false) {
    viewer_.update(s, r, moving);
    viewer_.measure(s, r, !moving);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << settings_text(s);
    viewer_.input(0);
  }
  // Until there is no more to come, or this much time has passed: what is measured beside the picture takes its time.
  void play(const Settings& s, ui::Requests r, double most_s = 0.3) {
    frame(s, r);
    viewer_.finish_loading();
    r.reload_shaders = r.chart.run = r.stability.run = r.advisor.run = false;
    const auto begin = std::chrono::steady_clock::now();
    do {
      std::this_thread::sleep_for(std::chrono::microseconds(200));  // the reference is worked out on other threads
      frame(s, r);
    } while (viewer_.busy() && std::chrono::steady_clock::now() - begin < std::chrono::duration<double>(most_s));
  }
  // Until nothing is under way any more, the compiling of what all presets need among it.
  void settle(const Settings& s, const ui::Requests& r) {
    play(s, r, 120);
    EXPECT_FALSE(viewer_.busy());
    EXPECT_FALSE(viewer_.input(0).message_is_error) << viewer_.input(0).message;
  }

  // ---- what is visited ----

  static constexpr int kMostMultipass = 9;  // lights of a method that draws all objects once for each

  std::optional<Viewer::Opened> open(const std::string& scene) {
    viewer_.open_scene(scene);
    viewer_.finish_loading();
    auto opened = viewer_.take_opened(now_);
    EXPECT_TRUE(opened) << scene;
    return opened;
  }
  // The meshes of light volumes, what methods keep from one frame to the next, what is read back, and a timer for every
  // view of a frame.
  void use_what_is_made_once(const std::string& scene, LightSource source) {
    const auto opened = open(scene);
    ASSERT_TRUE(opened);
    Settings s = opened->settings;
    s.size = {64, 36}, s.lights.source = source;
    ui::Requests all;
    all.visible.fill(true);
    for (const char* path : {"lights.method", "lights.volume.level"})
      for (const ValueRow* value : cards_of(option(path))) {
        option(path).set(s, value->id, option(path));
        s.lights.count = s.lights.method == LightMethod::forward_multipass ? kMostMultipass : 300;
        frame(s, all);
      }
    for (const View v : frame_views()) {  // of the large one the numbers are asked
      s.view.main = row(v).id;
      set_overlay(s.view.overlays, row(v).id, 0.5);
      frame(s, all);
    }
    for (const View v : {View::reference, View::error}) {
      s.view.main = row(v).id;
      play(s, showing({v}), 20);
    }
    s.view.main = row(View::final).id;
    probe(s, all), print_numbers(s, all), lock(s, all), look_from_outside(s, all);
    compare_settings(s, all), compare_truth(s, all), compare_picture(s, all), compare_layers(s, all);
    constexpr int kFramesUnderWay = 4;
    for (int k = 0; k < kFramesUnderWay; ++k) {
      s.time_s += 0.1;
      frame(s, all);
    }
  }
  void visit(const std::string& scene) {
    const auto opened = open(scene);
    ASSERT_TRUE(opened);
    now_ = chance(0.3) ? opened->settings : chosen(scene);
    now_.size = sizes_.deal(random_);
    const Act& act = kActs[acts_.deal(random_)];
    SCOPED_TRACE(fmt::format("{}: {}", scene, act.name));
    (this->*act.play)(now_, looked_at());
    ++drawn_;
  }
  // A preset in this scene, with other values here and there.
  Settings chosen(const std::string& scene) {
    Settings s = preset(presets_.deal(random_)).make();
    apply_scene(s, scene, lab_.scene());
    option("lights.count").set(s, Number(counts_.deal(random_)), option("lights.count"));
    if (chance(0.7)) s.lights.source = LightSource::generated;
    for (auto& [o, deck] : values_)
      if (chance(0.5)) choose(s, *o, deck);
    if (chance(0.7)) s.mistakes = {mistakes_.deal(random_)};
    if (s.lights.method == LightMethod::forward_multipass) s.lights.count = std::min(s.lights.count, kMostMultipass);
    return validate(s, lab_.limits()).empty() ? s : without_mistakes(s);
  }
  static Settings without_mistakes(Settings s) {
    s.mistakes.clear();
    return s;
  }
  void choose(Settings& s, const Option& o, Deck<const ValueRow*>& deck) {
    Settings with = s;
    o.set(with, deck.top(random_)->id, o);
    if (!validate(with, lab_.limits()).empty()) return deck.put_below();
    deck.take();
    s = with;
  }
  ui::Requests looked_at() {
    now_.view.main = views_.deal(random_);
    now_.view.overlays.clear();
    if (chance(0.5)) set_overlay(now_.view.overlays, overlays_.deal(random_), 0.5);
    ui::Requests r = showing({View::final, view_by_id(now_.view.main).view});
    r.visible[static_cast<size_t>(view_by_id(views_.deal(random_)).view)] = true;
    return r;
  }

  // ---- what is done there ----

  void look(const Settings& s, const ui::Requests& r) { play(s, r); }
  void move(const Settings& from, const ui::Requests& r) {
    Settings s = from;
    for (int k = 0; k < 3; ++k) {
      s.camera.position.x += 0.1, s.time_s += 0.1;
      frame(s, r, true);
    }
    play(s, r);
  }
  void probe(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.probe =
        glm::ivec2(random_.next() % static_cast<uint32_t>(s.size.x), random_.next() % static_cast<uint32_t>(s.size.y));
    r.account = true;
    play(s, r);
  }
  void print_numbers(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.numbers = {View::normal, PixelGrid{{1, 2}, {1, 1}, {9, 5}}};
    r.magnified = true;
    play(s, r);
  }
  void compare(const Settings& s, const ui::Requests& asked, ui::BesideA what, const std::string& file = "") {
    ui::Requests r = asked;
    Settings b = cured(s);
    b.exposure *= 2;
    Settings a = s;
    a.view.main = row(View::final).id;
    r.visible[static_cast<size_t>(View::reference)] = what == ui::BesideA::truth;
    r.compare = {.what = what, .view = View::final, .b = b, .file = file, .difference = true, .with_sign = chance(0.5)};
    play(a, r);
  }
  void compare_settings(const Settings& s, const ui::Requests& r) { compare(s, r, ui::BesideA::settings); }
  void compare_truth(const Settings& s, const ui::Requests& r) { compare(s, r, ui::BesideA::truth); }
  void compare_picture(const Settings& s, const ui::Requests& r) { compare(s, r, ui::BesideA::picture, picture()); }
  void compare_layers(const Settings& s, const ui::Requests& r) { compare(s, r, ui::BesideA::picture, layers()); }
  void look_from_outside(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.outside = ui::OutsideRequest{.from = s.camera, .size = {120, 80}, .colours = View::final};
    r.outside->from.position += glm::dvec3(5, 5, 5);
    play(s, r);
  }
  void lock(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.locked = {{.view = "depth", .look = {.fit = true, .map = ColourMap::viridis}},
                {.view = "normal", .look = {.channels = "r"}}};
    play(s, r);
  }
  void chart(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.chart = {.open = true, .study = studies_.deal(random_), .run = true};
    play(s, r, 0.6);
  }
  void sweep(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.stability = {.open = true, .sweep = sweeps_.deal(random_), .run = true};
    play(s, r, 0.6);
  }
  void advise(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.advisor = {.open = true, .budget = {8 / 255.0, 0.02}, .run = true};
    play(s, r, 0.6);
  }
  void open_pitfall(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.pitfall.id = pitfalls_.deal(random_);
    play(s, r, 0.6);
  }
  void list_pitfalls(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.pitfall.list = true;
    play(s, r, 0.6);
  }
  void save_picture(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.visible[static_cast<size_t>(View::final)] = true;
    play(s, r);
    write_png(picture(), lab_.image_of(View::final), picture_texts("gbufferlab render", lab_.drawn(), lab_.machine()));
  }
  void save_layers(const Settings& s, const ui::Requests& r) {
    play(s, r);
    std::vector<View> shown;
    for (const View v : {View::lit, View::normal, View::error})
      if (why_missing(v, lab_.drawn()).empty()) shown.push_back(v);
    write_layers(layers(), lab_, shown, {});
  }
  void open_picture(const Settings& s, const ui::Requests& r) {
    viewer_.drop(picture());
    viewer_.finish_loading();
    const auto opened = viewer_.take_opened(s);
    ASSERT_TRUE(opened) << viewer_.input(0).message;
    play(opened->settings, r);
  }
  void open_what_is_no_model(const Settings& s, const ui::Requests& r) {
    viewer_.drop(models_.write("bad.glb", {'g', 'l', 'T', 'F', 2, 0, 0, 0}).string());
    viewer_.finish_loading();
    EXPECT_FALSE(viewer_.take_opened(s));
    refused_ += viewer_.input(0).message_is_error;
    play(s, r);
  }
  void ask_for_nonsense(const Settings& s, const ui::Requests& r) {
    Settings bad = s;
    bad.camera.far = bad.camera.near, bad.size = {33, 17};
    frame(bad, r);
    refused_ += viewer_.input(0).message_is_error;
    play(s, r);
  }
  void read_shaders_again(const Settings& s, const ui::Requests& asked) {
    ui::Requests r = asked;
    r.reload_shaders = true;
    play(s, r);
  }
  // One that compiles anew, and one that does not.
  void save_shaders(const Settings& s, const ui::Requests& r) {
    ShaderCopy copy;
    play(s, r);
    copy.insert("shaders/views/final.glsl", "shown(", "// another text");
    play(s, r);
    copy.insert("shaders/views/final.glsl", "shown(", "this is no GLSL;");
    frame(s, r);
    refused_ += viewer_.input(0).message_is_error;
    copy.restore("shaders/views/final.glsl");
    play(s, r);
  }

  struct Act {
    const char* name;
    void (LongRun::*play)(const Settings&, const ui::Requests&);
  };
  static constexpr Act kActs[] = {
      {"look", &LongRun::look},
      {"move", &LongRun::move},
      {"probe", &LongRun::probe},
      {"print numbers", &LongRun::print_numbers},
      {"compare settings", &LongRun::compare_settings},
      {"compare truth", &LongRun::compare_truth},
      {"compare picture", &LongRun::compare_picture},
      {"compare layers", &LongRun::compare_layers},
      {"look from outside", &LongRun::look_from_outside},
      {"lock", &LongRun::lock},
      {"chart", &LongRun::chart},
      {"sweep", &LongRun::sweep},
      {"advise", &LongRun::advise},
      {"open pitfall", &LongRun::open_pitfall},
      {"list pitfalls", &LongRun::list_pitfalls},
      {"save picture", &LongRun::save_picture},
      {"save layers", &LongRun::save_layers},
      {"open picture", &LongRun::open_picture},
      {"open what is no model", &LongRun::open_what_is_no_model},
      {"ask for nonsense", &LongRun::ask_for_nonsense},
      {"read shaders again", &LongRun::read_shaders_again},
      {"save shaders", &LongRun::save_shaders},
  };

  std::string picture() const { return (folder_ / "picture.png").string(); }
  std::string layers() const { return (folder_ / "layers.exr").string(); }
  template <class Row>
  static std::vector<std::string> ids(std::span<const Row> rows) {
    std::vector<std::string> out;
    for (const Row& r : rows) out.push_back(r.id);
    return out;
  }
  static std::vector<std::string> ids_of_scenes() {
    std::vector<std::string> out;
    for (const BuiltinScene& s : builtin_scenes()) out.push_back(fmt::format("builtin:{}", s.id));
    return out;
  }
  static std::vector<std::string> ids_of_overlays() {
    std::vector<std::string> out;
    for (const View v : frame_views()) out.push_back(row(v).id);
    return out;
  }
  static std::vector<Mistake> all_mistakes() {
    std::vector<Mistake> out;
    for (const MistakeRow& m : mistakes()) out.push_back(m.mistake);
    return out;
  }
  static std::vector<std::string> ids_of_pitfalls() {
    const std::vector<PitfallEntry> all = load_pitfalls();
    return ids(std::span(all));
  }
  static std::vector<std::string> ids_of_studies() {
    std::vector<std::string> out;
    for (const BuiltinStudy& b : builtin_studies())
      if (can_run_here(load_study(b.id))) out.push_back(b.id);
    return out;
  }
  static std::vector<size_t> numbers_of_acts() {
    std::vector<size_t> out;
    for (size_t k = 0; k < std::size(kActs); ++k) out.push_back(k);
    return out;
  }

  Pcg32 random_;
  TemporaryFolder folder_{"long-run"};
  ScratchFolder models_{"long-run-models"};
  Settings start_ = preset("start").make(), now_ = start_;
  std::vector<std::string> scenes_ = ids_of_scenes();
  Deck<std::string> presets_{ids(presets())}, views_{ids(views())}, overlays_{ids_of_overlays()},
      pitfalls_{ids_of_pitfalls()}, sweeps_{ids(sweeps())}, studies_{ids_of_studies()};
  Deck<Mistake> mistakes_{all_mistakes()};
  Deck<int> counts_{{0, 1, 9, 64, 300, 1024}};
  Deck<glm::ivec2> sizes_{{{160, 90}, {96, 54}, {161, 91}, {64, 64}, {200, 40}}};
  Deck<size_t> acts_{numbers_of_acts()};
  std::map<const Option*, Deck<const ValueRow*>> values_;
  Lab lab_{FeatureSet{}};
  Viewer viewer_{lab_};
  int drawn_ = 0, refused_ = 0;
};

}  // namespace gbl::test
