#include "programs/workcell/options/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <ostream>
#include <system_error>

#include "programs/pal/options/steady_help.hpp"
#include "programs/workcell/session/interrupt.hpp"
#include "sim/cell/served_port.hpp"
#include "sim/report/video.hpp"
#include "sim/scene.hpp"
#include "sim/workcell.hpp"

namespace pal::workcell {
namespace {

/// `given`, then what is installed beside this program (../share/pal/NAME), then `in_source`: where an
/// installed program has been moved, or unpacked, does not matter.
std::vector<std::string> folders_of(std::vector<std::string> given, const char* name, const char* in_source) {
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::filesystem::path installed = program.parent_path().parent_path() / "share" / "pal" / name;
  if (!none && std::filesystem::is_directory(installed, none)) given.push_back(installed);
  given.push_back(in_source);
  return given;
}

/// CLI11 takes -1 for the greatest number that there is.
CLI::Validator whole_number() {
  return CLI::Validator(
      [](const std::string& text) {
        std::uint64_t value = 0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = problem == std::errc() && end == text.data() + text.size();
        return whole ? std::string() : "'" + text + "' is not a whole number from 0 to 18446744073709551615";
      },
      "");
}

/// CLI11's own range lets "nan" pass.
CLI::Validator number_within(double low, double high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        double value = 0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool inside =
            problem == std::errc() && end == text.data() + text.size() && value >= low && value <= high;
        return inside ? std::string()
                      : fmt::format("'{}' is not a number from {:g} to {:g}", text, low, high);
      },
      fmt::format("FLOAT in [{:g} - {:g}]", low, high));
}

/// Refuses options with an empty value, of all commands: a file without a name, a folder without a name.
void refuse_empty_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_positional() || option->get_items_expected_max() == 0) continue;
    option->check(CLI::Validator(
        [](const std::string& text) {
          return text.empty() ? std::string("its value is empty") : std::string();
        },
        ""));
  }
  for (CLI::App* command : app.get_subcommands({})) refuse_empty_values(*command);
}

/// Folders of scenes that a user names are there, and have scenes.
void check_scene_folders(const std::vector<std::string>& folders) {
  for (const std::string& folder : folders) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
      throw Failure(ExitStatus::usage, "--scenes " + folder, "there is no such folder", "check the path");
    if (sim::list_scenes({folder}).empty())
      throw Failure(ExitStatus::usage, "--scenes " + folder, "the folder has no scenes",
                    "a scene is a file that ends in .scene, or in .xml; folders within are not searched");
  }
}

/// --skills, alike wherever skills run.
void add_skills_option(CLI::App& app, std::vector<std::string>& skills) {
  app.add_option(
         "--skills", skills,
         "further skills: a file of pal_add_skill(… WORKCELL), or a folder of them; one of a known name "
         "takes its place")
      ->type_name("FILE|FOLDER")
      ->allow_extra_args(false);
}

/// The skills of this command, of which `wanted` may be a file. What has changed since it was built is told.
std::vector<KnownSkill> skills_of_command(std::vector<KnownSkill> skills, std::vector<std::string> given,
                                          std::string& wanted, std::ostream& error) {
  if (wanted.ends_with(".so")) {
    given.push_back(wanted);
    wanted = skill_of_file(wanted).name;
  }
  add_skills(skills, given);
  for (const std::string& path : given) {
    if (std::filesystem::is_directory(path)) continue;
    for (const std::string& text : changed_texts(path))
      error << "workcell: warning: " << path << ": " << text
            << " has changed since it was built; what runs, and what is proved of it, is the older one\n";
  }
  return skills;
}

/// --on-broken-promise, alike wherever skills run.
CLI::Option* add_policy(CLI::App& app, std::string& policy) {
  return app
      .add_option(
          "--on-broken-promise", policy,
          "what to do when a device or a statement breaks a promise of the environment, or a requirement "
          "fails: note it and go on, tell the skill, or stop it")
      ->check(CLI::IsMember({"report", "contingency", "stop"}))
      ->capture_default_str();
}

constexpr const char* first_faults = "a file that says what goes wrong with devices in the first skill";

void describe_run(CLI::App& app, RunCommand& command, std::vector<std::string>& folders) {
  app.add_option("skill", command.skill,
                 "the skill to run, by its name or its file; 'workcell list' shows them")
      ->required();
  app.add_option("--scene", command.scene, "a scene's name, or the path of a scene file")
      ->capture_default_str();
  app.add_option("--scenes", folders, "a further folder of scenes, searched first");
  app.add_option("--set", command.settings,
                 "a parameter of the skill, as name=value in the parameter's unit");
  app.add_option("--seed", command.seed,
                 "seed of everything random: times, phases, noise, the machine's play and counts")
      ->each([&command](const std::string&) { command.seed_given = true; })
      ->check(whole_number())
      ->capture_default_str();
  auto* phase =
      app.add_option("--phase", command.phase,
                     "time from ALTER's opening to its first request, ms; random if not given")
          ->check(number_within(0, std::chrono::duration<double, std::milli>(sim::alter_period).count()));
  app.add_option("--time", command.times, "times within their intervals")
      ->check(CLI::IsMember({"worst", "best", "random"}))
      ->capture_default_str();
  auto* output =
      app.add_option("--output", command.output,
                     "a folder for the trace, the log, the figures, the charts, the plots and the picture");
  app.add_flag("!--no-picture", command.picture, "draw no picture of the arm");
  app.add_flag("!--no-plots", command.plots, "draw no plots of force, position and range profiles");
  auto* video =
      app.add_flag("--video", command.video, "with --output: films the run, as run.mp4 (needs ffmpeg)")
          ->needs(output);
  auto* live = app.add_flag("--live", command.live, "shows the progress of the run");
  app.add_flag("!--no-proof", command.proof, "do not compare the run with what was proved of the skill");
  auto* sweep = app.add_option("--sweep", command.sweep,
                               "runs this often, over the phases of the two clocks, and prints how "
                               "far the tool pressed past the threshold")
                    ->check(CLI::Range(1, 100000));
  // A sweep goes over the phases itself, and its runs are too many to look at.
  for (CLI::Option* single : {phase, video, live}) sweep->excludes(single);
  app.add_option("--after", command.after,
                 "run this skill before, with its defaults; for example, pick a part before placing it")
      ->type_name("SKILL");
  auto* against = app.add_option("--against", command.against,
                                 "with --sweep: a second skill, over the same phases, for comparison")
                      ->needs(sweep);
  app.add_flag("--measure{measured.pal}", command.measure,
               "writes how long activities and devices took, for pal check --measured; --measure=FILE: there")
      ->excludes(against);
  app.add_option("--paced", command.paced,
                 "in step with the wall clock, or this many times as fast; Ctrl-C stops the skill")
      ->expected(0, 1)
      ->default_str("1")
      ->check(CLI::Range(0.001, 1000.0))
      ->excludes(sweep);
  auto* real_time =
      app.add_flag("--real-time", command.real_time, "by the wall clock, in threads of the operating system")
          ->excludes(sweep)
          ->excludes(app.get_option("--paced"))
          ->excludes(app.get_option("--time"));
  // A video or a display would hold up the arm, which does not wait.
  for (CLI::Option* looks : {video, live}) real_time->excludes(looks);
  app.add_option("--limit", command.limit, "seconds of the skill's time after which it is ended")
      ->type_name("SECONDS")
      ->check(number_within(0.001, 3600))
      ->capture_default_str();
  app.add_flag("--control", command.control,
               "reads commands from the standard input: step, go, pause, break MODULE:LINE, where, stop")
      ->excludes(sweep)
      ->excludes(real_time);
  app.add_option("--fault", command.faults, "a file that says what goes wrong with devices, and when")
      ->excludes(sweep);
  add_policy(app, command.on_broken_promise)->excludes(sweep);
  app.add_option("--live-trace", command.live_trace,
                 "a file, or a named pipe, that gets the events of the run while it goes on, a line each")
      ->excludes(sweep);
  app.add_option("--links", command.links,
                 "what carries the bytes of devices' lines; the run is the same with each")
      ->check(CLI::IsMember({"process", "pty", "tcp"}))
      ->capture_default_str()
      ->excludes(sweep);
}

void describe_serve_port(CLI::App& app, ServePortCommand& command, std::vector<std::string>& folders) {
  std::string names;
  for (const sim::ServedPort& port : sim::served_ports()) names += "\n" + port.name + ": " + port.description;
  app.add_option("device", command.devices, "the devices of one cell to serve:" + names)->required();
  app.add_option("--scene", command.scene, "a scene's name, or the path of a scene file")
      ->capture_default_str();
  app.add_option("--scenes", folders, "a further folder of scenes, searched first");
  app.add_option("--seed", command.seed, "seed of everything random in the device")
      ->check(whole_number())
      ->capture_default_str();
  auto* where = app.add_option_group("where");
  where->require_option(0, 1);
  where->add_flag("--pty", command.pty,
                  "at a pseudo-terminal of its own, whose path is printed (the default)");
  where
      ->add_option("--tcp", command.tcp,
                   "at this TCP port of this machine only, further lines at those after it; 0: any free ones")
      ->check(CLI::Range(0, 65535));
  where->add_option("--serial", command.serial, "at a serial port, /dev/ttyUSB0 for example");
  app.add_option("--link", command.link,
                 "makes this a symbolic link to the pseudo-terminal while it is there");
}

void describe_new_skill(CLI::App& app, NewSkillCommand& command) {
  app.add_option("name", command.name, "what the skill is called in PAL: tap")->required();
  auto* like = app.add_option("--like", command.like, "begin as a copy of this skill")->type_name("SKILL");
  app.add_option("--from", command.from, "begin with this PAL file, and activities that do nothing")
      ->type_name("FILE")
      ->excludes(like);
  app.add_option("--output", command.output, "the folder; without it, one named like the skill");
}

void describe_serve(CLI::App& app, ServeCommand& command, std::vector<std::string>& folders) {
  app.add_option("--scene", command.scene, "a scene's name, or the path of a scene file")
      ->capture_default_str();
  app.add_option("--scenes", folders, "a further folder of scenes, searched first");
  app.add_option("--seed", command.seed, "seed of everything random: times, phases, noise")
      ->check(whole_number())
      ->capture_default_str();
  app.add_option("--time", command.times, "times within their intervals")
      ->check(CLI::IsMember({"worst", "best", "random"}))
      ->capture_default_str();
  app.add_option(
         "--listen", command.address,
         "the address for clients; an address other than this machine's is open to all who can reach it")
      ->capture_default_str();
  app.add_option("--port", command.port, "port of JSON-RPC over WebSocket; 0: any free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  app.add_option("--line-port", command.line_port, "lines over TCP at this port; 0: any free one")
      ->check(CLI::Range(0, 65535));
  app.add_flag("--line-pty", command.line_terminal, "lines over a pseudo-terminal, whose path is printed");
  app.add_option("--line-serial", command.line_serial, "lines over a serial port, /dev/ttyUSB0 for example");
  app.add_option("--baud", command.baud, "speed of the serial port")->capture_default_str();
  app.add_option("--allow-host", command.hosts, "a further name by which clients may call this machine")
      ->take_all();
  app.add_option("--allow-origin", command.origins,
                 "a site whose pages may connect, such as http://localhost:8000")
      ->take_all();
  app.add_option("--announce", command.announcement,
                 "the file for address and token, readable by this user only");
  app.add_flag("--go-on", command.goes_on,
               "if the client with the controls goes, its operation goes on; without this it pauses");
  app.add_option("--fault", command.faults, first_faults);
  add_policy(app, command.on_broken_promise);
  auto* paced = app.add_option("--paced", command.paced, "this many times as fast as the wall clock")
                    ->check(CLI::Range(0.001, 1000.0))
                    ->capture_default_str();
  app.add_flag("--fast", command.fast,
               "in virtual time, as fast as possible; the cell's clock stands between skills")
      ->excludes(paced);
  app.add_option("--log", command.log, "a file that gets a line of JSON for each step");
  app.add_option("--page", command.page, "the folder of the page for browsers; without it the installed one");
  app.add_option("--store", command.store, "a folder that keeps operations, with all their versions");
  app.add_flag("--open", command.open, "prints the address at which a browser shows the cell");
}

struct Verb {
  const char* name;
  const char* description;
  std::size_t words = 0;  // that it must be given
  const char* usage = "";
};
constexpr Verb remote_verbs[] = {
    {"load", "at a server: loads FILE in place of the present operation"},
    {"step", "at a server: one skill, delay, wait or test; with FILE it is loaded first"},
    {"from", "at a server: puts the token before an icon", 1, "ICON"},
    {"set", "at a server: a parameter of a skill icon, from its next run on", 3, "ICON PARAMETER VALUE"},
    {"break", "at a server: pauses before an icon; with a code, only if that came last", 1, "ICON[=CODE]"},
    {"clear", "at a server: forgets all breakpoints"},
    {"resume", "at a server: goes on with what is paused or stopped"},
    {"pause", "at a server: after the current skill; also while another client has the controls"},
    {"stop", "at a server: at once; also while another client has the controls"},
    {"state", "at a server: what runs, where the token is, which client has the controls"},
    {"watch", "at a server: tells what happens, until Ctrl-C"}};

void describe_remote(CLI::App& operation, RemoteCommand& command) {
  for (const Verb& verb : remote_verbs) {
    CLI::App* app = operation.add_subcommand(verb.name, verb.description);
    app->parse_complete_callback([&command, &verb] { command.verb = verb.name; });
    const std::string name = verb.name;
    if (name == "step" || name == "load")
      app->add_option("file", command.file, "the operation, .op.json")->required(name == "load");
    if (verb.words > 0)
      app->add_option("what", command.arguments, verb.usage)
          ->required()
          ->expected(static_cast<int>(verb.words))
          ->type_name(verb.usage);
    app->add_option("--at", command.announcement, "the file that the server has written");
  }
}

CLI::App* describe_operation(CLI::App& app, OperationCommand& command, std::vector<std::string>& folders) {
  CLI::App* operation = app.add_subcommand("operation", "runs operations: connected skills");
  operation->require_subcommand(1);
  CLI::App* run = operation->add_subcommand("run", "runs an operation; Ctrl-C stops the skill");
  run->add_option("file", command.file, "the operation, .op.json; with --server, without it the loaded one");
  run->add_option("--scene", command.scene, "a scene's name, or the path of a scene file")
      ->capture_default_str();
  run->add_option("--scenes", folders, "a further folder of scenes, searched first");
  run->add_option("--seed", command.seed, "seed of everything random: times, phases, noise")
      ->check(whole_number())
      ->capture_default_str();
  run->add_option("--time", command.times, "times within their intervals")
      ->check(CLI::IsMember({"worst", "best", "random"}))
      ->capture_default_str();
  run->add_option("--steps", command.steps, "pause after this many skills, delays, waits and tests")
      ->check(CLI::Range(1, 1'000'000'000));
  run->add_option("--log", command.log, "a file that gets a line of JSON for each step");
  run->add_option("--from", command.from, "start before this icon instead of START");
  run->add_option("--break", command.breakpoints, "pause before ICON, or ICON=CODE: if that code came last")
      ->take_all();
  auto* answers = run->add_option("--answer", command.answers,
                                  "the answer to a question, ICON=ANSWER; one for each time that it is asked")
                      ->take_all();
  auto* faults = run->add_option("--fault", command.faults, first_faults);
  auto* policy = add_policy(*run, command.on_broken_promise);
  auto* server = run->add_flag("--server", command.at_server, "at the server that 'workcell serve' started");
  run->add_option("--at", command.announcement, "with --server: the file that the server has written")
      ->needs(server);
  server->excludes(run->get_option("--scene"))
      ->excludes(run->get_option("--seed"))
      ->excludes(run->get_option("--time"))
      ->excludes(run->get_option("--steps"))
      ->excludes(answers)
      ->excludes(faults)
      ->excludes(policy);
  run->add_flag("--detach", command.detach, "with --server: does not wait, and gives the controls back")
      ->needs(server);
  run->add_flag("--step", command.interactive, "obey commands on standard input: step, run, set, break, …")
      ->excludes(server);
  return run;
}

ExitStatus run_program(const std::vector<std::string>& arguments, const SkillSource& source,
                       std::ostream& out, std::ostream& error, bool terminal, std::istream* in) {
  CLI::App app("Runs skills on a PUMA 560 in physics, in virtual time.", "workcell");
  app.formatter(std::make_shared<program::SteadyHelp>());
  app.set_version_flag("--version", "workcell " PAL_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 done, 1 a wrong scene, skill or parameter, 2 wrong usage or a file problem,\n"
      "3 the skill ended with its error completion, or took longer than was proved,\n"
      "4 with --real-time: code of the skill or of a device did not return;\n"
      "an operation that an EXIT ended with a code other than 0: 100 and the code, if it is 1 to 99, else "
      "100.");
  std::vector<std::string> folders, skill_files;
  ListCommand list_command;
  CLI::App* list_app =
      app.add_subcommand("list", "shows the skills, their parameters and completions, and the scenes");
  list_app->add_option("--scenes", folders, "a further folder of scenes");
  list_app->add_option("--cell", list_command.cell,
                       "as JSON: what operations in this scene can use, for 'pal operation check --scene'");
  RunCommand run_command;
  CLI::App* run_app = app.add_subcommand("run", "runs a skill in a scene");
  describe_run(*run_app, run_command, folders);
  ServePortCommand serve_command;
  CLI::App* serve_app = app.add_subcommand(
      "serve-port", "offers emulated devices of one cell to any program, in real time, until Ctrl-C");
  describe_serve_port(*serve_app, serve_command, folders);

  NewSkillCommand new_command;
  CLI::App* new_app = app.add_subcommand(
      "new-skill", "writes a folder with a skill of your own, which builds, is proved and runs");
  describe_new_skill(*new_app, new_command);

  OperationCommand operation_command;
  CLI::App* operation_app = describe_operation(app, operation_command, folders);
  RemoteCommand remote;
  describe_remote(*operation_app->get_parent(), remote);
  ServeCommand cell_command;
  CLI::App* cell_app = app.add_subcommand(
      "serve", "opens a workcell for clients, who run skills and operations, until Ctrl-C");
  describe_serve(*cell_app, cell_command, folders);

  for (CLI::App* command : {list_app, run_app, new_app, operation_app, cell_app})
    add_skills_option(*command, skill_files);
  refuse_empty_values(app);

  std::vector<std::string> words = arguments;
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  // CLI11 takes the arguments from the back.
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  try {
    app.parse(reversed);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem, out, error) == 0 ? ExitStatus::done : ExitStatus::usage;
  }
  try {
    check_scene_folders(folders);
    if (!remote.verb.empty()) return command_server(remote, out, error);
    const std::vector<KnownSkill> skills = skills_of_command(source ? source() : std::vector<KnownSkill>{},
                                                             skill_files, run_command.skill, error);
    list_command.scene_folders = run_command.scene_folders = serve_command.scene_folders =
        operation_command.scene_folders = cell_command.scene_folders =
            folders_of(folders, "scenes", PAL_SCENE_FOLDER);
    run_command.terminal = terminal;
    list_command.skill_folders = folders_of({}, "skills", PAL_SKILL_FOLDER);
    if (new_app->parsed()) {
      for (const std::string& each : list_command.skill_folders)
        if (new_command.skill_folder.empty() && std::filesystem::is_directory(each))
          new_command.skill_folder = each;
      return new_skill(new_command, skills, out);
    }
    if (cell_app->parsed()) {
      if (cell_command.fast) cell_command.paced = 0;
      if (cell_command.page.empty())
        for (const std::string& folder : folders_of({}, "workstation", PAL_PAGE_FOLDER))
          if (cell_command.page.empty() && std::filesystem::is_directory(folder)) cell_command.page = folder;
      return serve(cell_command, skills, out);
    }
    if (operation_app->parsed() && operation_command.at_server) {
      const OperationCommand& asked = operation_command;
      return command_server(
          {"run", asked.file, asked.announcement, asked.log, asked.from, asked.breakpoints, asked.detach},
          out, error);
    }
    if (operation_app->parsed() && operation_command.file.empty())
      throw Failure(ExitStatus::usage, "operation run", "no operation is given", "name a file, .op.json");
    if (operation_app->parsed()) return run_operation(operation_command, skills, in, out, error);
    if (serve_app->parsed()) {
      runtime::RunControl control;
      const Interrupt interrupt(control);
      return serve_port(serve_command, control, out);
    }
    return list_app->parsed() ? list(list_command, skills, out) : run(run_command, skills, out);
  } catch (const Failure& failure) {
    failure.print(error);
    return failure.status();
  } catch (const sim::SceneError& problem) {
    const Failure failure(ExitStatus::wrong_specification, problem.place(), problem.cause(), problem.hint());
    failure.print(error);
    return failure.status();
  } catch (const sim::VideoError& problem) {
    const Failure failure(ExitStatus::usage, "--video", problem.what(), problem.hint());
    failure.print(error);
    return failure.status();
  } catch (const std::exception& problem) {
    error << "workcell: error: " << problem.what() << '\n';
    return ExitStatus::error_completion;
  }
}

}  // namespace

ExitStatus main_program(const std::vector<std::string>& arguments, const SkillSource& skills,
                        std::ostream& out, std::ostream& error, bool terminal, std::istream* in) {
  // A report that cannot be written is no success. That is said before a run of minutes, where it is known.
  const ExitStatus status =
      out ? run_program(arguments, skills, out, error, terminal, in) : ExitStatus::usage;
  if (out.flush()) return status;
  error << "workcell: error: the standard output cannot be written: is it open, and is there space?\n";
  return status == ExitStatus::done ? ExitStatus::usage : status;
}

}  // namespace pal::workcell
