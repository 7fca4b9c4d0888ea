#include "runtime/kernel/thrown.hpp"

#include <exception>

namespace pal::runtime {

std::string what_was_thrown() {
  try {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception that is not a std::exception";
  }
}

}  // namespace pal::runtime
