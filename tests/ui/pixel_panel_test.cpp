// The panel of Ctrl+P: its pages, its loupe.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/frame/attachments.h"
#include "renderer/frame/resolve.h"
#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

constexpr uint64_t kTexture = 77;

std::vector<StoredTexel> texels_of(const Settings& s) {
  std::vector<StoredTexel> out;
  for (const Attachment& a : attachments(resolve(s, Scene{}).settings))
    out.push_back({a, {0x3f9d70a4, 0xbf9d70a4, 1, 2}});
  return out;
}

PixelAccount account_of(glm::ivec2 pixel) {
  PixelAccount a;
  a.pixel = pixel, a.surface = true;
  a.depth = {0x7fffff, 24, false, 0.499999970, 1234.56789, 1234.5678, 0.0123};
  for (const ValueRow& r : rows<PositionSource>())
    a.routes.push_back({static_cast<PositionSource>(r.value),
                        PositionReconstruct::inverse_viewproj_varying,
                        {-2056.12345, 500.123456, -4112.98765},
                        1.23456e-5,
                        r.value == 0});
  for (const char* what : {"distance", "position"})
    a.stored.push_back({what, "world units", {-2056.12345, 500.1, 2}, {-2056.12345, 500.1, 2}});
  a.terms.push_back({"+ ambient, emission", "radiance", {1, 2, 3}, {1, 2, 3}});
  for (int i = 0; i < 200; ++i) a.lights.push_back({.index = i, .distance = 123.456, .range = 1234});
  return a;
}

// The squares that are cut from the picture of the large view, and where from: pixels, origin top left.
std::vector<glm::vec2> squares(glm::ivec2 size) {
  std::vector<glm::vec2> out;
  const ImDrawData* data = ImGui::GetDrawData();
  for (int l = 0; l < data->CmdListsCount; ++l) {
    const ImDrawList& list = *data->CmdLists[l];
    for (const ImDrawCmd& cmd : list.CmdBuffer) {
      if (reinterpret_cast<uint64_t>(cmd.TextureId) != kTexture) continue;
      for (unsigned i = 0; i < cmd.ElemCount; i += 6) {
        const ImVec2 uv =
            list.VtxBuffer[list.IdxBuffer[static_cast<int>(cmd.IdxOffset + i)] + static_cast<int>(cmd.VtxOffset)].uv;
        const ImVec2 far =
            list.VtxBuffer[list.IdxBuffer[static_cast<int>(cmd.IdxOffset + i + 2)] + static_cast<int>(cmd.VtxOffset)]
                .uv;
        if (uv.x == far.x && uv.y == far.y) out.emplace_back(uv.x * size.x, (1 - uv.y) * size.y);
      }
    }
  }
  return out;
}

class PixelPanel : public testing::Test {
 protected:
  // The panel is open and holds this pixel.
  void hold(Desk& desk, glm::ivec2 pixel) {
    desk.report.size = {1280, 720};
    desk.images[static_cast<size_t>(View::final)] = {kTexture, {1280, 720}};
    desk.press("g", false, true);
    desk.frame();
    desk.type(fmt::format("{}, {}", pixel.x, pixel.y).c_str());
    desk.press("p", false, true);
    desk.probed_pixel = pixel;
    desk.frame();
    desk.frame();
  }
};

TEST_F(PixelPanel, TheLoupeShowsThePixelsAroundTheHeldOneAndFollowsIt) {
  Desk desk;
  hold(desk, {300, 200});
  const auto shown = squares({1280, 720});
  ASSERT_EQ(shown.size(), 121u);
  for (size_t i = 0; i < shown.size(); ++i)
    EXPECT_LT(glm::distance(shown[i], glm::vec2(295.5f + float(i % 11), 195.5f + float(i / 11))), 0.01f) << i;
  desk.press("Right");
  desk.press("Down");
  desk.frame();
  EXPECT_LT(glm::distance(squares({1280, 720})[60], glm::vec2(301.5f, 201.5f)), 0.01f);
}

TEST_F(PixelPanel, BesideThePictureTheLoupeIsEmpty) {
  Desk desk;
  hold(desk, {0, 719});
  EXPECT_EQ(squares({1280, 720}).size(), 36u);
}

TEST_F(PixelPanel, TheNumbersOfTheHeldPixelAreAskedFor) {
  Desk desk;
  hold(desk, {300, 200});
  ASSERT_TRUE(desk.requests.numbers);
  EXPECT_EQ(desk.requests.numbers->first, View::final);
  EXPECT_EQ(desk.requests.numbers->second, (PixelGrid{{300, 200}, {1, 1}, {1, 1}}));
  desk.press("Esc");
  desk.frame();
  EXPECT_FALSE(desk.requests.numbers);
}

// Whatever is stored, every page fits; more lines come by PgDn.
TEST_F(PixelPanel, EachPageFitsForEachLayout) {
  const PixelAccount account = account_of({300, 200});
  for (const bool present : {false, true})
    for (const ValueRow& layout : rows<gbl::Layout>()) {
      Settings s = preset("start").make();
      s.layout = static_cast<gbl::Layout>(layout.value);
      s.position.source = PositionSource::world32f;
      Desk desk({1600, 900}, present, s);
      desk.stored = texels_of(s);
      desk.account = &account;
      hold(desk, {300, 200});
      for (int page = 0; page < 3; ++page) {
        for (int lines = 0; lines < 3; ++lines) {
          EXPECT_TRUE(desk.ui.cut_texts().empty()) << layout.id << " page " << page << ": " << desk.ui.cut_texts()[0];
          desk.press("PgDn");
          desk.frame();
        }
        desk.press("p");
        desk.frame();
      }
    }
}

}  // namespace
}  // namespace gbl::ui
