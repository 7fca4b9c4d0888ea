// The figures of an environment that a designer asks about: one each line of it.
#pragma once

#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer::whatif {

/// A time with a best and a worst.
struct Figure {
  std::string name;  // "extract-z OF LS1", "SEND", "LATENCY BETWEEN PROCESSORS", "answer of force-torque"
  Interval time;
};

/// The times of `environment` that matter to `network`. In this order: its activities, the costs of
/// statements, the latencies, the answers of its devices on request.
std::vector<Figure> figures(const pan::Network& network, const pan::Environment& environment);

/// Whether all environments have a figure of that name: a cost or a latency. An activity that is called so is
/// the figure "ACTIVITY SEND".
bool is_common_figure(const std::string& name);

/// The names that a change may give a new figure: "extract-z OF LS1", "SEND", "answer of sensor",
/// "alter.period".
std::vector<std::string> figure_names(const pan::Environment& environment);

/// Where the figure of that name stands in `environment`; null: it has none.
Interval* find_figure(pan::Environment& environment, const std::string& name);

/// Makes a change that is given as text:
/// - "extract-z OF LS1 = 5 TO 7 ms", "SEND = 0.1 ms", "answer of force-torque = 6..8 ms";
/// - "alter.period = 20 ms" (also phase, jitter, collecting);
/// - "SM1.priority = 3", "SM1.2.processor = P1";
/// - "PROCESSOR P4": one more, like the last.
///
/// `..` means TO. An activity without OF means all that have its name. Returns what is wrong with it, or
/// nothing.
std::string change(pan::Environment& environment, const std::string& text);

}  // namespace pal::analyzer::whatif
