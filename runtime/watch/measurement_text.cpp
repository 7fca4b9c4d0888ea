// What was measured, as PAL.
#include <algorithm>
#include <string>
#include <string_view>

#include "pal/runtime/measurement.hpp"
#include "runtime/watch/held_time.hpp"

namespace pal::runtime {

namespace {

/// What one line of the environment sums up.
struct Summary {
  std::string name;    // "extract-z OF LS1", "SET"
  std::string module;  // of an activity
  Time least = Time::max();
  Time greatest{};
  std::uint64_t count = 0;

  void add(const Extremes& extremes) {
    if (extremes.count() == 0) return;
    least = std::min(least, extremes.least());
    greatest = std::max(greatest, extremes.greatest());
    count += extremes.count();
  }
};

struct Unit {
  Time::rep nanoseconds;
  const char* name;
};

Unit unit_for(Time greatest) {
  if (greatest >= std::chrono::milliseconds(1)) return {1'000'000, "ms"};
  return greatest >= std::chrono::microseconds(1) ? Unit{1'000, "us"} : Unit{1, "ns"};
}

/// Exactly, as a decimal: "5.704".
std::string number(Time time, const Unit& unit) {
  std::string text = std::to_string(time.count() / unit.nanoseconds);
  const Time::rep rest = time.count() % unit.nanoseconds;
  if (rest == 0) return text;
  std::string digits = std::to_string(unit.nanoseconds + rest).substr(1);
  digits.erase(digits.find_last_not_of('0') + 1);
  return text + "." + digits;
}

std::string written(Time time) {
  const Unit unit = unit_for(time);
  return number(time, unit) + " " + unit.name;
}

std::string interval(Time least, Time greatest) {
  const Unit unit = unit_for(greatest);
  return (least == greatest ? "" : number(least, unit) + " TO ") + number(greatest, unit) + " " + unit.name;
}

std::string times(std::uint64_t count, const char* what = "time") {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Which COST a statement is of; empty: an activity, or nothing that is written by hand.
std::string cost_of(std::string_view statement) {
  if (statement.starts_with("SPC(")) return "SET";
  return statement.starts_with("TXM(") ? "SEND" : "";
}

bool is_activity(std::string_view statement) {
  return statement.find_first_of("( ") == std::string_view::npos && statement != "CASE" &&
         statement != "CONCURRENT" && statement != "REPEAT";
}

Summary& summary(std::vector<Summary>& all, const std::string& name, std::string_view module) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Summary& each) {
    return each.name == name && each.module == module;
  });
  return found != all.end() ? *found : all.emplace_back(Summary{name, std::string(module)});
}

}  // namespace

std::string Measurement::activities() const {
  std::vector<Summary> found, costs;
  for (std::size_t s = 0; s < statements_.size(); ++s) {
    const StatementSpec& statement = wiring_.statements[s];
    const std::string cost = cost_of(statement.text);
    if (!cost.empty()) {
      summary(costs, cost, "").add(statements_[s]);
    } else if (is_activity(statement.text)) {
      summary(found, std::string(statement.text), statement.module).add(statements_[s]);
    }
  }
  std::string text;
  for (const Summary& each : found) {
    const std::string name = each.name + " OF " + each.module;
    text += each.count == 0 ? "  # not reached: " + name + "\n"
                            : "  TIME " + name + " : " + interval(each.least, each.greatest) + "  # " +
                                  times(each.count) + "\n";
  }
  for (const Summary& each : costs) {
    if (each.count == 0) continue;
    text += "  COST " + each.name + " " + interval(each.least, each.greatest) + "  # " + times(each.count) +
            (each.name == "SET" ? ", the decisions alone\n" : ", making and packing of messages alone\n");
  }
  return text;
}

std::string Measurement::devices() const {
  std::string text;
  for (const std::string_view name : wiring_.devices) {
    const auto found = std::find_if(devices_.begin(), devices_.end(),
                                    [&](const KnownDevice& each) { return each.name == name; });
    const std::string device(name);
    bool any = false;
    if (found != devices_.end() && found->answers.count() > 0) {
      any = true;
      text += "  DEVICE " + device + " ON REQUEST " +
              interval(found->answers.least(), found->answers.greatest()) + "  # " +
              times(found->answers.count(), "answer") + "\n";
    } else if (found != devices_.end()) {
      for (const Port& port : found->ports) {
        if (any || port.apart.count() == 0) continue;
        any = true;
        // EVERY and JITTER whose difference is the least separation, and whose sum the greatest, or 1 ns
        // less.
        const Time least = std::max(port.apart.least(), Time(1));
        const Time jitter = (port.apart.greatest() - least) / 2;
        const Time period = least + jitter;
        text += "  DEVICE " + device + " EVENT " + port.message + " EVERY " + written(period) +
                (jitter == Time::zero() ? "" : " JITTER " + written(jitter)) + "  # " +
                written(port.apart.least()) +
                (jitter == Time::zero() ? "" : " to " + written(port.apart.greatest())) + " apart, " +
                times(port.apart.count()) + "\n";
      }
    }
    if (!any) text += "  # not measured: device " + device + "\n";
  }
  return text;
}

std::string Measurement::environment() const {
  std::string text =
      "# Measured in " + times(runs_, "run") + " of skill " + std::string(wiring_.skill) + ".\n";
  text +=
      "# For pal check with --measured. A measurement is no bound: nothing is proved from these figures.\n"
      "#\n"
      "# TIME, COST: how long the C++ of the activities held a processor of this computer, whatever time the "
      "skill ran in:\n"
      "#   its processor time; if it slept or waited, the time on the wall. Reading the clock is in each: "
      "about " +
      written(cost_of_held_time()) +
      ".\n"
      "# DEVICE: in the time of the run, from a request to its answer, or from message to message.\n"
      "ENVIRONMENT " +
      std::string(wiring_.environment) + "\n";
  for (const ProcessorSpec& processor : wiring_.processors)
    text +=
        "  PROCESSOR " + std::string(processor.name) + (processor.preemptive ? "" : " NONPREEMPTIVE") + "\n";
  text += "\n" + devices() + "\n" + activities();
  return text + "END ENVIRONMENT\n";
}

}  // namespace pal::runtime
