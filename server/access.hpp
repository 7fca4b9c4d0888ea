// Which clients may connect: the checks before any command is obeyed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pal::server {

/// 32 hexadecimal digits from the system's random numbers. Throws std::system_error.
std::string make_token();

/// Takes the same time wherever the first difference is.
bool same_token(std::string_view given, std::string_view token);

/// Hosts are names or addresses without a port; IPv6 in brackets: "localhost", "[::1]", "cell.example".
struct AccessRules {
  /// What a client may have called this machine (the Host field). A page of another site whose name was
  /// pointed at this machine comes with its own name, and is refused.
  std::vector<std::string> hosts{"localhost", "127.0.0.1", "[::1]"};
  /// Pages of which browsers may talk to this server, as "http://localhost:8000"; those of the hosts at the
  /// server's own port are allowed besides.
  std::vector<std::string> origins;
  unsigned port = 0;  // the server's
};

/// `host` is a Host field: a host, with or without the server's port.
bool host_allowed(std::string_view host, const AccessRules& rules);
/// `origin` is an Origin field, which browsers send, and programs do not: empty is allowed.
bool origin_allowed(std::string_view origin, const AccessRules& rules);
/// An address of this machine that others cannot reach.
bool is_loopback(const std::string& address);

}  // namespace pal::server
