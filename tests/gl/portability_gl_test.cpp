// Pitfalls of the sources that are of GL and of no picture, each a test of the same name: what the call of the source does,
// and what the lab does instead.
#include "renderer/gl/object.h"
#include "renderer/passes/frame_block.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Portability : public GlTest {
 protected:
  static GLenum error() {
    const GLenum first = glGetError();
    while (glGetError() != GL_NO_ERROR) {
    }
    return first;
  }
  static gl::Framebuffer with_depth(const gl::Texture& depth) {
    return gl::make_framebuffer({.depth = &depth, .label = "portability"});
  }
  static gl::Texture depth_texture(Format format) {
    return gl::make_texture({.size = {4, 4}, .format = format, .label = "portability.depth"});
  }
};

// `unsized-rgba-is-8bit`: the engine blog asks for GL_RGBA with GL_FLOAT and believes that floats are stored.
TEST_F(Portability, UnsizedRgbaIs8Bit) {
  const auto red = [](GLint internal_format) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, internal_format, 4, 4, 0, GL_RGBA, GL_FLOAT, nullptr);
    GLint type = 0, bits = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_RED_TYPE, &type);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_RED_SIZE, &bits);
    glDeleteTextures(1, &texture);
    return std::pair(type, bits);
  };
  EXPECT_EQ(red(GL_RGBA), std::pair(GL_UNSIGNED_NORMALIZED, 8));
  EXPECT_EQ(red(GL_RGBA16F), std::pair(GL_FLOAT, 16));
}

// `depth-blit-mismatch`: depth is copied between equal formats only; the picture just stays as it was.
TEST_F(Portability, DepthBlitMismatch) {
  const auto blit = [](const gl::Framebuffer& from, const gl::Framebuffer& to) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.id());
    glBlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    return error();
  };
  const gl::Texture d24 = depth_texture(Format::d24), d32f = depth_texture(Format::d32f),
                    other = depth_texture(Format::d32f);
  const gl::Framebuffer a = with_depth(d24), b = with_depth(d32f), c = with_depth(other);
  EXPECT_EQ(blit(a, b), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(blit(b, c), GLenum(GL_NO_ERROR));
}

// `depthmask-false-clear`: a clear obeys the mask, so what a pass left off keeps an old depth.
TEST_F(Portability, DepthmaskFalseClear) {
  const gl::Texture depth = depth_texture(Format::d32f);
  const gl::Framebuffer into = with_depth(depth);
  glBindFramebuffer(GL_FRAMEBUFFER, into.id());
  const auto cleared_to = [](float value, bool mask) {
    glDepthMask(mask);
    glClearDepth(value);
    glClear(GL_DEPTH_BUFFER_BIT);
    float read = -1;
    glReadPixels(1, 1, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &read);
    return read;
  };
  glDisable(GL_SCISSOR_TEST);
  EXPECT_EQ(cleared_to(0.25f, true), 0.25f);
  EXPECT_EQ(cleared_to(1, false), 0.25f) << "it stays";
  EXPECT_EQ(cleared_to(1, true), 1);
}

// `quads-in-core`: tutorial 08-2 draws its lighting pass as GL_QUADS, and nothing is lit.
TEST_F(Portability, QuadsInCore) {
  GLuint vertices = 0;
  glGenVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  glDrawArrays(0x0007 /* GL_QUADS */, 0, 4);
  EXPECT_EQ(error(), GLenum(GL_INVALID_ENUM));
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &vertices);
}

// `ubo-64000`: 1000 lights of 64 bytes are more than GL promises of a uniform block. Ours is small, and lights lie in a texture.
TEST_F(Portability, Ubo64000) {
  constexpr size_t kPromised = 16384;
  GLint largest = 0;
  glGetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &largest);
  EXPECT_GE(static_cast<size_t>(largest), kPromised);
  EXPECT_LE(sizeof(shared::FrameBlock), kPromised);
}

// `snorm-readback`: glReadPixels cuts negative numbers of a SNORM target off, so half of an encoding looks broken.
TEST_F(Portability, SnormReadback) {
  GLuint texture = 0, framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8_SNORM, 4, 4, 0, GL_RGBA, GL_BYTE, nullptr);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  float cut = 0, whole = 0;
  if (complete) {
    const float minus_half[4] = {-0.5f, -0.5f, -0.5f, 1};
    glColorMask(true, true, true, true);
    glDisable(GL_SCISSOR_TEST);
    glClearBufferfv(GL_COLOR, 0, minus_half);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);  // the default; a test before this one may have read otherwise
    glReadPixels(1, 1, 1, 1, GL_RED, GL_FLOAT, &cut);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
    glReadPixels(1, 1, 1, 1, GL_RED, GL_FLOAT, &whole);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
  }
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(1, &texture);
  if (!complete) GTEST_SKIP() << "this driver does not draw into RGBA8_SNORM";
  EXPECT_EQ(cut, 0) << "as a driver reads by default";
  EXPECT_NEAR(whole, -0.5, 1.0 / 127);
}

}  // namespace
}  // namespace gbl::test
