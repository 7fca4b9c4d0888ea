// A program that runs beside the monitor.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/val/instruction.hpp"

namespace pal::sim::val {

struct RunningProgram {
  RunningProgram(std::string program, std::vector<std::string> program_lines, long times, Instruction runner)
      : name(std::move(program)),
        lines(std::move(program_lines)),
        count(times),
        instruction(std::move(runner)) {}

  std::string name;
  std::vector<std::string> lines;  // as they were when it began
  long count;                      // times to go; below 0: for ever
  std::size_t step = 0;
  bool begun = false;  // the step
  Instruction instruction;
};

}  // namespace pal::sim::val
