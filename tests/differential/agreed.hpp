// The exact bounds of a program, as far as every judge that shares nothing with the exploration agrees with
// them.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace pal::test {

/// Bounds by the name of the requirement, in milliseconds; of a loss a number. Or one of these.
using Bounds = std::map<std::string, std::int64_t>;
constexpr std::int64_t never_measured = -1;
constexpr std::int64_t without_bound = -2;

/// Of all requirements of tests/differential/`name`.pal but loads. It must be so small that all its runs can
/// be followed (tests/support/runs): they must attain each bound, or measure nothing. The run checker must
/// confirm each run that is shown, and each run of the simulator; no compositional bound may be broken.
Bounds agreed_bounds(const std::string& name);

/// Those of the exploration alone, and without those that measure nothing or have none.
Bounds explored_bounds(const std::string& name);

/// The same of the program beside a module that has no influence on it, with that left out. Each slice
/// must leave something out.
Bounds sliced_bounds(const std::string& name);

/// What the analysis proves by slices (slice_bound), each of which must leave something out.
Bounds proved_bounds(const std::string& name);

}  // namespace pal::test
