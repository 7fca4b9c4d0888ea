// workcell serve-port: one emulated device behind a port.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <vector>

#include "pal/support/nearest.hpp"
#include "programs/workcell/options/command_line.hpp"
#include "programs/workcell/session/interrupt.hpp"
#include "runtime/drivers/streams/bridge.hpp"
#include "runtime/drivers/streams/outside.hpp"
#include "sim/cell/served_port.hpp"
#include "sim/scene.hpp"

namespace pal::workcell {
namespace {

constexpr runtime::Time stretch = std::chrono::milliseconds(100);

sim::ServedPort find_port(const std::string& wanted) {
  std::vector<std::string> names;
  for (const sim::ServedPort& port : sim::served_ports()) {
    if (port.name == wanted) return port;
    names.push_back(port.name);
  }
  throw Failure(ExitStatus::usage, "serve-port " + wanted, "there is no device of this name",
                fmt::format("the devices are: {}", fmt::join(names, ", ")));
}

/// The devices that the command names, each once and each fit for the cell's tool.
std::vector<sim::ServedPort> find_ports(const ServePortCommand& command, const sim::Workcell& workcell,
                                        const sim::Scene& scene) {
  std::vector<sim::ServedPort> ports;
  for (const std::string& device : command.devices) {
    const sim::ServedPort port = find_port(device);
    if (std::any_of(ports.begin(), ports.end(), [&](const auto& other) { return other.name == port.name; }))
      throw Failure(ExitStatus::usage, "serve-port " + device, "the device is named twice", "name it once");
    if (port.tool && workcell.tool_kind() != *port.tool)
      throw Failure(ExitStatus::wrong_specification, "serve-port " + port.name,
                    "scene " + scene.name + " has another tool",
                    "choose one that has it: --scene " + port.scene);
    ports.push_back(port);
  }
  return ports;
}

/// The `number`th line of all: TCP ports follow one another, a serial port is for the first alone.
std::unique_ptr<runtime::drivers::OutsideLink> open_link(const ServePortCommand& command, std::size_t number,
                                                         const runtime::drivers::LineSpeed& speed,
                                                         runtime::drivers::Outside& outside,
                                                         runtime::drivers::Timeline& timeline) {
  try {
    if (command.tcp >= 0) {
      const int port = command.tcp == 0 ? 0 : command.tcp + static_cast<int>(number);
      if (port > 65535)
        throw std::runtime_error(fmt::format("there are {} lines, and {} is no port", number + 1, port));
      return outside.listen_tcp(timeline, static_cast<std::uint16_t>(port));
    }
    if (!command.serial.empty() && number == 0)
      return outside.open_serial(timeline, command.serial, static_cast<unsigned>(speed.baud));
    return outside.open_pseudo_terminal(timeline);
  } catch (const std::exception& problem) {
    throw Failure(ExitStatus::usage, fmt::format("serve-port {}", fmt::join(command.devices, " ")),
                  problem.what(), "choose another port, or --pty");
  }
}

/// A name for the far end of a pseudo-terminal, for as long as it lives.
class Name {
 public:
  Name(std::string path, const std::string& target) : path_(std::move(path)) {
    if (path_.empty()) return;
    std::error_code problem;
    if (std::filesystem::is_symlink(path_)) std::filesystem::remove(path_, problem);
    std::filesystem::create_symlink(target, path_, problem);
    if (problem)
      throw Failure(ExitStatus::usage, "--link " + path_, problem.message(),
                    "name a file that does not exist, in a folder that does");
  }
  Name(const Name&) = delete;
  Name& operator=(const Name&) = delete;
  ~Name() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
  }

 private:
  std::string path_;
};

/// One line of a device, and what it is at outside.
struct Line {
  Line(const ServePortCommand& command, const sim::ServedPort& port, const sim::ServedLine& served,
       std::size_t number, runtime::drivers::Outside& outside, runtime::drivers::Timeline& timeline)
      : name(served.name.empty() ? port.name : served.name),
        alias(command.link.empty() || number == 0 ? command.link : command.link + "-" + name),
        link(open_link(command, number, served.speed, outside, timeline)),
        wire(timeline, served.speed),
        bridge(wire.a(), *link),
        shown(alias, link->address()) {}

  std::string name;
  std::string alias;  // a symbolic link; empty: none
  std::unique_ptr<runtime::drivers::OutsideLink> link;
  runtime::drivers::Wire wire;
  runtime::drivers::Bridge bridge;
  Name shown;
};

}  // namespace

ExitStatus serve_port(const ServePortCommand& command, const runtime::RunControl& control,
                      std::ostream& out) {
  for (const std::string& device : command.devices) find_port(device);  // before a scene is loaded
  const sim::Scene scene =
      sim::find_scene(command.scene, {command.scene_folders.begin(), command.scene_folders.end()});
  sim::Workcell workcell(scene, {.keep_log = false});
  const std::vector<sim::ServedPort> ports = find_ports(command, workcell, scene);
  runtime::drivers::Outside outside;
  runtime::drivers::Station station(workcell, &outside);
  std::deque<Line> lines;
  std::vector<std::shared_ptr<void>> devices;
  for (const sim::ServedPort& port : ports) {
    std::vector<runtime::drivers::Link*> ends;
    for (const sim::ServedLine& line : port.lines)
      ends.push_back(
          &lines.emplace_back(command, port, line, lines.size(), outside, station.timeline()).wire.b());
    devices.push_back(port.make(station.timeline(), ends, workcell, command.seed));
  }
  for (const Line& line : lines)
    out << fmt::format("{} in scene {} at {}{}\n", line.name, scene.name, line.link->address(),
                       line.alias.empty() ? "" : " (" + line.alias + ")");
  out << "Ctrl-C ends it\n";
  check_told(out);
  while (!control.stopping()) station.idle(stretch);
  out << fmt::format("served for {:.1f} s\n", std::chrono::duration<double>(station.now()).count());
  return ExitStatus::done;
}

}  // namespace pal::workcell
