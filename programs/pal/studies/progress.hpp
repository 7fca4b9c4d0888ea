// How far a study is, on a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "programs/pal/session/console.hpp"

namespace pal::program {

/// "1 min 20 s", "3 h 5 min": for people, of a time that is estimated.
std::string about(double seconds);

/// One line that is written over. Clears it when it ends. Without a terminal it writes nothing.
class Progress {
 public:
  Progress(std::size_t all, const Console& console) : all_(all), console_(console) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void show(std::size_t done);

 private:
  std::size_t all_;
  const Console& console_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point shown_{};
  bool any_ = false;
};

}  // namespace pal::program
