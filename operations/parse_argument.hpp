// Parameters that a file declares: the arguments of an operation, and what a planned skill is to have.
#pragma once

#include <string>
#include <vector>

#include "operations/fields.hpp"

namespace pal::operations {

/// The object `field`, by name, each with its default and, if it is a number, its range. Reports what it
/// cannot read (PAL1002), and more than `most` of `owner`.
std::vector<pan::Parameter> read_arguments(const std::string& field, std::size_t most, const char* owner,
                                           Fields& fields, Diagnostics& diagnostics);

}  // namespace pal::operations
