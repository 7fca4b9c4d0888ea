// A scene of a test, in a folder that lives as long as it.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "sim/scene.hpp"

namespace pal::sim::test {

class SceneText {
 public:
  explicit SceneText(const std::string& text, const std::string& extension = ".scene") {
    std::string name = (std::filesystem::temp_directory_path() / "pal-scene-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder " + name);
    folder_ = name;
    file_ = folder_ / ("test" + extension);
    std::ofstream(file_) << text;
  }
  ~SceneText() { std::filesystem::remove_all(folder_); }
  SceneText(const SceneText&) = delete;
  SceneText& operator=(const SceneText&) = delete;

  Scene scene() const { return {"test", file_}; }
  std::string file() const { return file_.string(); }

 private:
  std::filesystem::path folder_, file_;
};

}  // namespace pal::sim::test
