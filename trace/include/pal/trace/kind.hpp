// What the kind of an event says about its other fields.
#pragma once

#include <optional>
#include <string_view>

#include "pal/trace/trace.hpp"

namespace pal::trace {

/// The kind that is spelt `text` in files; none if there is no such kind.
std::optional<Kind> kind_named(std::string_view text);

enum class SubjectTable { none, channels, conditions };

/// The table of the trace that an event's `subject` is an index into.
SubjectTable subject_table(Kind kind);

}  // namespace pal::trace
