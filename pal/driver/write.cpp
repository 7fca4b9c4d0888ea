#include "pal/driver/write.hpp"

#include <ostream>

namespace pal::driver {

ExitStatus write_and_list(const std::vector<OutputFile>& files, const Console& console) {
  if (const auto problem = write_files(files)) {
    console.err << "pal: " << *problem << "\n";
    return ExitStatus::usage;
  }
  for (const OutputFile& file : files) console.out << file.path << "\n";
  return ExitStatus::all_hold;
}

}  // namespace pal::driver
