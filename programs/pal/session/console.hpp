// What a command may use: streams and files are passed in, so that every command can be tested from strings.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "pal/support/file_system.hpp"

namespace pal::program {

struct Console {
  std::ostream& out;
  std::ostream& err;
  const FileSystem& files;
  bool terminal = false;    // `out` is watched: a long search may show its progress
  bool colour_out = false;  // colours go to `out`
  bool colour_err = false;  // colours go to `err`
};

/// The text of a file with runs that the command line names; says on `console.err` why it cannot be read.
std::optional<std::string> read_runs(const std::string& path, const Console& console);

}  // namespace pal::program
