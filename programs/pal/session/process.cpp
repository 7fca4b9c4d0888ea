#include "programs/pal/session/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>

extern char** environ;

namespace pal::program {
namespace {

/// Its process, or -1. `actions` say where its output goes.
pid_t start(const std::string& program, std::vector<std::string> words, posix_spawn_file_actions_t& actions) {
  words.insert(words.begin(), program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = -1;
  const int failed = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  return failed == 0 ? child : -1;
}

int status_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

Spoken run_and_read(const std::string& program, std::vector<std::string> words) {
  Spoken result;
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return result;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const pid_t child = start(program, std::move(words), actions);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  std::array<char, 4096> piece{};
  for (ssize_t count = 0; child > 0 && (count = ::read(ends[0], piece.data(), piece.size())) > 0;)
    result.out.append(piece.data(), static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 0;
  if (child > 0 && ::waitpid(child, &status, 0) == child) result.status = status_of(status);
  return result;
}

int run_and_watch(const std::string& program, std::vector<std::string> words, const std::string& log,
                  const std::function<bool()>& look) {
  using namespace std::chrono_literals;
  constexpr auto pause = 100ms;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0666);
  ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  const pid_t child = start(program, std::move(words), actions);
  ::posix_spawn_file_actions_destroy(&actions);
  if (child <= 0) return -1;
  // Again after a while: to GNU parallel the first one means to begin nothing more, the second to end.
  constexpr auto between = 1s;
  std::chrono::steady_clock::time_point told{};
  int status = 0;
  for (;;) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) return status_of(status);
    if (ended < 0 && errno != EINTR) return -1;
    const auto now = std::chrono::steady_clock::now();
    if (!look() && now - told > between) {
      told = now;
      ::kill(child, SIGTERM);
    }
    std::this_thread::sleep_for(pause);
  }
}

std::string own_program() {
  std::error_code problem;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", problem);
  return problem ? std::string("pal") : path.string();
}

}  // namespace pal::program
