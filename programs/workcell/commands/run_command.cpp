// workcell run: one skill in one scene, with its reports. Refuses what --set gives wrongly.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "pal/support/duration_text.hpp"
#include "pal/support/nearest.hpp"
#include "pal/support/output.hpp"
#include "programs/workcell/options/command_line.hpp"
#include "programs/workcell/reports/comparison.hpp"
#include "programs/workcell/reports/live_trace.hpp"
#include "programs/workcell/reports/report_files.hpp"
#include "programs/workcell/session/control_terminal.hpp"
#include "programs/workcell/session/fault_file.hpp"
#include "programs/workcell/session/interrupt.hpp"
#include "programs/workcell/session/needed_tool.hpp"
#include "runtime/drivers/streams/carrier.hpp"
#include "runtime/drivers/streams/outside.hpp"

namespace pal::workcell {
namespace {

/// As skills_pal/workcell_real_time.pal declares; all skills hold their requirements there.
constexpr Tolerances in_real_time = {.device = std::chrono::milliseconds(1),
                                     .cost = std::chrono::microseconds(70)};

const KnownSkill& find_skill(const std::string& wanted, const std::vector<KnownSkill>& skills) {
  std::vector<std::string> names;
  for (const KnownSkill& known : skills) {
    if (known.name == wanted) return known;
    names.push_back(known.name);
  }
  const auto nearest = pal::nearest(wanted, names);
  throw Failure(
      ExitStatus::wrong_specification, "skill '" + wanted + "'", "there is no skill of this name",
      nearest ? "did you mean '" + *nearest + "'?" : "workcell list shows the skills that there are");
}

double parse_number(const std::string& setting, const std::string& text, runtime::ParameterType type) {
  const bool is_truth = type == runtime::ParameterType::boolean;
  if (is_truth && (text == "true" || text == "TRUE")) return 1;
  if (is_truth && (text == "false" || text == "FALSE")) return 0;
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size())
    throw Failure(ExitStatus::wrong_specification, "--set " + setting,
                  "'" + text + "' is " + (is_truth ? "neither TRUE nor FALSE" : "not a number"),
                  is_truth ? "write TRUE or FALSE" : "write the value without its unit");
  return value;
}

runtime::ParameterValue parse_setting(const std::string& setting, const runtime::Skill& skill) {
  const std::string place = "--set " + setting;
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos)
    throw Failure(ExitStatus::usage, place, "a parameter is set by name=value",
                  "write --set approach-speed=20");
  const std::string name = setting.substr(0, equals);
  std::vector<std::string> names;
  for (const runtime::ParameterSpec& parameter : skill.description().parameters) {
    names.emplace_back(parameter.name);
    if (parameter.name != name) continue;
    const std::string written = setting.substr(equals + 1);
    const bool text = parameter.type == runtime::ParameterType::text;
    const double value = text ? 0 : parse_number(setting, written, parameter.type);
    try {
      text ? runtime::check_parameter(parameter, written) : runtime::check_parameter(parameter, value);
    } catch (const runtime::ParameterError& problem) {
      throw Failure(ExitStatus::wrong_specification, place, problem.what(),
                    text ? fmt::format("its default is \"{}\"", parameter.default_text)
                         : fmt::format("its default is {:g} {}", parameter.default_value, parameter.unit));
    }
    if (text) return {.name = name, .text = written};
    return {name, value};
  }
  const auto nearest = pal::nearest(name, names);
  throw Failure(
      ExitStatus::wrong_specification, place,
      fmt::format("skill {} has no parameter '{}'", skill.description().name, name),
      nearest ? "did you mean '" + *nearest + "'?" : fmt::format("it has {}", fmt::join(names, ", ")));
}

runtime::CostPolicy parse_times(const std::string& text) {
  if (text == "worst") return runtime::CostPolicy::worst;
  return text == "best" ? runtime::CostPolicy::best : runtime::CostPolicy::random;
}

Session make_session(const RunCommand& command, const runtime::Skill& skill,
                     const std::vector<KnownSkill>& known) {
  Session session;
  if (!command.after.empty()) session.before = find_skill(command.after, known);
  session.scene =
      sim::find_scene(command.scene, {command.scene_folders.begin(), command.scene_folders.end()});
  for (const std::string& setting : command.settings) {
    const runtime::ParameterValue value = parse_setting(setting, skill);
    for (const runtime::ParameterValue& before : session.parameters)
      if (before.name == value.name)
        throw Failure(ExitStatus::usage, "--set " + setting,
                      before.text ? fmt::format("{} has been set before, to \"{}\"", value.name, *before.text)
                                  : fmt::format("{} has been set before, to {:g}", value.name, before.value),
                      "set it once");
    session.parameters.push_back(value);
  }
  session.times = parse_times(command.times);
  session.seed = command.seed;
  // A sweep is one machine at many phases.
  if (command.seed_given && command.sweep == 0) session.machine_seed = command.seed;
  if (command.phase >= 0) session.phase = runtime::Time(static_cast<std::int64_t>(command.phase * 1e6));
  session.picture = command.picture && !command.output.empty();
  session.limit = runtime::Time(static_cast<std::int64_t>(command.limit * 1e9));
  if (command.video) session.video = command.output + "/run.mp4";
  return session;
}

/// Before the run: a run of minutes whose files cannot be written is worth nothing.
void check_outputs(const RunCommand& command) {
  const auto check = [](const std::string& option, const std::string& file) {
    if (const auto problem = cannot_be_written(file))
      throw Failure(ExitStatus::usage, option, *problem, "choose another place");
  };
  if (!command.output.empty()) check("--output " + command.output, command.output + "/run.json");
  if (!command.measure.empty()) check("--measure=" + command.measure, command.measure);
}

void write(const std::vector<OutputFile>& files, std::ostream& out) {
  if (files.empty()) return;
  if (const auto problem = write_files(files))
    throw Failure(ExitStatus::usage, "--output", *problem, "choose another folder");
  for (const OutputFile& file : files) out << "  wrote " << file.path << '\n';
}

void write_measured(const std::string& file, const runtime::Measurement& measurement, std::ostream& out) {
  if (const auto problem = write_files({{file, measurement.environment()}}))
    throw Failure(ExitStatus::usage, "--measure", *problem, "name another file: --measure=FILE");
  out << "  wrote " << file << '\n';
}

/// Says what was proved and what the run did; false if the run took longer than that.
bool print(const std::vector<Promise>& promises, std::ostream& out) {
  bool kept = true;
  for (const Promise& promise : promises) {
    const auto words = [&promise](const std::optional<Duration>& value) {
      if (!value) return std::string("none");
      return promise.unit == runtime::BrokenPromise::Unit::time ? to_text(*value)
                                                                : runtime::in_words(*value, promise.unit);
    };
    const std::string proved = !promise.proved    ? "no bound was proved"
                               : promise.at_least ? "proved at least " + words(promise.proved)
                                                  : "proved at most " + words(promise.proved);
    out << fmt::format("  {}: measured {}, {}{}\n", promise.requirement, words(promise.measured), proved,
                       promise.kept()     ? ""
                       : promise.at_least ? " — THE RUN TOOK LESS TIME THAN WAS PROVED"
                       : promise.unit == runtime::BrokenPromise::Unit::messages
                           ? " — THE RUN LOST MORE THAN WAS PROVED"
                           : " — THE RUN TOOK LONGER THAN WAS PROVED");
    kept = kept && promise.kept();
  }
  return kept;
}

/// How far the run was one in real time, and what it measured.
void print(const runtime::RealTimeReport& report, const runtime::Wiring& wiring, std::ostream& out) {
  out << fmt::format("  in real time; the kernel was held for {} at most\n", to_text(report.longest_hold));
  for (const std::string& lacking : report.shortcomings) out << "  " << lacking << '\n';
  for (std::size_t i = 0; i < report.statements.size(); ++i) {
    const runtime::StatementTimes& times = report.statements[i];
    if (times.late == 0) continue;
    const runtime::StatementSpec& statement = wiring.statements[i];
    out << fmt::format("  {}:{} {}: {} of {} times beyond its worst time of {}, {} at most\n", statement.file,
                       statement.line, statement.text, times.late, times.count, to_text(statement.cost.worst),
                       to_text(times.greatest));
  }
}

std::unique_ptr<runtime::drivers::Carrier> make_carrier(const std::string& links) {
  try {
    if (links == "pty") return runtime::drivers::pseudo_terminal_carrier();
    if (links == "tcp") return runtime::drivers::tcp_carrier();
  } catch (const std::exception& problem) {
    throw Failure(ExitStatus::usage, "--links " + links, problem.what(), "use --links process");
  }
  return nullptr;
}

/// Of what is to go wrong, what is wrong with statements.
std::vector<runtime::SlowStatement> slow_statements(const RunCommand& command, const runtime::Wiring& wiring,
                                                    std::vector<sim::PlannedFault>& faults) {
  std::vector<runtime::SlowStatement> slow;
  for (const sim::PlannedFault& fault : faults) {
    if (fault.kind != sim::PlannedFault::Kind::takes) continue;
    const bool known =
        std::any_of(wiring.statements.begin(), wiring.statements.end(),
                    [&fault](const runtime::StatementSpec& statement) {
                      return statement.module == fault.device && statement.line == fault.statement;
                    });
    if (!known)
      throw Failure(ExitStatus::wrong_specification, fmt::format("{}:{}", command.faults, fault.line),
                    fmt::format("module {} has no statement in line {}", fault.device, fault.statement),
                    "name a line of the skill's PAL, or of a file that it uses, in which a statement stands");
    slow.push_back({fault.device, fault.statement, fault.by, fault.at});
  }
  std::erase_if(faults, [](const auto& fault) { return fault.kind == sim::PlannedFault::Kind::takes; });
  return slow;
}

/// What the run does with its events while it goes on.
std::unique_ptr<LiveTrace> live_trace(const RunCommand& command, const runtime::Wiring& wiring) {
  if (command.live_trace.empty()) return nullptr;
  try {
    return std::make_unique<LiveTrace>(command.live_trace, wiring);
  } catch (const std::runtime_error& problem) {
    throw Failure(ExitStatus::usage, "--live-trace " + command.live_trace, problem.what(),
                  "name a file in a folder that is there, or a named pipe");
  }
}

/// Runs the session in the time and over the links that the command asks for; Ctrl-C stops it.
SessionResult run_as_asked(const RunCommand& command, runtime::Skill& skill, Session session,
                           std::ostream& out) {
  std::optional<runtime::drivers::Outside> outside;
  if (command.paced > 0) session.pace = &outside.emplace(command.paced);
  session.carrier = [&command] { return make_carrier(command.links); };
  runtime::RunControl control;
  const Interrupt interrupt(control);
  session.control = &control;
  std::optional<ControlTerminal> terminal;
  if (command.control) terminal.emplace(control, skill.wiring(), STDIN_FILENO, out);
  session.faults = faults_in(command.faults);
  session.slow = slow_statements(command, skill.wiring(), session.faults);
  session.on_broken_promise = policy_named(command.on_broken_promise);
  const auto live = live_trace(command, skill.wiring());
  if (live) session.live = &live->ring();
  if (command.real_time) {
    runtime::RealTime& real_time = session.real_time.emplace();
    real_time.hang_status = static_cast<int>(ExitStatus::hung);
    real_time.tolerance = in_real_time.device;
    real_time.cost_tolerance = in_real_time.cost;
  }
  try {
    SessionResult result = run_session(skill, session);
    if (live && !live->end(result.outcome))
      out << "  the live trace is incomplete: its reader has gone, or the disk is full\n";
    if (live && live->dropped() > 0)
      out << fmt::format("  the live trace lacks {} events: its reader was too slow\n", live->dropped());
    return result;
  } catch (const sim::NoSuchDevice& problem) {
    throw no_such_device(command.faults, problem);
  }
}

void write_run(const RunCommand& command, const runtime::Skill& skill, const Session& session,
               const SessionResult& result, const std::vector<Promise>& proved, std::ostream& out) {
  std::vector<OutputFile> files = run_files(command.output, skill, session, result, proved);
  if (command.plots) {
    const sim::DrawnPlots plots = run_plots(skill, session, result);
    for (const auto& [name, content] : plots.files)
      files.push_back({command.output + "/plots/" + name, content});
    if (!plots.problem.empty()) out << "  no plots, only their data: " << plots.problem << '\n';
  }
  write(files, out);
  if (result.events)
    out << fmt::format("  trace.chrome.json has the last {} of {} events; trace.json has all\n",
                       result.outcome.trace.events.size(), result.events->size());
  if (session.video.empty()) return;
  if (!result.video_problem.empty())
    throw Failure(ExitStatus::usage, "--video", result.video_problem, "the run's other files are there");
  out << "  wrote " << session.video << '\n';
}

ExitStatus run_once(const RunCommand& command, const KnownSkill& known, runtime::Skill& skill,
                    Session session, std::ostream& out) {
  if (command.live) session.progress = &out;
  session.terminal = command.terminal;
  const SessionResult result = run_as_asked(command, skill, session, out);
  const runtime::Outcome& outcome = result.outcome;
  out << fmt::format("{} in scene {}: {} {}\n", skill.description().name, session.scene.name,
                     outcome.fault ? "fault, completion" : "completion", outcome.code);
  out << "  " << outcome.reason << '\n';
  if (!result.controller.empty()) out << "  val: " << result.controller << '\n';
  out << fmt::format("  ended after {:.3f} ms; alter's first request after {:.3f} ms; seed {}\n",
                     static_cast<double>(outcome.duration.count()) / 1e6,
                     static_cast<double>(result.phase.count()) / 1e6, session.seed);
  if (outcome.real_time) print(*outcome.real_time, skill.wiring(), out);
  if (result.log.empty()) return ExitStatus::error_completion;
  for (const runtime::BrokenPromise& broken : outcome.broken_promises)
    out << fmt::format("  broken promise: {}; first at {}\n", runtime::in_words(broken),
                       runtime::in_words(broken.first));
  const Eigen::Vector3d way = (result.log.back().tool - result.log.front().tool) * 1e3;
  out << fmt::format("  the tool moved by ({:.2f}, {:.2f}, {:.2f}) mm\n", way.x(), way.y(), way.z());
  out << fmt::format("  contact force: {:.2f} N at its peak, {:.2f} N at rest\n", result.peak_force,
                     result.resting_force);
  if (const auto threshold = parameter_value(skill, session, "threshold"); threshold && result.peak_force > 0)
    out << fmt::format("  overshoot: {:.2f} N past the threshold of {:g} N\n", result.peak_force - *threshold,
                       *threshold);
  if (session.picture && !result.picture.image)
    out << "  no picture: " << result.picture.problem
        << (result.picture.packages.empty() ? "" : " (apt-get install " + result.picture.packages + ")")
        << '\n';
  std::vector<Promise> proved;
  if (command.proof)
    proved = promises(known, outcome, result.events.get(), command.real_time ? in_real_time : Tolerances());
  const bool kept = print(proved, out);
  if (!command.output.empty()) write_run(command, skill, session, result, proved, out);

  std::vector<sim::PlannedFault> to_come = result.faults_to_come;
  const auto slow =
      slow_to_come(result.slow, outcome.trace,
                   result.events ? trace::events_of(*result.events) : trace::events_of(outcome.trace));
  to_come.insert(to_come.end(), slow.begin(), slow.end());
  const bool untried = tell_faults_to_come(
      command.faults, to_come,
      fmt::format("the skill ended after {:.3f} ms", static_cast<double>(outcome.duration.count()) / 1e6),
      out);

  const auto is_error = [&](const runtime::CompletionSpec& completion) {
    return completion.code == outcome.code && completion.kind == runtime::CompletionSpec::Kind::error;
  };
  const auto completions = skill.description().completions;
  return outcome.fault || !kept || !outcome.broken_promises.empty() ||
                 std::any_of(completions.begin(), completions.end(), is_error)
             ? ExitStatus::error_completion
         : untried ? ExitStatus::wrong_specification
                   : ExitStatus::done;
}

// The same bins for all, so that the histograms can be compared by eye.
std::pair<double, double> bounds(const std::vector<std::vector<SweepRun>>& sweeps) {
  double low = 1e300, high = -1e300;
  for (const auto& runs : sweeps)
    for (const SweepRun& run : runs) {
      low = std::min(low, run.overshoot);
      high = std::max(high, run.overshoot);
    }
  low = std::floor(low);
  return {low, std::max(std::ceil(high), low + 1)};
}

ExitStatus run_sweep(const RunCommand& command, const KnownSkill& first, runtime::Skill& skill,
                     const Session& session, const std::vector<KnownSkill>& known, std::ostream& out) {
  std::vector<std::string> names{command.skill};
  const SweepSubject subject = sweep_subject(first);
  std::vector<std::vector<SweepRun>> sweeps;
  if (!command.against.empty()) {
    const KnownSkill& other = find_skill(command.against, known);
    const SweepSubject others = sweep_subject(other);  // refused before anything runs
    sweeps.push_back(sweep(skill, subject, session, command.sweep));
    const auto second = other.make();
    make_session(command, *second, known);  // its parameters must take the same settings
    names.push_back(command.against);
    sweeps.push_back(sweep(*second, others, session, command.sweep));
  } else {
    sweeps.push_back(sweep(skill, subject, session, command.sweep));
  }
  const auto [low, high] = bounds(sweeps);
  for (std::size_t i = 0; i < sweeps.size(); ++i) out << describe(names[i], sweeps[i], low, high);

  std::optional<Comparison> comparison;
  const auto speed = parameter_value(skill, session, subject.speed);
  if (sweeps.size() == 2 && speed) {
    comparison = compare(sweeps[0], sweeps[1], session.scene, *speed);
    if (comparison) out << describe(*comparison, names[0], names[1]);
  }
  if (!command.output.empty()) write(sweep_files(command.output, names, sweeps, comparison), out);
  const auto failed = [](const SweepRun& run) { return run.fault; };
  for (const auto& runs : sweeps)
    if (std::any_of(runs.begin(), runs.end(), failed)) return ExitStatus::error_completion;
  return ExitStatus::done;
}

}  // namespace

ExitStatus run(const RunCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out) {
  const KnownSkill& known = find_skill(command.skill, skills);
  const auto skill = known.make();
  Session session = make_session(command, *skill, skills);
  check_tool(*skill, session.scene, command.scene_folders);
  check_outputs(command);
  std::optional<runtime::Measurement> measurement;
  if (!command.measure.empty()) session.measurement = &measurement.emplace(skill->wiring());
  const ExitStatus status = command.sweep > 0 ? run_sweep(command, known, *skill, session, skills, out)
                                              : run_once(command, known, *skill, session, out);
  if (measurement) write_measured(command.measure, *measurement, out);
  return status;
}

}  // namespace pal::workcell
