#include "server/access.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <system_error>

namespace pal::server {
namespace {

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "no random numbers for a token");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool same_token(std::string_view given, std::string_view token) {
  unsigned difference = given.size() == token.size() && !token.empty() ? 0U : 1U;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const auto a = static_cast<unsigned char>(i < given.size() ? given[i] : 0);
    difference |= static_cast<unsigned>(a ^ static_cast<unsigned char>(token[i]));
  }
  return difference == 0;
}

bool host_allowed(std::string_view host, const AccessRules& rules) {
  return std::any_of(rules.hosts.begin(), rules.hosts.end(), [&](const std::string& allowed) {
    return same_name(host, allowed) || same_name(host, fmt::format("{}:{}", allowed, rules.port));
  });
}

bool origin_allowed(std::string_view origin, const AccessRules& rules) {
  if (origin.empty()) return true;
  const auto listed = [&](const std::string& allowed) { return same_name(origin, allowed); };
  if (std::any_of(rules.origins.begin(), rules.origins.end(), listed)) return true;
  return std::any_of(rules.hosts.begin(), rules.hosts.end(), [&](const std::string& host) {
    return same_name(origin, fmt::format("http://{}:{}", host, rules.port));
  });
}

bool is_loopback(const std::string& address) {
  return address == "::1" || address == "localhost" || address.rfind("127.", 0) == 0;
}

}  // namespace pal::server
