// Whether measured times are within those that an environment declares.
#pragma once

#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::check {

/// Compares each of `measured`, an environment as runtime::Measurement writes it, with the environment of the
/// same name in `declared`, and with the times that `skills` bring. Reports
/// - an activity or a cost that took longer than declared (PAL0750);
/// - a device that was slower, faster or more frequent (PAL0751);
/// - what is measured but not declared (PAL0752).
///
/// An activity that took less than its best time is no finding, because another computer may be faster.
void check_measured(const std::vector<pan::Network>& skills, const std::vector<pan::Environment>& declared,
                    const std::vector<pan::Environment>& measured, Diagnostics& diagnostics);

}  // namespace pal::check
