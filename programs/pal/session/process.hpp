// Other programs that the commands use: git, GNU parallel, Slurm, workcell.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace pal::program {

struct Spoken {
  int status = -1;  // of its exit; negative: it did not run, or a signal ended it
  std::string out;
};

/// Runs it and waits for its end. What it says of errors goes where ours goes.
Spoken run_and_read(const std::string& program, std::vector<std::string> words);

/// Runs it; its output goes into the file `log`. Calls `look` a few times a second. Once that returns false,
/// the program gets SIGTERM, again and again until it ends. Returns its exit status; negative as in Spoken.
int run_and_watch(const std::string& program, std::vector<std::string> words, const std::string& log,
                  const std::function<bool()>& look);

/// The path of the program that runs now.
std::string own_program();

}  // namespace pal::program
