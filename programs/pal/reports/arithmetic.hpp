// The additions that make up bounds, as `pal check --explain` prints them.
#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>

#include "analyzer/verdict/verdict.hpp"

namespace pal::program {

/// A line for each number that adds up to the verdict's bound, with the actor, what it does, and where that
/// stands. Nothing if the addition is not known.
void write_arithmetic(const analyzer::Verdict& verdict, std::ostream& out);

/// As JSON: [{"amount_ns", "actor", "what", "file", "line"}]; of a load, nanoseconds of work a second.
nlohmann::ordered_json arithmetic_json(const analyzer::Verdict& verdict);

}  // namespace pal::program
