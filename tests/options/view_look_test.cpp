#include "renderer/options/view_look.h"

#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/options/options.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

TEST(ViewLook, TextsAreReadBackAsTheyAreWritten) {
  for (const char* text :
       {"depth:400..600:viridis", "normal:r", "albedo:0..0.1:linear", "final:fit", "lit:-1..1:gb:srgb",
        "depth:1e-05..1000000.5", "position:fit:b:diverging", "albedo:600..400", "normal:raw"})
    EXPECT_EQ(text_of(parse_look(text, "here")), text);
  EXPECT_EQ(text_of(parse_look("depth:turbo:fit", "here")), "depth:fit:turbo") << "in any order";
  EXPECT_TRUE(parse_look("depth", "here").look.plain());
}

TEST(ViewLook, WhatMeansNothingIsRefusedByName) {
  for (const char* text :
       {"depth:", "depth:5..5", "depth:1..", "depth:..2", "depth:red", "depth:rr", "depth:br", "depth:fit:fit",
        "depth:fit:1..2", "depth:1..2:3..4", "depth:srgb:linear", "depth:grey:turbo", "depth:raw:fit", "depth:fit:raw",
        "depth:raw:raw", "depth:srgb:raw", "depth:own", "depth:nan..1", "depth:0x1..2"})
    try {
      parse_look(text, "--set view.looks");
      FAIL() << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ExitCode::bad_input);
      EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << e.what();
    }
}

TEST(ViewLook, SettingsKeepEachViewOnceAndPlainOnesNot) {
  Settings s;
  const auto set = [&](OptionList list) { option("view.looks").set(s, list, option("view.looks")); };
  set({"normal:r", "depth:fit", "normal:g", "albedo"});
  ASSERT_EQ(s.view.looks.size(), 2u);
  EXPECT_EQ(text_of(s.view.looks[0]), "depth:fit");
  EXPECT_EQ(text_of(s.view.looks[1]), "normal:g");
  EXPECT_EQ(look_of(s.view.looks, "normal").channels, "g");
  EXPECT_TRUE(look_of(s.view.looks, "albedo").plain());
  EXPECT_EQ(parse_settings(settings_text(s), "test"), s);
  EXPECT_THROW(set({"nothing:fit"}), Error);
  set({});
  EXPECT_TRUE(s.view.looks.empty());
}

}  // namespace
}  // namespace gbl
