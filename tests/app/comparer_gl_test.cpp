// A and B in the window's own loop, without a window: B's picture is what B alone would draw, and the difference is theirs.
#include "app/viewer.h"
#include "renderer/base/files.h"
#include "renderer/picture/exr.h"
#include "tests/app/viewer_fixture.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

class Comparing : public ViewerTest {
 protected:
  // Until all answers are there.
  const ui::CompareInput& compare(const Settings& a, const ui::CompareRequest& with, View main = View::final) {
    ui::Requests r = showing({main});
    r.compare = with;
    r.compare->view = main;
    if (with.what == ui::BesideA::truth) r.visible[static_cast<size_t>(View::reference)] = true;
    Settings s = a;
    s.view.main = row(main).id;
    update(s, r);
    settle(s, r);
    return *viewer_->input(0).compare;
  }
  static Image pixels(const ui::ViewImage& image) {
    std::vector<uint8_t> rgba(4 * static_cast<size_t>(image.size.x) * static_cast<size_t>(image.size.y));
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(image.texture));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return image_from_gl_rows(image.size, std::move(rgba));
  }
  Image alone(const Settings& s, View v) {
    Lab lab(FeatureSet{});
    lab.show("yard", std::make_shared<const Scene>(make_yard()));
    lab.draw(s);
    lab.draw_measured_view(v);
    return lab.image_of(v);
  }
};

// The largest difference of a channel, by hand.
int most(const Image& a, const Image& b) {
  int out = 0;
  for (size_t i = 0; i < a.rgba.size(); ++i) out = std::max(out, std::abs(int(a.rgba[i]) - int(b.rgba[i])));
  return out;
}

TEST_F(Comparing, BIsWhatItsSettingsAloneWouldDraw) {
  const Settings a = yard_settings();
  Settings b = a;
  b.lights.count = 5;
  b.normal.encoding = NormalEncoding::oct8;
  for (const View v : {View::final, View::normal, View::lights_per_pixel}) {
    const ui::CompareInput in = compare(a, {.b = b, .difference = true}, v);
    EXPECT_EQ(in.missing, "");
    const Image of_b = pixels(in.b), of_a = lab_->image_of(v);
    EXPECT_TRUE(v == View::lights_per_pixel || of_b == alone(b, v)) << row(v).id;  // counts have A's legend
    ASSERT_TRUE(in.stats) << row(v).id;
    EXPECT_NEAR(in.stats->max, most(of_a, of_b), 1e-3) << row(v).id;
    EXPECT_TRUE(lab_->image_of(v) == of_a) << "A is drawn as before";
  }
}

TEST_F(Comparing, EqualSettingsDifferNowhereAndAPartHasItsOwnNumbers) {
  const Settings a = yard_settings();
  EXPECT_EQ(compare(a, {.b = a, .difference = true}).stats->max, 0);
  Settings b = a;
  b.lights.count = 5;
  const ErrorStats whole = *compare(a, {.b = b, .difference = true}).stats;
  const ErrorStats top = *compare(a, {.b = b, .difference = true, .first = {0, 0}, .share = {1, 0.5}}).stats;
  const ErrorStats bottom = *compare(a, {.b = b, .difference = true, .first = {0, 0.5}, .share = {1, 0.5}}).stats;
  EXPECT_EQ(top.compared + bottom.compared, whole.compared);
  EXPECT_NEAR(top.mean + bottom.mean, 2 * whole.mean, 1e-9);
  EXPECT_EQ(std::max(top.max, bottom.max), whole.max);
  EXPECT_EQ((top.max > bottom.max ? top : bottom).worst, whole.worst) << "in the whole picture's pixels";
}

TEST_F(Comparing, AFileIsBAndWhatCannotBeOneIsSaid) {
  const Settings a = yard_settings();
  const TemporaryFolder folder("comparing");
  write_png(folder / "b.png", alone(a, View::final));
  ui::CompareRequest r{.what = ui::BesideA::picture, .file = (folder / "b.png").string(), .difference = true};
  EXPECT_EQ(compare(a, r).stats->max, 0);
  EXPECT_EQ(compare(a, r).note, "");

  // The radiance of the same picture, shown as the display shows it.
  Lab lab(FeatureSet{});
  lab.show("yard", std::make_shared<const Scene>(make_yard()));
  lab.draw(a);
  const std::vector<glm::vec4> lit = lab.numbers_of(View::lit);
  std::vector<ExrChannel> channels(3);
  for (int k = 0; k < 3; ++k) {
    channels[static_cast<size_t>(k)].name = "RGB"[k];
    for (const glm::vec4& t : lit) channels[static_cast<size_t>(k)].values.push_back(t[k]);
  }
  write_exr(folder / "b.exr", a.size, channels);
  const ExrPicture back = read_exr(folder / "b.exr");
  ASSERT_EQ(back.size, a.size);
  for (size_t i = 0; i < lit.size(); ++i) ASSERT_EQ(back.rgb[i], glm::vec3(lit[i]));
  r.file = (folder / "b.exr").string();
  EXPECT_LE(compare(a, r).stats->max, 1) << "rounded to codes by the CPU and by the GPU";

  write_png(folder / "small.png", Image{{8, 4}, std::vector<uint8_t>(8 * 4 * 4, 255)});
  r.file = (folder / "small.png").string();
  EXPECT_NE(compare(a, r).note.find("8x4, stretched to"), std::string::npos);
  write_text_file(folder / "broken.exr", "no picture");
  write_text_file(folder / "broken.png", "no picture");
  for (const char* bad : {"broken.exr", "broken.png", "none.png"}) {
    r.file = (folder / bad).string();
    const ui::CompareInput in = compare(a, r);
    EXPECT_NE(in.missing.find(bad), std::string::npos) << in.missing;
    EXPECT_EQ(in.b.texture, 0u);
  }
}

TEST_F(Comparing, TheTruthIsTheReferencesPicture) {
  const Settings a = yard_settings();
  const ui::CompareInput in = compare(a, {.what = ui::BesideA::truth, .difference = true});
  EXPECT_EQ(in.missing, "");
  EXPECT_TRUE(pixels(in.b) == lab_->image_of(View::reference));
  EXPECT_NE(compare(a, {.what = ui::BesideA::truth}, View::normal).missing, "");
}

TEST_F(Comparing, NoOldTruthStandsBesideANewFrame) {
  Settings a = yard_settings();
  compare(a, {.what = ui::BesideA::truth});
  a.camera.position.x += 3;
  ui::Requests r = showing({View::final, View::reference});
  r.compare = ui::CompareRequest{.what = ui::BesideA::truth};
  update(a, r, true);
  EXPECT_EQ(viewer_->input(0).compare->b.texture, 0u) << "while the camera moves none is made";
  EXPECT_NE(viewer_->input(0).compare->missing, "");
}

TEST_F(Comparing, BThatCannotBeDrawnIsSaidAndAStays) {
  const Settings a = yard_settings();
  Settings b = a;
  b.scene = "builtin:room";
  EXPECT_NE(compare(a, {.b = b}).missing.find("another scene"), std::string::npos);
  b = a;
  b.camera.far = b.camera.near;
  EXPECT_NE(compare(a, {.b = b}).missing.find("camera.far"), std::string::npos);
  b = a;
  b.lights.method = LightMethod::forward;
  EXPECT_NE(compare(a, {.b = b}, View::normal).missing.find("forward"), std::string::npos);
}

}  // namespace
}  // namespace gbl::test
