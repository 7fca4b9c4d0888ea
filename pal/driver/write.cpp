#include "pal/driver/write.hpp"

#include <filesystem>
#include <ostream>

namespace pal::driver {

ExitStatus write_and_list(const std::vector<OutputFile>& files, const Console& console) {
  if (const auto problem = write_files(files)) {
    console.err << "pal: " << *problem << "\n";
    return ExitStatus::usage;
  }
  // What went through a pipe, perhaps the standard output itself, is there to be read and not to be listed.
  std::error_code error;
  for (const OutputFile& file : files) {
    if (std::filesystem::is_regular_file(file.path, error)) console.out << file.path << "\n";
  }
  return ExitStatus::all_hold;
}

}  // namespace pal::driver
