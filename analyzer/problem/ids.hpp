// Typed indices of the things that a problem is made of.
#pragma once

#include <concepts>
#include <cstdint>

#include "pal/pan/ids.hpp"
#include "pal/support/id.hpp"

namespace pal::analyzer {

/// An id that the compositional analysis still takes for a number, and makes of one. No other part may.
template <class Tag>
struct CountedId : Id<Tag> {
  constexpr CountedId() = default;
  constexpr CountedId(Id<Tag> id) : Id<Tag>(id) {}
  template <std::integral Number>
  constexpr CountedId(Number number) : Id<Tag>(Id<Tag>::of(static_cast<std::int32_t>(number))) {}
  static constexpr CountedId of(std::int32_t value) { return CountedId(value); }
  constexpr operator int() const { return this->value; }
};

/// In Problem::processors and Environment::processors. A question what more of them would do counts on.
using ProcessorId = Id<struct ProcessorTag>;

/// In Problem::requirements.
using RequirementId = Id<struct ProblemRequirementTag>;

/// In Problem::channels, which are the network's.
using ChannelId = CountedId<pan::ChannelTag>;

/// In Problem::conditions, which are the network's.
using pan::ConditionId;

/// In Problem::devices: those of the network, then its modules without a body.
using DeviceId = Id<struct ProblemDeviceTag>;

/// In Problem::statements.
using StatementId = Id<struct StatementTag>;

/// In Problem::calls.
using CallId = Id<struct CallTag>;

/// In Problem::kept.
using KeptId = Id<struct KeptTag>;

}  // namespace pal::analyzer
