// The program pal.
#include <unistd.h>

#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "pal/support/file_system.hpp"
#include "programs/pal/options/command_line.hpp"
#include "programs/pal/session/colour.hpp"
#include "programs/pal/session/patience.hpp"

using pal::program::ExitStatus;

namespace {

/// A report that could not be written is no success.
ExitStatus delivered(ExitStatus status) {
  std::cout.flush();
  if (std::cout) return status;
  std::cerr << "pal: cannot write the standard output: is it open, and is there space?\n";
  return ExitStatus::usage;
}

}  // namespace

int main(int count, char** arguments) {
  const pal::DiskFileSystem files;
  try {
    const bool out = ::isatty(STDOUT_FILENO) == 1, err = ::isatty(STDERR_FILENO) == 1;
    const auto status = static_cast<int>(
        delivered(pal::program::run(std::vector<std::string>(arguments + 1, arguments + count),
                                    {std::cout, std::cerr, files, out, pal::program::wants_colour(out),
                                     pal::program::wants_colour(err)})));
    if (pal::program::is_work_left()) ::_exit(status);  // it still uses what would be cleared up
    return status;
  } catch (const std::bad_alloc&) {
    std::cerr << "pal: there is not enough memory; with --max-memory SIZE or --max-states N a proof gives up "
                 "sooner\n";
    return static_cast<int>(ExitStatus::usage);
  } catch (const std::exception& error) {
    std::cerr << "pal: internal error: " << error.what()
              << " (please report it with the files that cause it)\n";
    return static_cast<int>(ExitStatus::usage);
  }
}
