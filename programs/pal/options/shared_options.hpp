// Options that several commands have, and the exit statuses at the end of their help.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <string>

#include "programs/pal/commands/commands.hpp"

namespace pal::program {

/// Of commands that prove requirements, and of the program as a whole.
extern const char* const statuses_of_proofs;

/// Of commands that prove nothing, or to which what they prove is no finding.
extern const char* const statuses_of_results;

/// --max-errors.
void add_max_errors(CLI::App& command, std::size_t& most);

/// The files, --environment, --skill, --environment-name and --max-errors.
void add_selection(CLI::App& command, Selection& selection);

/// --max-states, --timeout and --threads. `timeout` describes --timeout; null: as for check.
void add_limits(CLI::App& command, ProofLimits& limits, const char* timeout = nullptr);

/// --cache and --cache-size.
void add_cache(CLI::App& command, std::string& folder, std::uint64_t& size);

/// --format: text or json.
void add_format(CLI::App& command, Format& format);

}  // namespace pal::program
