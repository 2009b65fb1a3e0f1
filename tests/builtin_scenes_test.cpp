#include "renderer/builtin_scenes.h"

#include <gtest/gtest.h>
#include <string>

#include "renderer/error.h"

namespace gbl {
namespace {

TEST(BuiltinScenes, NamesThatAreNotScenesSayWhatThereIs) {
  const auto message = [](const char* name) -> std::string {
    try {
      load_scene(name);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ExitCode::bad_input);
      return e.what();
    }
    return "no error";
  };
  const std::string typo = message("builtin:terain"), file = message("duck.glb");
  EXPECT_NE(typo.find("builtin:terain"), std::string::npos) << typo;
  EXPECT_NE(typo.find("did you mean 'terrain'? known: "), std::string::npos) << typo;
  EXPECT_NE(file.find("duck.glb: model files cannot be opened yet"), std::string::npos) << file;
  EXPECT_NE(file.find("builtin:terrain"), std::string::npos) << file;
}

TEST(BuiltinScenes, EveryRowLoadsUnderItsId) {
  for (const BuiltinScene& row : builtin_scenes()) EXPECT_EQ(load_scene(std::string("builtin:") + row.id).name, row.id);
}

}  // namespace
}  // namespace gbl
