// A broken shader is reported where it is broken and leaves the old picture; what C++ and GLSL share they lay out alike.
#include <map>
#include <regex>
#include <sstream>

#include "renderer/base/error.h"
#include "renderer/base/resources.h"
#include "renderer/passes/frame_block.h"
#include "renderer/passes/programs.h"
#include "tests/gl_fixture.h"
#include "tests/shader_copy.h"

namespace gbl::test {
namespace {

class Shaders : public GlTest {};

// ---- reload ------------------------------------------------------------------------------------------------
std::string reload_error(Renderer& renderer) {
  try {
    renderer.reload_shaders();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    return e.what();
  }
  return "";
}

TEST_F(Shaders, ABrokenIncludeIsNamedAndTheOldPictureStays) {
  ShaderCopy copy;
  Stage stage(yard());
  const Settings s = settings_for(yard(), {64, 36});
  const Picture before = stage.lit(s);
  EXPECT_EQ(reload_error(stage.renderer), "");
  EXPECT_TRUE(same_bits(stage.lit(s), before));
  // Files that are included at the first line, in the middle of others, and a file of its own.
  for (const auto& [name, mark] : {std::pair("shaders/shade.glsl", "Lighting shade("),
                                   {"shaders/colour.glsl", "#else"},
                                   {"shaders/position.glsl", "vec3 position_from_depth("},
                                   {"shaders/layouts/albedo-roughness.glsl", "void unpack_material("},
                                   {"shaders/combine.frag", "void main"}}) {
    const int line = copy.insert(name, mark, "this is no GLSL;");
    const std::string error = reload_error(stage.renderer);
    EXPECT_NE(error.find(fmt::format("{}:{}:", name, line)), std::string::npos)
        << name << ":" << line << " | " << error;
    EXPECT_TRUE(same_bits(stage.lit(s), before)) << name;
    copy.restore(name);
    EXPECT_EQ(reload_error(stage.renderer), "");
    EXPECT_TRUE(same_bits(stage.lit(s), before)) << name;
  }
}

TEST_F(Shaders, AChangedShaderIsSeenAfterReloadAndNotBefore) {
  ShaderCopy copy;
  Stage stage(yard());
  const Settings s = settings_for(yard(), {64, 36});
  const Picture before = stage.lit(s);
  copy.insert("shaders/shade.glsl", "lane arriving = arriving_share", "  light.colour *= 0.5;");
  EXPECT_TRUE(same_bits(stage.lit(s), before));
  EXPECT_EQ(reload_error(stage.renderer), "");
  EXPECT_TRUE(unlike(stage.lit(s), before, {.max_abs = 0.01}));
}

TEST_F(Shaders, OnlyWhatASavedFileChangesIsCompiledAnew) {
  ShaderCopy copy;
  Stage stage(yard());
  stage.lit(settings_for(yard(), {64, 36}));
  const int all = stage.renderer.programs_compiled();
  EXPECT_EQ(reload_error(stage.renderer), "");
  EXPECT_EQ(stage.renderer.programs_compiled(), all) << "nothing was changed";
  copy.insert("shaders/combine.frag", "void main", "// a remark");
  EXPECT_EQ(reload_error(stage.renderer), "");
  EXPECT_EQ(stage.renderer.programs_compiled(), all + 1);
}

// A mark that has gone from the shader must not break another place without a word.
TEST_F(Shaders, ACopyRefusesAMarkThatTheShaderDoesNotHold) {
  ShaderCopy copy;
  EXPECT_THROW(copy.insert("shaders/shade.glsl", "no such mark", "this is no GLSL;"), std::invalid_argument);
}

// A variant that was never needed before does not compile: the Error comes from the frame, the next good frame is right.
TEST_F(Shaders, AVariantThatDoesNotCompileThrowsAndHarmsNoOther) {
  ShaderCopy copy;
  copy.insert("shaders/light_fullscreen.frag", "void main", "this is no GLSL;");
  Stage stage(yard());
  Settings s = settings_for(yard(), {64, 36});
  const Picture good = stage.lit(s);
  s.lights.method = LightMethod::fullscreen;
  for (int again = 0; again < 2; ++again) EXPECT_THROW(stage.draw(s), Error);
  s.lights.method = LightMethod::volumes;
  EXPECT_TRUE(same_bits(stage.lit(s), good));
}

// ---- what C++ and GLSL share -------------------------------------------------------------------------------
// The driver's offsets are those of a C++ struct of the same lines: every member is a multiple of 16 bytes (asserted
// here), so C++ leaves no gaps.
TEST_F(Shaders, TheDriverLaysOutTheFrameBlockAsCppDoes) {
  ProgramCache programs;
  const GLuint program = programs
                             .get("fullscreen.vert", "combine.frag",
                                  gbuffer_defines(resolve_frame(settings_for(yard()), yard().scene(), {})))
                             .id();
  const GLuint block = glGetUniformBlockIndex(program, "FrameBlock");
  ASSERT_NE(block, GL_INVALID_INDEX);
  const std::string text = resource("shaders/shared.h");
  std::istringstream lines(text.substr(text.find("GBL_BLOCK(FrameBlock)")));
  static const std::regex kMember(R"(^\s*(\w+)\s+(\w+)\s*;.*)");
  const std::map<std::string, GLint> sizes = {{"mat4", 64}, {"vec4", 16}, {"ivec4", 16}};
  GLint expected = 0, members = 0;
  for (std::string line; std::getline(lines, line) && line.find('}') == std::string::npos;) {
    std::smatch m;
    if (!std::regex_match(line, m, kMember)) continue;
    ASSERT_TRUE(sizes.count(m[1])) << line << ": a type that std140 and C++ lay out differently";
    const std::string name = m[2];
    const char* names[] = {name.c_str()};
    GLuint index = GL_INVALID_INDEX;
    glGetUniformIndices(program, 1, names, &index);
    ASSERT_NE(index, GL_INVALID_INDEX) << name;
    GLint offset = -1;
    glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &offset);
    EXPECT_EQ(offset, expected) << name;
    expected += sizes.at(m[1]), ++members;
  }
  GLint active = 0, bytes = 0;
  glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, &active);
  glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
  EXPECT_EQ(active, members);
  EXPECT_EQ(size_t(bytes), sizeof(shared::FrameBlock));
  EXPECT_EQ(size_t(expected), sizeof(shared::FrameBlock));
  EXPECT_EQ(offsetof(shared::FrameBlock, world_from_clip), 64u);
  EXPECT_EQ(offsetof(shared::FrameBlock, view_from_world), 192u);
  EXPECT_EQ(offsetof(shared::FrameBlock, lights), sizeof(shared::FrameBlock) - 16);
}

}  // namespace
}  // namespace gbl::test
