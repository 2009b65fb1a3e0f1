#include "app/headless.h"

// epoxy first: its GL types and EGL's platform header clash in the other order. EGL itself comes from libEGL, since
// epoxy aborts on eglGetPlatformDisplay.
#include <epoxy/gl.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "renderer/base/error.h"

namespace gbl {

namespace {
struct ApiRow {
  EGLenum egl;
  const char* label;
  EGLint attributes[7];
};
constexpr ApiRow kApiRows[] = {
    {EGL_OPENGL_API,
     "OpenGL 3.3 core",
     {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE}},
    {EGL_OPENGL_ES_API,
     "OpenGL ES 3.0",
     {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE, EGL_NONE, EGL_NONE}},
};

[[noreturn]] void no_gl(const std::string& step) {
  throw Error(ExitCode::no_gl, "EGL", fmt::format("{} failed (0x{:x})", step, eglGetError()),
              "install a GL driver; Mesa's software driver is in libgl1-mesa-dri and libegl-mesa0");
}

// Opened once, and kept while the program runs: all contexts share it, and closing it would end each of them.
EGLDisplay opened_display() {
  static const EGLDisplay g_display = [] {
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
      no_gl("opening a display without a screen");
    return display;
  }();
  return g_display;
}

void make_current(EGLDisplay display, EGLContext context) {
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
    no_gl("making the context current without a surface");
}
}  // namespace

struct HeadlessContext::Handles {
  EGLDisplay display = opened_display();
  EGLContext before = eglGetCurrentContext(), context = EGL_NO_CONTEXT;
  ~Handles() {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, before);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
  }
};

HeadlessContext::HeadlessContext(gl::Api api) : handles_(std::make_unique<Handles>()) {
  const ApiRow& row = kApiRows[static_cast<size_t>(api)];
  if (!eglBindAPI(row.egl)) no_gl(fmt::format("choosing {}", row.label));
  handles_->context = eglCreateContext(handles_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, row.attributes);
  if (handles_->context == EGL_NO_CONTEXT) no_gl(fmt::format("creating a context of {}", row.label));
  make_current(handles_->display, handles_->context);
}

HeadlessContext::~HeadlessContext() = default;

}  // namespace gbl
