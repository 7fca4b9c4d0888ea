#include "sim/picture/offscreen.hpp"

#include <dlfcn.h>

namespace pal::sim {

// Global, because MuJoCo looks for its OpenGL functions among what the program has loaded.
Library::Library(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_GLOBAL)) {
  if (handle_ == nullptr) throw NoOffscreen(std::string(name) + " cannot be loaded");
}

void* Library::symbol(const char* name) const {
  void* found = dlsym(handle_, name);
  if (found == nullptr) throw NoOffscreen(std::string("the library has no ") + name);
  return found;
}

}  // namespace pal::sim
