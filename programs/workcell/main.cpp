// The program workcell.
#include <unistd.h>

#include <iostream>

#include "programs/workcell/options/command_line.hpp"

int main(int count, char** arguments) {
  using namespace pal::workcell;
  try {
    return static_cast<int>(main_program({arguments + 1, arguments + count}, installed_skills(), std::cout,
                                         std::cerr, ::isatty(STDOUT_FILENO) == 1, &std::cin));
  } catch (const Failure& failure) {
    failure.print(std::cerr);
    return static_cast<int>(failure.status());
  }
}
