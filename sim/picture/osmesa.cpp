// An OpenGL context in memory, by OSMesa.
#include <GL/osmesa.h>

#include <vector>

#include "sim/picture/offscreen.hpp"

namespace pal::sim {
namespace {

class Osmesa final : public Offscreen {
 public:
  Osmesa(int width, int height)
      : library_("libOSMesa.so.8", "libosmesa6"),
        buffer_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
        context_(library_.function<decltype(OSMesaCreateContextExt)>("OSMesaCreateContextExt")(
            OSMESA_RGBA, 24, 8, 8, nullptr)) {
    if (context_ == nullptr) throw NoOffscreen("it makes no OpenGL context");
    const auto make_current = library_.function<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    if (!make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, width, height)) {
      destroy();
      throw NoOffscreen("it does not take its context");
    }
    library_.publish();
  }

  ~Osmesa() override { destroy(); }
  Osmesa(const Osmesa&) = delete;
  Osmesa& operator=(const Osmesa&) = delete;

 private:
  void destroy() noexcept {
    library_.function<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext")(context_);
  }

  Library library_;
  std::vector<unsigned char> buffer_;
  OSMesaContext context_;
};

}  // namespace

std::unique_ptr<Offscreen> open_osmesa(int width, int height) {
  return std::make_unique<Osmesa>(width, height);
}

}  // namespace pal::sim
