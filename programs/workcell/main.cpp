// The program workcell.
#include <unistd.h>

#include <iostream>

#include "programs/workcell/options/command_line.hpp"

int main(int count, char** arguments) {
  // A full device and a closed output refuse even nothing.
  if (::write(STDOUT_FILENO, "", 0) < 0) std::cout.setstate(std::ios::badbit);
  return static_cast<int>(pal::workcell::main_program({arguments + 1, arguments + count},
                                                      pal::workcell::installed_skills, std::cout, std::cerr,
                                                      ::isatty(STDOUT_FILENO) == 1, &std::cin));
}
