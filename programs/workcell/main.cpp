// The program workcell.
#include <unistd.h>

#include <iostream>

#include "programs/workcell/options/command_line.hpp"

int main(int count, char** arguments) {
  return static_cast<int>(pal::workcell::main_program({arguments + 1, arguments + count},
                                                      pal::workcell::installed_skills, std::cout, std::cerr,
                                                      ::isatty(STDOUT_FILENO) == 1, &std::cin));
}
