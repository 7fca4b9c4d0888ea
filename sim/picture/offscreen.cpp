#include "sim/picture/offscreen.hpp"

#include <dlfcn.h>
#include <linux/limits.h>

#include <array>

namespace pal::sim {

Library::Library(const char* name, const std::string& packages)
    : name_(name), handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ != nullptr) return;
  const char* const said = dlerror();
  const std::string cause = said != nullptr ? said : name_ + " cannot be loaded";
  // The C library's words for a file that is not there, be it this one or one that it needs.
  const bool missing = cause.find("No such file") != std::string::npos;
  throw NoOffscreen(cause, missing ? packages : "");
}

void Library::publish() const {
  dlopen(name_.c_str(), RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD);
}

std::filesystem::path Library::folder() const {
  std::array<char, PATH_MAX> origin{};
  if (dlinfo(handle_, RTLD_DI_ORIGIN, origin.data()) != 0) return {};
  return origin.data();
}

void* Library::symbol(const char* name) const {
  void* found = dlsym(handle_, name);
  if (found == nullptr) throw NoOffscreen(name_ + " has no " + name);
  return found;
}

}  // namespace pal::sim
