// A value that an icon needs and that is not there when the icon has its turn.
#pragma once

#include <stdexcept>

#include "operations/model.hpp"

namespace pal::operations {

/// what() says which, and why.
class MissingValue : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The default of an argument.
Value default_of(const pan::Parameter& argument);

}  // namespace pal::operations
