// OpenGL without a screen. Private to pal_sim.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace pal::sim {

/// Drawing is not possible this way; the text says why.
class NoOffscreen : public std::runtime_error {
 public:
  explicit NoOffscreen(const std::string& cause, std::string packages = "")
      : std::runtime_error(cause), packages_(std::move(packages)) {}
  /// Debian's packages that are not installed, which is the cause. Empty: the cause is another.
  const std::string& packages() const { return packages_; }

 private:
  std::string packages_;
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
  /// `packages`: those that have it. Throws NoOffscreen.
  Library(const char* name, const std::string& packages);

  /// MuJoCo takes its OpenGL functions from the first published library of the process, whether a context was
  /// made by it or not. So only one that has a context is published.
  void publish() const;

  /// Where the library lies.
  std::filesystem::path folder() const;

  /// Throws NoOffscreen if the library has no such function.
  template <class Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;
  std::string name_;
  void* handle_;
};

}  // namespace pal::sim
