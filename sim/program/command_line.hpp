// What the program workcell is asked to do.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "runtime/run_control.hpp"
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
  bool seed_given = false;  // then it chooses the machine, too
  double phase = -1;        // ms; negative: drawn
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
  std::string after;                       // a skill that is run before; empty: none
  double paced = 0;                        // station seconds a second of real time; 0: as fast as can be
  bool control = false;                    // paused, stepped and stopped by commands on the standard input
  std::string faults;                      // a file of faults on demand; empty: nothing goes wrong
  std::string links = "process";           // what carries the bytes of lines
};

struct ServePortCommand {
  std::string device;
  std::string scene = "touch";
  std::vector<std::string> scene_folders;
  std::uint64_t seed = 1;
  bool pty = false;    // at a pseudo-terminal, as also without any of the three
  int tcp = -1;        // port; negative: not by TCP
  std::string serial;  // path of a serial port; empty: at none
  std::string link;    // a symbolic link to the pseudo-terminal
};

struct OperationCommand {
  std::string file;  // .op.json
  std::string scene = "touch";
  std::vector<std::string> scene_folders;
  std::uint64_t seed = 1;
  std::string times = "random";
  std::size_t steps = 0;                 // at most so many; 0: until the operation ends
  std::string log;                       // a line of JSON a step; empty: none
  std::string from;                      // the icon to start from; empty: START
  std::vector<std::string> breakpoints;  // "ICON" or "ICON=CODE"
  bool interactive = false;              // obeys lines of the input
};

/// "workcell operation run". `in`: where an interactive run gets its commands. Throws Failure.
ExitStatus run_operation(const OperationCommand& command, const std::vector<KnownSkill>& skills,
                         std::istream* in, std::ostream& out, std::ostream& error);

/// "workcell list": skills with their parameters and completions, scenes.
ExitStatus list(const ListCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out);

/// "workcell run". Throws Failure.
ExitStatus run(const RunCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out);

/// "workcell serve-port": an emulated device for any program, in real time, until `control` stops it. Throws
/// Failure.
ExitStatus serve_port(const ServePortCommand& command, const runtime::RunControl& control, std::ostream& out);

/// The whole program: reads the command line, runs the command, prints what failed. `terminal`: `out` is one,
/// so that a line on it can be rewritten. `in`: for commands that are given while an operation runs.
ExitStatus main_program(const std::vector<std::string>& arguments, const std::vector<KnownSkill>& skills,
                        std::ostream& out, std::ostream& error, bool terminal = false,
                        std::istream* in = nullptr);

}  // namespace pal::workcell
