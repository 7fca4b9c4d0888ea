// Whether what a client wants to run may run in this cell.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <variant>

#include "operations/check.hpp"
#include "server/command.hpp"

namespace pal::server {

/// What the cell has. All outlive the rules.
struct ProgramRules {
  const operations::Skills& skills;
  const operations::Sensors& sensors;
  const std::optional<std::set<std::string>>& locations;  // nothing: not known
};

/// The first mistake in a skill and its parameters, with a way out; nothing, if it may run.
std::optional<std::string> mistake_in(const RunSkill& command, const ProgramRules& rules);

/// The operation that the command's files hold, or the first mistake in them, with its place and a way out.
std::variant<operations::Program, std::string> load(LoadOperation command, const ProgramRules& rules);

}  // namespace pal::server
