// Whether what a client wants to run may run in this cell.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "operations/check.hpp"
#include "server/command.hpp"

namespace pal::server {

/// The first mistake in a skill and its parameters, with a way out; nothing, if it may run.
std::optional<std::string> mistake_in(const RunSkill& command, const operations::Cell& cell);

/// The operation that the command's files hold, or the first mistake in them, with its place and a way out.
std::variant<operations::Program, std::string> load(LoadOperation command, const operations::Cell& cell);

}  // namespace pal::server
