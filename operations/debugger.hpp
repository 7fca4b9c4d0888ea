// An operation run by hand, with one command in each line.
#pragma once

#include <iosfwd>

#include "operations/executor.hpp"

namespace pal::operations {

/// Obeys the lines of `in` until "quit" or its end, and answers on `out`: step, run, set, break, clear, from,
/// where, list, help. A line that cannot be obeyed is answered with the reason, and changes nothing.
void debug(Executor& executor, std::istream& in, std::ostream& out);

}  // namespace pal::operations
