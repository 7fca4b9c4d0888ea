// Ids of what the compositional analysis is made of.
#pragma once

#include "analyzer/problem/ids.hpp"

namespace pal::analyzer::compositional {

/// In Segments.
using SegmentId = Id<struct SegmentTag>;

/// In Forest::sources.
using SourceId = Id<struct ForestSourceTag>;

/// In Forest::nodes.
using NodeId = Id<struct ForestNodeTag>;

}  // namespace pal::analyzer::compositional
