// What a client may do, by the token that it has shown.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <string_view>

namespace pal::server {

/// Each may do all that the ones before it may. A viewer may look, pause and stop.
enum class Role { viewer, operating, programmer };

inline constexpr std::array<const char*, 3> role_names{"viewer", "operator", "programmer"};

inline const char* name(Role role) {
  return role_names[static_cast<std::size_t>(role)];
}

/// Nothing: there is no such role.
inline std::optional<Role> role_named(std::string_view text) {
  for (std::size_t i = 0; i < role_names.size(); ++i)
    if (text == role_names[i]) return static_cast<Role>(i);
  return std::nullopt;
}

}  // namespace pal::server
