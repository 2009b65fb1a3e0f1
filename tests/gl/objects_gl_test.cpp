// What the driver refuses is an Error that names the object, and leaves nothing behind. Where a driver cannot be made
// to fail, the one call is replaced for the time of the test.
#include <functional>

#include "renderer/base/error.h"
#include "renderer/gl/gl_error.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class GlObjects : public GlTest {};

std::string error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::unfinished) << e.what();
    return e.what();
  }
  return "no error";
}

void expect_words(const std::string& text, std::initializer_list<std::string> words) {
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " | " << text;
}

// A function of GL replaced by another while this lives.
template <class Function>
class Replaced {
 public:
  Replaced(Function& slot, Function by) : slot_(slot), before_(slot) { slot_ = by; }
  ~Replaced() { slot_ = before_; }
  Replaced(const Replaced&) = delete;

 private:
  Function& slot_;
  Function before_;
};

// ---- no room -----------------------------------------------------------------------------------------------
int beyond_the_limit() {
  GLint texture = 0, renderbuffer = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  return 2 * std::max(texture, renderbuffer);
}

TEST_F(GlObjects, ATextureBeyondTheLimitIsAnErrorThatNamesIt) {
  const int live = gl::live_names(), side = beyond_the_limit();
  const std::string error = error_of([&] {
    gl::make_texture({.size = {side, 16}, .format = Format::rgba32f, .label = "gbuffer.too-large"});
  });
  expect_words(error, {"gbuffer.too-large: a texture of ", fmt::format("{}x16 RGBA32F", side), "GL_INVALID_VALUE",
                       "choose a smaller size"});
  EXPECT_EQ(gl::live_names(), live);
}

TEST_F(GlObjects, AnImageAndSamplesBeyondTheLimitAreErrorsToo) {
  const int live = gl::live_names(), side = beyond_the_limit();
  const std::string image = error_of([&] { gl::make_image({.size = {side, 1}, .label = "bricks"}); });
  expect_words(image, {"bricks: an image of ", fmt::format("{}x1", side), "GL_INVALID_VALUE"});
  const std::string samples = error_of([&] { gl::make_samples({side, 1}, Format::rgba8, 4, "normal"); });
  expect_words(samples, {"normal: a 4-sample buffer of ", fmt::format("{}x1 RGBA8", side), "GL_INVALID_VALUE"});
  EXPECT_EQ(gl::live_names(), live);
}

// The driver's memory runs out in the second question: the first is for older errors.
GLenum out_of_memory_at_the_second() {
  static int asked = 0;
  return ++asked % 2 == 0 ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
}

TEST_F(GlObjects, AFrameWithoutMemoryIsAnErrorAndTheNextOneIsRight) {
  Stage stage(yard());
  const Settings s = settings_for(yard(), {64, 36});
  const Picture before = stage.lit(s);
  {
    const Replaced no_memory(epoxy_glGetError, &out_of_memory_at_the_second);
    const std::string error = error_of([&] { stage.draw(settings_for(yard(), {96, 54})); });
    expect_words(error, {"96x54", "MiB", "out of memory", "GL_OUT_OF_MEMORY", "choose a smaller size"});
  }
  EXPECT_TRUE(same_bits(stage.lit(s), before));
}

TEST_F(GlObjects, AnOlderErrorIsNotBlamedOnTheNextTexture) {
  glEnable(0xdead);
  EXPECT_NO_THROW(gl::make_texture({.label = "innocent"}));
  const std::vector<std::string> said = gl::take_misuse();
  ASSERT_EQ(said.size(), 1u);
  expect_words(said[0], {"GL_INVALID_ENUM", "before 'innocent'"});
}

// ---- framebuffers ------------------------------------------------------------------------------------------
TEST_F(GlObjects, AFramebufferThatIsNotCompleteSaysWhy) {
  const gl::Texture depth = gl::make_texture({.format = Format::d24});
  const auto refused = [](const gl::FramebufferDesc& d) -> std::string {
    try {
      gl::make_framebuffer(d);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ExitCode::no_gl);
      return e.what();
    }
    return "no error";
  };
  const int live = gl::live_names();
  expect_words(refused({.label = "empty"}),
               {"empty: ", "nothing is attached", "GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT"});
  expect_words(refused({.colours = {&depth}, .label = "depth as colour"}),
               {"depth as colour: ", "not drawn into", "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT"});
  EXPECT_EQ(gl::live_names(), live);
}

// ---- read-backs --------------------------------------------------------------------------------------------
struct OneTexel {
  gl::Texture texture = gl::make_texture({.format = Format::rgba32f, .label = "one-texel"});
  gl::AsyncRead read;
  OneTexel() {
    constexpr float kValue[4] = {1, 2, 3, 4};
    gl::write_texels(texture, kValue);
    read.start(texture);
  }
  bool right() {
    const std::vector<float>* values = read.take(true);
    return values && *values == std::vector<float>{1, 2, 3, 4};
  }
};

// What is first asked for late in a lecture then adds no name late: a count that grows is a leak.
TEST_F(GlObjects, AReadMakesNoName) {
  const gl::Texture texture = gl::make_texture({.format = Format::rgba32f, .label = "one-texel"});
  gl::AsyncRead read;
  const int live = gl::live_names(gl::Kind::buffer);
  read.start(texture);
  EXPECT_EQ(gl::live_names(gl::Kind::buffer), live);
  EXPECT_TRUE(read.take(true));
  EXPECT_EQ(gl::live_names(gl::Kind::buffer), live);
}

TEST_F(GlObjects, AFailedWaitIsAnErrorAndTheNextReadIsRight) {
  OneTexel one;
  {
    const Replaced failing(
        epoxy_glClientWaitSync, +[](GLsync, GLbitfield, GLuint64) -> GLenum { return GL_WAIT_FAILED; });
    expect_words(error_of([&] { one.read.take(false); }), {"one-texel: waiting for the read-back failed"});
  }
  EXPECT_FALSE(one.read.pending());
  one.read.start(one.texture);
  EXPECT_TRUE(one.right());
}

TEST_F(GlObjects, AFailedMapIsAnErrorAndTheNextReadIsRight) {
  OneTexel one;
  {
    const Replaced failing(
        epoxy_glMapBufferRange, +[](GLenum, GLintptr, GLsizeiptr, GLbitfield) -> void* { return nullptr; });
    expect_words(error_of([&] { one.read.take(true); }), {"one-texel: mapping the read-back failed"});
  }
  one.read.start(one.texture);
  EXPECT_TRUE(one.right());
}

// A frame that takes longer than one wait of the driver's: whoever waits gets the data all the same.
decltype(epoxy_glClientWaitSync) g_wait = nullptr;
int g_waits = 0;

TEST_F(GlObjects, ASlowFrameIsWaitedFor) {
  OneTexel one;
  ASSERT_TRUE(one.right());  // from its first call on, epoxy's pointer leads to the driver and not to epoxy's look-up,
                             // which calls what the pointer then holds: the replacement, without end
  one.read.start(one.texture);
  g_wait = glClientWaitSync, g_waits = 0;
  const Replaced slow(
      epoxy_glClientWaitSync, +[](GLsync fence, GLbitfield flags, GLuint64 ns) -> GLenum {
        return ++g_waits < 4 ? GLenum(GL_TIMEOUT_EXPIRED) : g_wait(fence, flags, ns);
      });
  EXPECT_EQ(one.read.take(false), nullptr);
  EXPECT_TRUE(one.read.pending());
  EXPECT_TRUE(one.right());
  EXPECT_EQ(g_waits, 4);
}

}  // namespace
}  // namespace gbl::test
