// One question to a device and its answer, without a skill.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pal/runtime/run_control.hpp"
#include "runtime/drivers/station.hpp"

namespace pal::sim {

/// The answer of a device; or why there is none; or that it was stopped.
struct Answer {
  std::optional<std::vector<double>> fields;
  std::string problem;
  bool stopped = false;
};

/// Sends `request MESSAGE` and lets station time pass until MESSAGE comes. `prepare`: as before a skill that
/// uses the device. No skill runs meanwhile. `control` may be null.
Answer ask(runtime::drivers::Station& station, runtime::drivers::Driver& driver, const std::string& message,
           bool prepare, const runtime::RunControl* control);

}  // namespace pal::sim
