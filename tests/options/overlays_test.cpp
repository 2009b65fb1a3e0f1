#include "renderer/options/overlays.h"

#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/options/options.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

TEST(Overlays, TextsAreReadBackAsTheyAreWritten) {
  for (const char* text : {"wire", "footprint:0.25", "normal:1", "checks:1e-05"})
    EXPECT_EQ(text_of(parse_overlay(text, "here")), text);
  EXPECT_EQ(parse_overlay("wire", "here").opacity, kOverlayOpacity);
  for (const char* text : {"wire:", "wire:0", "wire:-1", "wire:1.5", "wire:half", "wire:nan", "wire:0.5:0.5"})
    EXPECT_THROW(parse_overlay(text, "here"), Error) << text;
}

TEST(Overlays, SettingsKeepTheirOrderAndEachViewOnce) {
  Settings s;
  const auto set = [&](OptionList list) { option("view.overlays").set(s, list, option("view.overlays")); };
  set({"wire:0.5", "footprint", "wire:0.25"});
  ASSERT_EQ(s.view.overlays.size(), 2u);
  EXPECT_EQ(text_of(s.view.overlays[0]), "wire:0.25");
  EXPECT_EQ(text_of(s.view.overlays[1]), "footprint");
  EXPECT_EQ(parse_settings(settings_text(s), "test"), s);
  set_overlay(s.view.overlays, "wire", 0);
  EXPECT_EQ(find_overlay(s.view.overlays, "wire"), nullptr);
  set_overlay(s.view.overlays, "overdraw", 0.5);
  EXPECT_EQ(s.view.overlays.back().view, "overdraw") << "a new one lies on top";
  EXPECT_THROW(set({"nothing"}), Error);
}

}  // namespace
}  // namespace gbl
