#include "renderer/gl/object.h"

#include <array>
#include <numeric>

namespace gbl::gl {
namespace {
std::array<int, kKinds> g_live{};  // one GL thread
}

GLuint create_name(Kind kind) {
  GLuint id = 0;
  switch (kind) {
    case Kind::texture: glGenTextures(1, &id); break;
    case Kind::buffer: glGenBuffers(1, &id); break;
    case Kind::vertex_array: glGenVertexArrays(1, &id); break;
    case Kind::framebuffer: glGenFramebuffers(1, &id); break;
    case Kind::renderbuffer: glGenRenderbuffers(1, &id); break;
    case Kind::program: id = glCreateProgram(); break;
    case Kind::query: glGenQueries(1, &id); break;
    case Kind::vertex_shader: id = glCreateShader(GL_VERTEX_SHADER); break;
    case Kind::fragment_shader: id = glCreateShader(GL_FRAGMENT_SHADER); break;
    case Kind::compute_shader: id = glCreateShader(GL_COMPUTE_SHADER); break;
    case Kind::control_shader: id = glCreateShader(GL_TESS_CONTROL_SHADER); break;
    case Kind::evaluation_shader: id = glCreateShader(GL_TESS_EVALUATION_SHADER); break;
    case Kind::transform_feedback: glGenTransformFeedbacks(1, &id); break;
  }
  ++g_live[static_cast<size_t>(kind)];
  return id;
}

void delete_name(Kind kind, GLuint id) {
  switch (kind) {
    case Kind::texture: glDeleteTextures(1, &id); break;
    case Kind::buffer: glDeleteBuffers(1, &id); break;
    case Kind::vertex_array: glDeleteVertexArrays(1, &id); break;
    case Kind::framebuffer: glDeleteFramebuffers(1, &id); break;
    case Kind::renderbuffer: glDeleteRenderbuffers(1, &id); break;
    case Kind::program: glDeleteProgram(id); break;
    case Kind::query: glDeleteQueries(1, &id); break;
    case Kind::vertex_shader:
    case Kind::fragment_shader:
    case Kind::compute_shader:
    case Kind::control_shader:
    case Kind::evaluation_shader: glDeleteShader(id); break;
    case Kind::transform_feedback: glDeleteTransformFeedbacks(1, &id); break;
  }
  --g_live[static_cast<size_t>(kind)];
}

int live_names(Kind kind) { return g_live[static_cast<size_t>(kind)]; }

int live_names() { return std::accumulate(g_live.begin(), g_live.end(), 0); }

}  // namespace gbl::gl
