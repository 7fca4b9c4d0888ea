// Ids of the things that a network is made of.
#pragma once

#include "pal/support/id.hpp"

namespace pal::pan {

using ModuleId = Id<struct ModuleTag>;
using DeviceId = Id<struct DeviceTag>;
using MessageId = Id<struct MessageTag>;
using ChannelId = Id<struct ChannelTag>;
using ConditionId = Id<struct ConditionTag>;
using ActivityId = Id<struct ActivityTag>;
using NodeId = Id<struct NodeTag>;

}  // namespace pal::pan
