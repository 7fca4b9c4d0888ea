// What the simulator knows of a skill's end: more than any sensor does.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/run/skills/support/workshop.hpp"

namespace pal::test {

/// A skill that has ended, with the arm at rest for 0.3 s.
struct Ended {
  Workshop& shop;
  const runtime::Outcome& outcome;
  std::vector<runtime::ParameterValue> parameters;  // that were given
  const sim::Sample& before;                        // when it began
  bool held_before = false;                         // the fingers held a part
  std::map<std::string, Eigen::Vector3d> things_before;

  /// As given, or the template's default.
  double parameter(const std::string& name) const;
  std::string text(const std::string& name) const;
  const sim::Sample& after() const { return shop.cell().workcell().log().back(); }
  /// The samples from the skill's beginning to its end, without the rest.
  std::span<const sim::Sample> during() const;
  bool stands_still() const;
  /// How far the tip and the tool's axes are from where they were, mm and deg.
  double moved() const;
  double turned() const;
  /// How hard the tool presses along its own axis, N, without its weight.
  double pressing(const sim::Sample& sample) const;
};

/// What is shown of an end in figures, and what of its words is not so.
struct Judgement {
  std::string name;  // of the figure: "N at rest"
  double figure = 0;
  std::string untrue;  // empty: what the completion says is so
};

/// Judges a skill's end by its completion's words and by its template's postcondition. Throws
/// std::runtime_error for a skill or a code that it does not know.
Judgement judge(const Ended& ended);

}  // namespace pal::test
