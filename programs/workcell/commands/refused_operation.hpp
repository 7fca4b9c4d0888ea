// What is said of an operation that is not run because of its files.
#pragma once

#include <iosfwd>
#include <string>

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "programs/workcell/session/failure.hpp"

namespace pal::workcell {

/// Prints the findings, and returns the failure that ends the command. If no file could be read at all, the
/// failure itself says why, and nothing is printed before.
Failure refused_operation(const std::string& file, const Diagnostics& diagnostics,
                          const SourceManager& sources, std::ostream& error);

}  // namespace pal::workcell
