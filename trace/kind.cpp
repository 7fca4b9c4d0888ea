#include "pal/trace/kind.hpp"

#include <array>

namespace pal::trace {

namespace {

constexpr std::array<const char*, 18> names = {
    "ready",   "start", "stop", "done", "block", "give_up", "put",      "take",  "drop",
    "overrun", "set",   "read", "busy", "idle",  "cancel",  "complete", "fault", "broken",
};
static_assert(names.size() == static_cast<std::size_t>(Kind::broken) + 1);

}  // namespace

const char* name(Kind kind) {
  return names.at(static_cast<std::size_t>(kind));
}

std::optional<Kind> kind_named(std::string_view text) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text == names[i]) return static_cast<Kind>(i);
  }
  return std::nullopt;
}

SubjectTable subject_table(Kind kind) {
  switch (kind) {
    case Kind::block:
    case Kind::give_up:
    case Kind::put:
    case Kind::take:
    case Kind::drop:
    case Kind::overrun:
      return SubjectTable::channels;
    case Kind::set:
    case Kind::read:
      return SubjectTable::conditions;
    default:
      return SubjectTable::none;
  }
}

}  // namespace pal::trace
