#include "programs/pal/session/write.hpp"

#include <filesystem>
#include <ostream>
#include <set>

namespace pal::program {

std::vector<std::string> inputs_of(const Session& session) {
  std::vector<std::string> inputs;
  for (std::size_t file = 0; file < session.sources.size(); ++file)
    inputs.push_back(session.sources.name(FileId(file)));
  return inputs;
}

bool may_write(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs,
               const Console& console) {
  std::set<std::string> read;
  for (const std::string& input : inputs) read.insert(console.files.identity(input));
  for (const std::string& output : outputs) {
    const char* why = nullptr;
    if (output.empty()) continue;
    if (read.contains(console.files.identity(output)))
      why = "it is one of the files that were read";
    else if (output.ends_with(".pal"))
      why = "a name that ends in .pal is for PAL files";
    if (why == nullptr) continue;
    console.err << "pal: cannot write " << output << ": " << why << "\n";
    return false;
  }
  return true;
}

ExitStatus write_and_list(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs,
                          const Console& console) {
  std::vector<std::string> outputs;
  for (const OutputFile& file : files) outputs.push_back(file.path);
  if (!may_write(outputs, inputs, console)) return ExitStatus::usage;
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

}  // namespace pal::program
