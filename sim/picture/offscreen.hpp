// OpenGL without a screen. Private to pal_sim.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace pal::sim {

/// Drawing is not possible this way; the text says why.
class NoOffscreen : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// While it lives, its OpenGL context is current on the thread that made it.
class Offscreen {
 public:
  virtual ~Offscreen() = default;
};

/// Both load their library when called, so that a machine without it can still run everything else. Throw
/// NoOffscreen.
std::unique_ptr<Offscreen> open_egl();
std::unique_ptr<Offscreen> open_osmesa(int width, int height);

/// A library that was loaded by name; never unloaded, for drivers do not survive that.
class Library {
 public:
  /// Throws NoOffscreen.
  explicit Library(const char* name);

  /// Throws NoOffscreen if the library has no such function.
  template <class Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;
  void* handle_;
};

}  // namespace pal::sim
