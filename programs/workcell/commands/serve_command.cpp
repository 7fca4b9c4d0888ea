// workcell serve: a workcell for clients.
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <ostream>

#include "operations/step_log.hpp"
#include "programs/pal/session/memory.hpp"
#include "programs/workcell/options/command_line.hpp"
#include "programs/workcell/session/cell_runner.hpp"
#include "programs/workcell/session/fault_file.hpp"
#include "programs/workcell/session/instruments.hpp"
#include "programs/workcell/session/live_channels.hpp"
#include "programs/workcell/session/live_scene.hpp"
#include "programs/workcell/session/margin_meter.hpp"
#include "programs/workcell/session/skill_facts.hpp"
#include "programs/workcell/session/taught_robot.hpp"
#include "programs/workcell/session/trials.hpp"
#include "runtime/drivers/streams/outside.hpp"
#include "server/announcement.hpp"
#include "server/disk_file.hpp"
#include "server/server.hpp"
#include "sim/cell/cell.hpp"

namespace pal::workcell {
namespace {

using namespace std::chrono_literals;

// Clients that read slowly need some MiB for a while, and the allocator would keep them. When a run has ended
// it may keep this, with the pages of the program itself.
constexpr std::size_t most_kept = std::size_t{60} << 20;

server::ServerOptions server_options(const ServeCommand& command) {
  server::ServerOptions options;
  options.address = command.address;
  options.port = static_cast<std::uint16_t>(command.port);
  if (command.line_port >= 0) options.line_port = static_cast<std::uint16_t>(command.line_port);
  options.line_terminal = command.line_terminal;
  options.line_serial = command.line_serial;
  options.baud = command.baud;
  options.access.hosts.insert(options.access.hosts.end(), command.hosts.begin(), command.hosts.end());
  options.access.origins = command.origins;
  options.tokens = {server::make_token(), server::make_token(), server::make_token()};
  if (!command.page.empty()) options.pages.push_back({"/", command.page});
  options.version = PAL_VERSION;
  return options;
}

std::unique_ptr<server::Server> open_server(const server::ServerOptions& options) {
  try {
    return std::make_unique<server::Server>(options);
  } catch (const std::exception& problem) {
    throw Failure(ExitStatus::usage, "serve", problem.what(),
                  "choose another --port, or --port 0 for any that is free");
  }
}

/// The server serves the desk while this lives: whatever ends the command, no client is served when the desk
/// goes.
class Serving {
 public:
  Serving(server::Server& server, server::Desk& desk) : server_(server) { server_.start(desk, true); }
  ~Serving() { server_.stop(); }
  Serving(const Serving&) = delete;
  Serving& operator=(const Serving&) = delete;

 private:
  server::Server& server_;
};

/// Orders of clients go to the cell's pendant.
class CellPendant final : public server::Pendant {
 public:
  explicit CellPendant(sim::Cell& cell) : pendant_(cell.pendant()) {}
  void order(const server::JogAxes& axes, bool held) override { pendant_.order({axes, held}); }

 private:
  runtime::drivers::PendantDriver& pendant_;
};

/// The file by which programs find the server, for as long as it serves.
class Announced {
 public:
  Announced(std::string path, server::Announcement announcement)
      : path_(std::move(path)), announcement_(std::move(announcement)) {
    try {
      server::announce(path_, announcement_);
    } catch (const std::exception& problem) {
      throw Failure(ExitStatus::usage, "serve", problem.what(), "name another file: --announce FILE");
    }
  }
  ~Announced() { server::withdraw(path_, announcement_); }
  Announced(const Announced&) = delete;
  Announced& operator=(const Announced&) = delete;

 private:
  std::string path_;
  server::Announcement announcement_;
};

std::optional<server::Store> open_store(const std::string& folder) {
  if (folder.empty()) return std::nullopt;
  try {
    return server::Store(folder);
  } catch (const std::exception& problem) {
    throw Failure(ExitStatus::usage, "--store " + folder, problem.what(),
                  "name a folder that can be written");
  }
}

/// What is kept of this cell beside the operations: FOLDER/.cells/SCENE; empty: nothing is.
std::string folder_of_cell(const ServeCommand& command, const sim::Scene& scene) {
  if (command.store.empty()) return {};
  return (std::filesystem::path(command.store) / ".cells" / scene.name).string();
}

[[noreturn]] void fail_to_open(const ServeCommand& command, const server::StoreProblem& problem) {
  throw Failure(ExitStatus::usage, "--store " + command.store, problem.refusal.message, problem.refusal.hint);
}

server::RunHistory open_history(const ServeCommand& command, const std::string& folder) {
  std::error_code ignored;  // the database tells it
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  try {
    return server::RunHistory(folder.empty() ? "" : folder + "/history.sqlite");
  } catch (const server::StoreProblem& problem) {
    fail_to_open(command, problem);
  }
}

/// Of runs that can be looked at again.
server::RunRecording open_recording(const ServeCommand& command, const std::string& folder,
                                    const server::Channels& channels) {
  try {
    return server::RunRecording(folder.empty() ? "" : folder + "/recording.sqlite", channels);
  } catch (const server::StoreProblem& problem) {
    fail_to_open(command, problem);
  }
}

server::Locations open_locations(const ServeCommand& command, CellRobot& robot, const std::string& folder) {
  try {
    return server::Locations(robot.taught(), folder);
  } catch (const server::StoreProblem& problem) {
    fail_to_open(command, problem);
  }
}

void tell_addresses(const ServeCommand& command, const sim::Scene& scene, const server::Server& server,
                    const std::string& announcement, const server::Tokens& tokens, std::ostream& out) {
  out << fmt::format("serving scene {}; Ctrl-C ends it\n", scene.name)
      << fmt::format("  JSON-RPC at ws://{}:{}\n", command.address, server.port());
  if (const auto port = server.line_port()) out << fmt::format("  lines at {}:{}\n", command.address, *port);
  if (!server.terminal().empty()) out << fmt::format("  lines at {}\n", server.terminal());
  if (!command.line_serial.empty()) out << fmt::format("  lines at {}\n", command.line_serial);
  out << fmt::format("  the token is in {}\n", announcement);
  if (command.open) {
    const std::string page =
        fmt::format("http://{}:{}/#token=", command.address == "localhost" ? "127.0.0.1" : command.address,
                    server.port());
    out << fmt::format("  a browser shows the cell at {}{}\n", page, tokens.programmer)
        << fmt::format("  an operator's page is at {}{}\n", page, tokens.operating);
  }
  if (!server::is_loopback(command.address))
    out << "  warning: others can reach this address, and nothing is encrypted, not even the token\n";
  check_told(out);
}

}  // namespace

ExitStatus serve(const ServeCommand& command, const std::vector<KnownSkill>& known, std::ostream& out) {
  const sim::Scene scene =
      sim::find_scene(command.scene, {command.scene_folders.begin(), command.scene_folders.end()});
  std::ofstream log_file;
  if (!command.log.empty()) {
    log_file.open(command.log, std::ios::binary);
    if (!log_file) throw Failure(ExitStatus::usage, "--log " + command.log, "it cannot be written");
  }
  operations::StepLog log(log_file);
  if (command.open && command.page.empty())
    throw Failure(ExitStatus::usage, "--open", "there is no page for browsers here",
                  "name its folder: --page FOLDER");
  std::optional<server::Store> store = open_store(command.store);
  const std::string folder = folder_of_cell(command, scene);
  server::RunHistory runs = open_history(command, folder);
  server::Knowledge knowledge;
  server::ServerOptions offered = server_options(command);
  offered.store = store ? &*store : nullptr;
  offered.knowledge = &knowledge;
  const SkillPictures pictures;
  offered.pages.push_back({"/files/", pictures.folder()});
  offered.runs = &runs;
  SimulatedTrials trials(scene, known, times_named(command.times));
  offered.trials = &trials;
  offered.channels = live_channels(sim::tool_of(scene), known);
  for (const server::Channel& each : scene_channels()) offered.channels.push_back(each);
  server::RunRecording recording = open_recording(command, folder, offered.channels);
  offered.recording = &recording;
  server::Scene looks;
  offered.scene = &looks;
  const auto server = open_server(offered);

  std::optional<runtime::drivers::Outside> wall;
  sim::CellOptions options;
  options.seed = command.seed;
  options.times = times_named(command.times);
  options.keep_log = false;
  options.faults = faults_of_lines(command.faults);
  if (command.paced > 0) options.pace = &wall.emplace(command.paced);
  std::atomic<server::Desk*> clock_reader = nullptr;
  options.watch = [&](sim::Workcell& workcell) {
    const Watcher clock{20ms, [&workcell, &clock_reader] {
                          if (auto* reader = clock_reader.load()) reader->tell_time(workcell.now());
                        }};
    auto watched =
        std::make_unique<WatchedWorld>(workcell, std::vector{instrument_watcher(workcell, *server), clock});
    // Without this nobody would look, ever.
    watched->begin(workcell.now());
    return watched;
  };
  std::optional<sim::Cell> opened;
  try {
    opened.emplace(scene, options);
  } catch (const sim::NoSuchDevice& problem) {
    throw no_such_device(command.faults, problem);
  }
  sim::Cell& cell = *opened;
  looks = scene_of(cell.workcell());
  LiveRecorder live(cell.workcell(), *server);
  SceneRecorder bodies(cell.workcell(), *server);
  CellRobot robot(cell);
  server::Locations book = open_locations(command, robot, folder);
  robot.teach_all(book.list());
  trials.know(book);
  MarginMeter margins(knowledge);
  ProfileWatcher profiles(*server, [&cell] { return cell.station().now(); });
  CellRunner runner(cell, known, options.times, command.seed, OnInterrupt::leave, &profiles);
  runner.measure(&margins);
  runner.on_broken_promise(policy_named(command.on_broken_promise));
  const operations::Cell known_of_cell = cell_of(cell, known, scene, command.scene_folders);
  server::DeskOptions desk_options{scene.name,
                                   !command.goes_on,
                                   command.log.empty() ? nullptr : &log,
                                   *known_of_cell.sensors,
                                   book.names(),
                                   &book,
                                   &robot,
                                   known_of_cell.figures,
                                   known_of_cell.unable,
                                   known_of_cell.longest};
  desk_options.refused_together = known_of_cell.refused_together;
  desk_options.runs = &runs;
  desk_options.recording = &recording;
  CellPendant pendant(cell);
  // Where time rushes past, silence comes at once.
  if (command.paced > 0) desk_options.pendant = &pendant;
  if (command.paced <= 0) desk_options.answer_wait = 10ms;
  server::Desk desk(runner, *known_of_cell.skills, *server, desk_options);
  clock_reader = &desk;
  desk.tell_time(runner.now());
  const SkillScholar scholar(known, knowledge, pictures);
  const Serving serving(*server, desk);
  const std::string path = command.announcement.empty()
                               ? server::default_announcement(scene.name, server->port())
                               : command.announcement;
  const Announced announced(path, {command.address, server->port(), offered.tokens});
  tell_addresses(command, scene, *server, path, offered.tokens, out);
  while (!desk.ended()) {
    if (desk.work()) {
      live.flush();
      bodies.flush();
      program::give_back_memory_beyond(most_kept);
      continue;
    }
    if (command.paced > 0) {
      cell.workcell().let_rest(true);
      cell.station().idle(10ms);
      cell.workcell().let_rest(false);
      desk.tell_time(runner.now());
    } else {
      desk.wait(100ms);
    }
  }
  server->stop();
  clock_reader = nullptr;
  out << fmt::format("served for {:.1f} s of the cell\n",
                     std::chrono::duration<double>(cell.station().now()).count());
  const bool untried =
      tell_faults_to_come(command.faults, cell.faults_to_come(), "the cell was closed before", out);
  return untried ? ExitStatus::wrong_specification : ExitStatus::done;
}

}  // namespace pal::workcell
