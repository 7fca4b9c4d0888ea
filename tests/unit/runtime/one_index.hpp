// Lists with one index, as a RequirementSpec wants them.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace pal::test {

inline constexpr std::array indices{0, 1, 2, 3};

/// The channel, statement, thread or device with this index, as a list.
inline std::span<const int> only(int index) {
  return std::span(indices).subspan(static_cast<std::size_t>(index), 1);
}

}  // namespace pal::test
