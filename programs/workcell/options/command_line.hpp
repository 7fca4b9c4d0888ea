// The command line of the program workcell.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "operations/executor.hpp"
#include "pal/runtime/cost_policy.hpp"
#include "pal/runtime/run_control.hpp"
#include "programs/workcell/session/failure.hpp"
#include "programs/workcell/session/skills.hpp"

namespace pal::workcell {

struct ListCommand {
  std::vector<std::string> scene_folders;
  std::string cell;                        // tell of this scene's cell for programs; empty: do not
  std::vector<std::string> skill_folders;  // with the PAL of the skills; the first that is there counts
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
  int sweep = 0;                             // runs; 0: one run
  std::string against;                       // second skill of a sweep
  std::string after;                         // a skill that is run before; empty: none
  double paced = 0;                          // station seconds a second of real time; 0: as fast as can be
  bool real_time = false;                    // the skill runs by the wall clock
  double limit = 600;                        // s; a skill that takes longer is ended
  bool control = false;                      // paused, stepped and stopped by commands on the standard input
  std::string faults;                        // a file of faults on demand; empty: nothing goes wrong
  std::string on_broken_promise = "report";  // or contingency, stop
  std::string live_trace;                    // a file that gets the events as they happen; empty: none
  std::string links = "process";             // what carries the bytes of lines
  std::string measure;                       // file for measured times; empty: nothing is measured
};

struct ServePortCommand {
  std::vector<std::string> devices;  // of one cell; at least one
  std::string scene = "touch";
  std::vector<std::string> scene_folders;
  std::uint64_t seed = 1;
  bool pty = false;    // at a pseudo-terminal, as also without any of the three
  int tcp = -1;        // port; negative: not by TCP
  std::string serial;  // path of a serial port; empty: at none
  std::string link;    // a symbolic link to the pseudo-terminal
};

struct NewSkillCommand {
  std::string name;
  std::string like;          // a skill that is there
  std::string from;          // or a PAL file
  std::string output;        // folder; empty: named like the skill
  std::string skill_folder;  // where the workcell's skills stand as texts
};

struct OperationCommand {
  std::string file;  // .op.json
  std::string scene = "touch";
  std::vector<std::string> scene_folders;
  std::uint64_t seed = 1;
  std::string times = "random";
  std::size_t steps = 0;                 // at most this many; 0: until the operation ends
  std::string log;                       // a line of JSON a step; empty: none
  std::string from;                      // the icon to start from; empty: START
  std::vector<std::string> breakpoints;  // "ICON" or "ICON=CODE"
  std::vector<std::string> answers;      // to questions, "ICON=ANSWER"
  std::string faults;                    // a file of faults, in the first skill; empty: none
  std::string on_broken_promise = "report";
  bool interactive = false;  // obeys lines of the input
  bool at_server = false;    // not here
  std::string announcement;  // of the server
  bool detach = false;
};

struct ServeCommand {
  std::string scene = "touch";
  std::vector<std::string> scene_folders;
  std::uint64_t seed = 1;
  std::string times = "random";
  std::string address = "127.0.0.1";
  int port = 7400;
  int line_port = -1;  // negative: no lines over TCP
  bool line_terminal = false;
  std::string line_serial;
  unsigned baud = 9600;
  std::vector<std::string> hosts, origins;  // allowed besides
  std::string announcement;                 // where the token is written; empty: the usual place
  std::string faults;                       // a file of faults, in the first skill; empty: none
  std::string on_broken_promise = "report";
  bool goes_on = false;  // when the client goes that has the controls
  double paced = 1;      // station seconds a second; 0: as fast as can be
  bool fast = false;
  std::string log;
  std::string page;   // the folder of the page for browsers; empty: the installed one, or none
  std::string store;  // the folder of operations on the disk; empty: none
  bool open = false;  // print the address for a browser
};

/// "workcell serve": until Ctrl-C. Throws Failure.
ExitStatus serve(const ServeCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out);

/// What a client asks of a server that runs.
struct RemoteCommand {
  std::string verb;  // run, load, step, pause, stop, resume, from, set, break, clear, state, watch
  std::string file;
  std::string announcement;  // of the server; empty: the usual place
  std::string log, from;
  std::vector<std::string> breakpoints;
  bool detach = false;
  std::vector<std::string> arguments{};  // of from, set and break
};

/// Throws Failure.
ExitStatus command_server(const RemoteCommand& command, std::ostream& out, std::ostream& error);

/// "ICON" or "ICON=CODE". Throws Failure.
operations::Breakpoint breakpoint_of(const std::string& text);
/// How a command ends after which the operation is in this state, with this last code.
ExitStatus status_of(operations::ExecutionState state, int code);
/// "worst", "best", else random.
runtime::CostPolicy times_named(const std::string& name);

/// "workcell operation run". `in`: where an interactive run gets its commands. Throws Failure.
ExitStatus run_operation(const OperationCommand& command, const std::vector<KnownSkill>& skills,
                         std::istream* in, std::ostream& out, std::ostream& error);

/// "workcell list": skills with their parameters and completions, scenes.
ExitStatus list(const ListCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out);

/// "workcell run". Throws Failure.
ExitStatus run(const RunCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out);

/// "workcell new-skill". Throws Failure.
ExitStatus new_skill(const NewSkillCommand& command, const std::vector<KnownSkill>& skills,
                     std::ostream& out);

/// "workcell serve-port": emulated devices of one cell for any program, in real time, until `control` stops
/// it. Throws Failure.
ExitStatus serve_port(const ServePortCommand& command, const runtime::RunControl& control, std::ostream& out);

/// The whole program: reads the command line, runs the command, prints what failed. `terminal`: `out` is a
/// terminal, so a line on it can be rewritten. Runs nothing if `out` has failed already. `in`: for commands
/// that are given while an operation runs. Without a source of skills there are none.
ExitStatus main_program(const std::vector<std::string>& arguments, const SkillSource& skills,
                        std::ostream& out, std::ostream& error, bool terminal = false,
                        std::istream* in = nullptr);

}  // namespace pal::workcell
