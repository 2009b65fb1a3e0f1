#include "app/headless.h"

// epoxy first: its GL types and EGL's platform header clash in the other order. EGL itself comes from libEGL, since
// epoxy aborts on eglGetPlatformDisplay.
#include <epoxy/gl.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "renderer/base/error.h"

namespace gbl {

struct HeadlessContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  ~Handles() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }
};

namespace {
[[noreturn]] void no_gl(const char* step) {
  throw Error(ExitCode::no_gl, "EGL", fmt::format("{} failed (0x{:x})", step, eglGetError()),
              "install a GL driver; Mesa's software driver is in libgl1-mesa-dri and libegl-mesa0");
}
}  // namespace

HeadlessContext::HeadlessContext() : handles_(std::make_unique<Handles>()) {
  handles_->display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (handles_->display == EGL_NO_DISPLAY || !eglInitialize(handles_->display, nullptr, nullptr))
    no_gl("opening a display without a screen");
  if (!eglBindAPI(EGL_OPENGL_API)) no_gl("choosing OpenGL");
  const EGLint attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  handles_->context = eglCreateContext(handles_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (handles_->context == EGL_NO_CONTEXT) no_gl("creating an OpenGL 3.3 core context");
  if (!eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context))
    no_gl("making the context current without a surface");
}

HeadlessContext::~HeadlessContext() = default;

}  // namespace gbl
