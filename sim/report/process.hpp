// A program of the system, fed through its standard input. Private to pal_sim.
#pragma once

#include <sys/types.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pal::sim {

/// Where the program is, looked up in PATH as the shell does; a name with a '/' is that file.
std::optional<std::string> find_program(const std::string& name);

class Process {
 public:
  /// Starts `program` (a path) in `folder` (empty: here). Throws std::runtime_error.
  Process(const std::string& program, const std::vector<std::string>& arguments,
          const std::string& folder = {});
  /// Ends the program if it has not been waited for.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// False: the program does not read any more.
  bool write(std::span<const unsigned char> bytes);
  /// Closes the program's input and waits for its end. What went wrong, in the program's own words, or
  /// nothing.
  std::optional<std::string> wait();

 private:
  std::string name_;
  int input_ = -1, messages_ = -1;
  pid_t id_ = -1;
};

}  // namespace pal::sim
