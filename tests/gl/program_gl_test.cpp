// Samplers get their units from the programs, a log is never cut, and a name that no shader has is reported.
#include "renderer/gl/program.h"

#include <set>

#include "renderer/base/error.h"
#include "renderer/gl/texture_units.h"
#include "renderer/passes/passes.h"
#include "renderer/passes/programs.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Programs : public GlTest {};

std::string error_of(const gl::ShaderText& vertex, const gl::ShaderText& fragment) {
  const int live = gl::live_names();
  std::string text = "no error";
  try {
    gl::compile_program(vertex, fragment);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    text = e.what();
  }
  EXPECT_EQ(gl::live_names(), live) << "what was compiled before the error is let go of";
  return text;
}

const gl::ShaderText kVertex{"test.vert", "void main() { gl_Position = vec4(0.0); }\n"};

gl::Program program_of(const char* fragment) { return gl::compile_program(kVertex, {"test.frag", fragment}); }

// ---- samplers ----------------------------------------------------------------------------------------------
// Every program that lives in this context: its samplers' names and the units that they read.
std::vector<std::map<std::string, GLint>> samplers_of_all_programs() {
  std::vector<std::map<std::string, GLint>> all;
  constexpr GLuint kMoreThanAreMade = 20'000;
  for (GLuint id = 1; id < kMoreThanAreMade; ++id) {
    if (!glIsProgram(id)) continue;
    std::map<std::string, GLint> units;
    GLint count = 0;
    glGetProgramiv(id, GL_ACTIVE_UNIFORMS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
      char name[256] = {};
      GLint elements = 0;
      GLenum type = 0;
      glGetActiveUniform(id, i, sizeof name, nullptr, &elements, &type, name);
      if (type != GL_SAMPLER_2D && type != GL_UNSIGNED_INT_SAMPLER_2D) continue;
      glGetUniformiv(id, glGetUniformLocation(id, name), &units[name]);
    }
    all.push_back(std::move(units));
  }
  return all;
}

// Keys in a window reach thousands of variants; a driver keeps a megabyte and more for each.
TEST_F(Programs, OnlySoManyAreKeptAndTheLatestAmongThem) {
  ProgramCache cache;
  const int before = gl::live_names();
  const auto ask = [&](int k) -> const gl::Program& {
    return cache.get("fullscreen.vert", "error_colour.frag", {{"COLOUR_STOPS", 2}, {"VARIANT", k}});
  };
  const GLuint first = ask(0).id();
  const auto most = static_cast<int>(ProgramCache::kMost);
  for (int k = 1; k < most; ++k) ask(k);
  EXPECT_EQ(ask(0).id(), first) << "it is still there";
  for (int k = most; k < most + 20; ++k) ask(k);
  EXPECT_EQ(cache.size(), ProgramCache::kMost);
  EXPECT_EQ(ask(0).id(), first) << "used again, it was not among the oldest";
  EXPECT_EQ(gl::live_names() - before, most) << "what is forgotten is deleted";
}

TEST_F(Programs, EverySamplerOfEveryProgramReadsAUnitOfItsOwn) {
  Stage stage(yard());
  for_each_row<LightMethod>([&](LightMethod method, auto&) {
    Settings s = settings_for(yard(), {8, 4});
    s.lights.method = method;
    stage.pairs(s);
  });
  for_each_row<Layout>([&](Layout layout, auto&) {
    Settings s = settings_for(yard(), {8, 4});
    s.layout = layout;
    stage.draw(s);
    stage.renderer.start_probe(s, yard(), stage.targets, {1, 1});
    stage.view(View::final, s, {.overlays = true});
  });
  for (const View v : frame_views()) stage.view(v, settings_for(yard(), {8, 4}));
  std::map<std::string, GLint> unit_of_name;
  const auto all = samplers_of_all_programs();
  for (const auto& units : all) {
    std::set<GLint> taken;
    for (const auto& [name, unit] : units) {
      EXPECT_GT(unit, 0) << name << ": unit 0 is where textures are made";
      EXPECT_TRUE(taken.insert(unit).second) << name << " shares a unit";
      EXPECT_EQ(unit_of_name.emplace(name, unit).first->second, unit) << name << ": one unit in every program";
    }
  }
  EXPECT_GE(all.size(), 50u);
  EXPECT_GE(unit_of_name.size(), 15u);
  EXPECT_LE(gl::units_in_use(), gl::device().max_texture_units);
}

// One texel of a shader's value.
glm::vec4 drawn_by(const gl::Program& program) {
  const gl::Texture target = gl::make_texture({.format = Format::rgba32f, .label = "test"});
  const gl::Framebuffer framebuffer = gl::make_framebuffer({.colours = {&target}, .label = "test"});
  begin_drawing(framebuffer, {1, 1}, {});
  glUseProgram(program.id());
  Shapes().draw_fullscreen();
  return picture_of(target).texels[0];
}

gl::Texture texel_of(float value) {
  gl::Texture t = gl::make_texture({.format = Format::rgba32f, .label = "test"});
  const glm::vec4 texel(value);
  gl::write_texels(t, &texel);
  return t;
}

// Bound before the program is known or after it: a shader's new sampler needs no line of C++ but the bind.
TEST_F(Programs, ANewSamplerNeedsNoRowAnywhere) {
  const gl::Program program =
      gl::compile_program(gl::load_shader("fullscreen.vert", {}), {"test.frag",
                                                                   "uniform sampler2D brand_new;\n"
                                                                   "uniform sampler2D newer_still;\n"
                                                                   "layout(location = 0) out vec4 sum;\n"
                                                                   "void main() {\n"
                                                                   "  sum = texelFetch(brand_new, ivec2(0), 0);\n"
                                                                   "  sum.g = texelFetch(newer_still, ivec2(0), 0).g;\n"
                                                                   "}\n"});
  const gl::Texture two = texel_of(2), three = texel_of(3), four = texel_of(4);
  gl::bind_texture("newer_still", three);
  gl::bind_texture("brand_new", two);
  EXPECT_EQ(drawn_by(program), glm::vec4(2, 3, 2, 2));
  gl::bind_texture("brand_new", four);
  EXPECT_EQ(drawn_by(program), glm::vec4(4, 3, 4, 4)) << "and making textures unbinds none";
}

TEST_F(Programs, ABoundNameThatNoShaderHasIsReported) {
  const gl::Texture t = texel_of(1);
  gl::bind_texture("gbuffer_normal", t);
  EXPECT_EQ(gl::take_misuse(), std::vector<std::string>{});
  gl::bind_texture("gbufer_normal", t);
  const std::vector<std::string> said = gl::take_misuse();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("'gbufer_normal'"), std::string::npos) << said[0];
}

// ---- uniforms ----------------------------------------------------------------------------------------------
TEST_F(Programs, AUniformThatTheProgramLacksIsReportedOnce) {
  const gl::Program program = program_of(
      "uniform float used;\n"
      "uniform float unused;\n"
      "out vec4 colour;\n"
      "void main() { colour = vec4(used); }\n");
  EXPECT_GE(program.uniform("used"), 0);
  EXPECT_GE(program.find_uniform("used"), 0);
  EXPECT_EQ(program.find_uniform("unused"), -1);
  EXPECT_EQ(gl::take_misuse(), std::vector<std::string>{});
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(program.uniform("usd"), -1);
    EXPECT_EQ(program.find_uniform("unusd"), -1);
  }
  const std::vector<std::string> expected = {"test.vert + test.frag: uniform 'usd' is not declared",
                                             "test.vert + test.frag: uniform 'unusd' is not declared"};
  EXPECT_EQ(gl::take_misuse(), expected);
}

TEST_F(Programs, AUniformThatIsLostWhereItMustBeIsReported) {
  const gl::Program program =
      program_of("uniform float unused;\nout vec4 colour;\nvoid main() { colour = vec4(1.0); }\n");
  EXPECT_EQ(program.uniform("unused"), -1);
  const std::vector<std::string> expected = {"test.vert + test.frag: uniform 'unused' is not used"};
  EXPECT_EQ(gl::take_misuse(), expected);
}

// ---- logs --------------------------------------------------------------------------------------------------
// Lines of the same text with numbers in it.
std::string numbered(int count, const char* text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += fmt::format(fmt::runtime(text), i);
  return all;
}

// The mistake comes after more warnings than any buffer of ours would hold.
TEST_F(Programs, AMistakeAfterALongLogIsFound) {
  const int kWarnings = 500;
  const std::string body = "#line 1 0\nout vec4 colour;\nvoid main() {\n  float sum = 0.0;\n" +
                           numbered(kWarnings, "  float never_given_a_value_{0}; sum += never_given_a_value_{0};\n") +
                           "  colour = vec4(sum + the_last_mistake);\n}\n";
  const std::string error = error_of(kVertex, {"long.frag", body});
  EXPECT_NE(error.find(fmt::format("long.frag:{}:", 4 + kWarnings)), std::string::npos) << error;
  EXPECT_NE(error.find("the_last_mistake"), std::string::npos) << error;
}

// A layout's or a view's file is named by a define (`#include LAYOUT_FILE`).
TEST_F(Programs, AFileNamedByADefineIsIncludedAndAMissingDefineIsNamedWithItsPlace) {
  const gl::Defines both = {{"LAYOUT_FILE", "layouts/nclgl.glsl"}, {"VIEW_FILE", "views/depth.glsl"}};
  const gl::ShaderText text = gl::load_shader("views.frag", both);
  for (const char* file : {"shaders/layouts/nclgl.glsl", "shaders/views/depth.glsl"})
    EXPECT_NE(std::find(text.files.begin(), text.files.end(), file), text.files.end()) << file;
  try {
    gl::load_shader("views.frag", {both[1]});
    FAIL();
  } catch (const Error& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("shaders/packing.glsl:"), std::string::npos) << what;
    EXPECT_NE(what.find("#include LAYOUT_FILE: no such define"), std::string::npos) << what;
  }
}

TEST_F(Programs, StagesThatDoNotFitTogetherSayWhere) {
  const gl::ShaderText vertex{"fits.vert", "out vec2 passed_on;\nvoid main() { passed_on = vec2(1.0); }\n"};
  const gl::ShaderText fragment{"not.frag", "in vec4 passed_on;\nout vec4 c;\nvoid main() { c = passed_on; }\n"};
  const std::string error = error_of(vertex, fragment);
  EXPECT_NE(error.find("fits.vert + not.frag"), std::string::npos) << error;
  EXPECT_NE(error.find("passed_on"), std::string::npos) << error;
}

}  // namespace
}  // namespace gbl::test
