// Skills and environments that allow every run of others, and some more.
#pragma once

#include <random>
#include <string>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::test {

/// Some times, limits and devices become others, mostly ones at which much happens at one instant. Says what
/// was done, for people.
std::string other_times(pan::Network& network, pan::Environment& environment, std::mt19937_64& engine);

/// Allows more: fixed times lie in intervals, devices are late, begin at any phase or send when they like,
/// conditions get any value. Says what was done; "": nothing.
std::string widen(pan::Network& network, pan::Environment& environment, std::mt19937_64& engine);

/// All times of the environment, of the waits and of the requirements `by` times as long.
void scale(pan::Network& network, pan::Environment& environment, int by);

/// What all these times are multiples of; at least a nanosecond.
Duration grain(pan::Network network, pan::Environment environment);

}  // namespace pal::test
