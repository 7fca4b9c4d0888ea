// What the program workcell is asked to do.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim/program/failure.hpp"
#include "sim/program/skills.hpp"

namespace pal::workcell {

struct ListCommand {
  std::vector<std::string> scene_folders;
};

struct RunCommand {
  std::string skill;
  std::string scene = "touch";
  std::vector<std::string> scene_folders;
  std::vector<std::string> settings;  // "name=value"
  std::uint64_t seed = 1;
  double phase = -1;  // ms; negative: drawn
  std::string times = "random";
  std::string output;  // folder; empty: no files
  bool picture = true;
  bool video = false;
  bool plots = true;
  bool live = false;      // shows progress
  bool terminal = false;  // it goes to a terminal
  bool proof = true;
  std::vector<std::string> skill_folders;  // of the skills' PAL
  int sweep = 0;                           // runs; 0: one run
  std::string against;                     // second skill of a sweep
};

/// "workcell list": skills with their parameters and completions, scenes.
ExitStatus list(const ListCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out);

/// "workcell run". Throws Failure.
ExitStatus run(const RunCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out);

/// The whole program: reads the command line, runs the command, prints what failed. `terminal`: `out` is one,
/// so that a line on it can be rewritten.
ExitStatus main_program(const std::vector<std::string>& arguments, const std::vector<KnownSkill>& skills,
                        std::ostream& out, std::ostream& error, bool terminal = false);

}  // namespace pal::workcell
