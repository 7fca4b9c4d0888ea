// Runs a fuzz target on files, for builds without a fuzzer: replay EXTENSION PATH …. A folder stands for all
// the files below it whose names end in EXTENSION (* for all files).
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

void run(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  std::cout << file.string() << std::endl;  // flushed: after a crash the last name is the culprit's
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 2) {
    std::cerr << "usage: replay EXTENSION PATH …\n";
    return 2;
  }
  std::size_t count = 0;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (fs::is_regular_file(arguments[i])) {
      run(arguments[i]);
      ++count;
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(arguments[i])) {
      if (!entry.is_regular_file()) continue;
      if (arguments[0] != "*" && entry.path().extension() != arguments[0]) continue;
      run(entry.path());
      ++count;
    }
  }
  std::cout << count << " inputs\n";
  return count > 0 ? 0 : 1;
}
