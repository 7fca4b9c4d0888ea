// Emulated devices, each by itself at the far end of a line: what `workcell serve-port` offers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/drivers/link.hpp"
#include "runtime/drivers/timeline.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

/// A line of a device to the outside.
struct ServedLine {
  std::string name;  // "alter"; empty: the device's own, and there is no other
  runtime::drivers::LineSpeed speed;
};

struct ServedPort {
  std::string name;
  std::string description;
  std::vector<ServedLine> lines;  // at least one
  /// The device at the far ends of its lines, alive as long as the answer is. What it is given outlives it.
  std::function<std::shared_ptr<void>(runtime::drivers::Timeline&,
                                      const std::vector<runtime::drivers::Link*>&, Workcell&,
                                      std::uint64_t seed)>
      make;
  /// Only where the scene's tool is this one, as in scene `scene`.
  std::optional<ToolKind> tool = std::nullopt;
  std::string scene{};
};

/// A device of another library is added by a line here.
std::vector<ServedPort> served_ports();

}  // namespace pal::sim
