// An OpenGL context without a window, by EGL.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

#include "sim/picture/offscreen.hpp"

namespace pal::sim {
namespace {

class Egl final : public Offscreen {
 public:
  Egl() : library_("libEGL.so.1") {
    const auto get = library_.function<decltype(eglGetProcAddress)>("eglGetProcAddress");
    const auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get("eglGetPlatformDisplayEXT"));
    if (get_display == nullptr) throw NoOffscreen("EGL has no platforms");
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY ||
        !call<decltype(eglInitialize)>("eglInitialize")(display_, nullptr, nullptr))
      throw NoOffscreen("EGL has no surfaceless display");
    try {
      make_current();
    } catch (const NoOffscreen&) {
      close();
      throw;
    }
  }

  ~Egl() override { close(); }
  Egl(const Egl&) = delete;
  Egl& operator=(const Egl&) = delete;

 private:
  template <class Function>
  Function* call(const char* name) const {
    return library_.function<Function>(name);
  }

  void make_current() {
    if (!call<decltype(eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API)) throw NoOffscreen("EGL has no OpenGL");
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!call<decltype(eglChooseConfig)>("eglChooseConfig")(display_, wanted.data(), &config, 1, &count) ||
        count == 0)
      throw NoOffscreen("EGL has no configuration for OpenGL");
    context_ =
        call<decltype(eglCreateContext)>("eglCreateContext")(display_, config, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT ||
        !call<decltype(eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw NoOffscreen("EGL makes no OpenGL context");
  }

  void close() noexcept {
    call<decltype(eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                                     EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT)
      call<decltype(eglDestroyContext)>("eglDestroyContext")(display_, context_);
    call<decltype(eglTerminate)>("eglTerminate")(display_);
  }

  Library library_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Offscreen> open_egl() {
  return std::make_unique<Egl>();
}

}  // namespace pal::sim
