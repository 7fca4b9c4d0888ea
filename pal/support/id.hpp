// Typed indices: a ModuleId cannot be taken for a ChannelId.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace pal {

/// Index into the vector that owns things of kind `Tag`; -1 names nothing.
template <class Tag>
struct Id {
  std::int32_t value = -1;

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value(static_cast<std::int32_t>(index)) {}

  /// Of a number that says, like `value`, with -1 that it names nothing.
  static constexpr Id of(std::int32_t value) {
    Id id;
    id.value = value;
    return id;
  }

  constexpr bool valid() const { return value >= 0; }
  constexpr std::size_t index() const { return static_cast<std::size_t>(value); }

  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

}  // namespace pal
