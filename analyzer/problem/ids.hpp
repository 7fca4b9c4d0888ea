// Typed indices of the things that a problem is made of.
#pragma once

#include "pal/pan/ids.hpp"
#include "pal/support/id.hpp"

namespace pal::analyzer {

/// In Problem::processors and Environment::processors. A question what more of them would do counts on.
using ProcessorId = Id<struct ProcessorTag>;

/// In Problem::requirements.
using RequirementId = Id<struct ProblemRequirementTag>;

/// In Problem::steps.
using StepId = Id<struct StepTag>;

/// In Problem::threads.
using ThreadId = Id<struct ThreadTag>;

/// In Problem::channels, which are the network's.
using pan::ChannelId;

/// In Problem::conditions, which are the network's.
using pan::ConditionId;

/// In Problem::devices: those of the network, then its modules without a body.
using DeviceId = Id<struct ProblemDeviceTag>;

/// In Problem::statements.
using StatementId = Id<struct StatementTag>;

/// In Problem::calls.
using CallId = Id<struct CallTag>;

/// In Problem::loops.
using LoopId = Id<struct LoopTag>;

/// In Problem::kept.
using KeptId = Id<struct KeptTag>;

}  // namespace pal::analyzer
