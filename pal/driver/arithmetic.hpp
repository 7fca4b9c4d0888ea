// The additions that make up bounds.
#pragma once

#include <iosfwd>
#include <string>

#include "analyzer/verdict/verdict.hpp"

namespace pal::driver {

/// A line for each number that makes up the verdict's bound, with who does what and where that stands;
/// nothing if its addition is not known.
void write_arithmetic(const analyzer::Verdict& verdict, std::ostream& out);

/// As JSON: [{"amount_ns", "actor", "what", "file", "line"}]; of a load, nanoseconds of work a second.
std::string arithmetic_json(const analyzer::Verdict& verdict);

}  // namespace pal::driver
