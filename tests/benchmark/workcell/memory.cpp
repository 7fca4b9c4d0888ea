// The most memory that the program workcell takes for one run, as a user starts it.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "tests/benchmark/workcell/row.hpp"

namespace pal::bench {
namespace {

double megabytes(std::vector<std::string> words) {
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "workcell";
  words.insert(words.begin(), program.string());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t id = -1;
  const int problem = posix_spawn(&id, program.c_str(), &quiet, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&quiet);
  if (problem != 0) throw std::runtime_error("build the target workcell, too");
  int status = 0;
  rusage used{};
  if (wait4(id, &status, 0, &used) != id || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error("workcell did not end with status 0");
  return static_cast<double>(used.ru_maxrss) / 1024;
}

}  // namespace

std::vector<Row> memory_rows() {
  const double run = megabytes({"run", "touch", "--no-picture"});
  return {{"memory of a run without pictures, proof included", fmt::format("{:.0f} MB", run), "under 150 MB",
           run < 150}};
}

}  // namespace pal::bench
