// A program worked out by hand, against the analyzer and against the runs that are made without it.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

namespace pal::test {

/// The text of tests/differential/`name`.pal; throws if there is none.
std::string program(const std::string& name);

/// `text` with `other` wherever it has `part`.
std::string replaced(std::string text, const std::string& part, const std::string& other);

/// The bound in milliseconds of a program's first requirement. It must be exact, and the runs that are made
/// without the analyzer must attain it. -1: the requirement fails without a bound. The referee must confirm
/// the run that shows it.
std::int64_t bound(const std::string& text);

}  // namespace pal::test
