// Runs skills, one at a time.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>

#include "pal/runtime/in_use.hpp"
#include "pal/runtime/outcome.hpp"
#include "pal/runtime/skill.hpp"

namespace pal::runtime {

/// {"reach", 5}; {.name = "location", .text = "park"}.
struct ParameterValue {
  std::string name;
  double value = 0;                                // in the parameter's unit; booleans 0 or 1
  std::optional<std::string> text = std::nullopt;  // of a parameter that is a TEXT, instead of `value`
};

class Dispatcher {
 public:
  /// The devices, found by their names, and the world outlive the dispatcher.
  Dispatcher(std::span<Device* const> devices, World& world) : devices_(devices), world_(world) {}

  /// Runs the skill from time 0 to its end: in virtual time, or in real time if the options say so. Code that
  /// does not return in real time ends the process (RealTime::hang_timeout). Parameters that are not given
  /// have their defaults. Never throws because of a skill, a device or the world.
  ///
  /// These end the skill before it begins, with its error completion and the reason:
  /// - a parameter that is not allowed;
  /// - a device that is missing, or has other ports than the skill needs;
  /// - a device that is null, or a time of the options that is nothing or too long;
  /// - a dispatcher, a skill, a device or a world that is running already;
  /// - a run that a device begins in its own receive.
  Outcome run(Skill& skill, std::span<const ParameterValue> parameters = {}, const RunOptions& options = {});

  /// The same with parameters in braces: run(skill, {{"reach", 40}}).
  Outcome run(Skill& skill, std::initializer_list<ParameterValue> parameters,
              const RunOptions& options = {}) {
    return run(skill, std::span<const ParameterValue>(parameters.begin(), parameters.size()), options);
  }

 private:
  std::span<Device* const> devices_;
  World& world_;
  InUse in_use_;
};

/// The outcome of a skill that does not begin: its error completion, and why.
Outcome refused(const Skill& skill, const std::string& reason);

}  // namespace pal::runtime
