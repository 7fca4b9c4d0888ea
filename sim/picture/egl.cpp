// An OpenGL context without a window, by EGL.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/picture/offscreen.hpp"

namespace pal::sim {
namespace {

/// The names of EGL's errors, from EGL_SUCCESS on.
constexpr std::array<const char*, 15> errors{
    "EGL_SUCCESS",       "EGL_NOT_INITIALIZED", "EGL_BAD_ACCESS",        "EGL_BAD_ALLOC",
    "EGL_BAD_ATTRIBUTE", "EGL_BAD_CONFIG",      "EGL_BAD_CONTEXT",       "EGL_BAD_CURRENT_SURFACE",
    "EGL_BAD_DISPLAY",   "EGL_BAD_MATCH",       "EGL_BAD_NATIVE_PIXMAP", "EGL_BAD_NATIVE_WINDOW",
    "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE",     "EGL_CONTEXT_LOST"};

/// Mesa's drivers lie below the folder of its libraries; later versions have them in one library there.
bool has_drivers(const std::filesystem::path& libraries) {
  const auto any = [](const std::filesystem::path& folder, const auto& fits) {
    std::error_code none;
    return std::any_of(std::filesystem::directory_iterator(folder, none), {},
                       [&](const auto& each) { return fits(each.path().filename().string()); });
  };
  return any(libraries / "dri", [](const std::string& name) { return name.ends_with("_dri.so"); }) ||
         any(libraries, [](const std::string& name) { return name.starts_with("libgallium"); });
}

class Egl final : public Offscreen {
 public:
  Egl() : library_("libEGL.so.1", "libegl1 libgl1-mesa-dri") {
    const auto get = library_.function<decltype(eglGetProcAddress)>("eglGetProcAddress");
    const auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get("eglGetPlatformDisplayEXT"));
    if (get_display == nullptr) throw failed("it has no platforms");
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY ||
        !call<decltype(eglInitialize)>("eglInitialize")(display_, nullptr, nullptr))
      throw failed("it has no surfaceless display");
    try {
      make_current();
    } catch (const NoOffscreen&) {
      close();
      throw;
    }
    library_.publish();
  }

  ~Egl() override { close(); }
  Egl(const Egl&) = delete;
  Egl& operator=(const Egl&) = delete;

 private:
  template <class Function>
  Function* call(const char* name) const {
    return library_.function<Function>(name);
  }

  /// With the error of the latest call. Packages are named only where there is no driver at all.
  NoOffscreen failed(const char* what) const {
    const auto error = static_cast<std::size_t>(call<decltype(eglGetError)>("eglGetError")());
    const std::size_t which = error - EGL_SUCCESS;
    const std::string name = which < errors.size() ? errors[which] : fmt::format("error {:#x}", error);
    const std::string cause = which == 0 ? what : fmt::format("{} ({})", what, name);
    if (has_drivers(library_.folder())) return NoOffscreen(cause);
    return NoOffscreen(cause + ", for there is no driver", "libgl1-mesa-dri");
  }

  void make_current() {
    if (!call<decltype(eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API)) throw failed("it has no OpenGL");
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!call<decltype(eglChooseConfig)>("eglChooseConfig")(display_, wanted.data(), &config, 1, &count) ||
        count == 0)
      throw failed("it has no configuration for OpenGL");
    context_ =
        call<decltype(eglCreateContext)>("eglCreateContext")(display_, config, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT ||
        !call<decltype(eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw failed("it makes no OpenGL context");
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
