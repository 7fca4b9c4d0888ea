// Requests of the JSON protocol: JSON-RPC 2.0, and the parameters of its methods.
#pragma once

#include <string>
#include <string_view>

#include "server/json_values.hpp"

namespace pal::server {

// JSON-RPC's own error codes, then ours.
constexpr int no_json = -32700, no_request = -32600, no_method = -32601, bad_parameters = -32602;
constexpr int not_admitted = 1, first_refusal = 2;

/// Why a request is refused; what the functions below throw.
struct Problem {
  int code = 0;
  std::string message;
};

[[noreturn]] void fail(int code, std::string message);

/// A discarded value if the text is not JSON. Throws Problem if it is too deep, so that nothing deep gets as
/// far as to code that calls itself.
Json parse(std::string_view text);

/// The members of "params": an object, or nothing. Throws Problem for anything else.
class Members {
 public:
  explicit Members(const Json& request);
  /// Throws Problem unless it is there and is a text.
  std::string text(const char* name) const;
  /// `otherwise` if it is not there.
  std::string text(const char* name, const char* otherwise) const;
  /// Null if it is not there.
  const Json* find(const char* name) const;

 private:
  Json json_ = Json::object();
};

/// A number, true, false or a text. Throws Problem for anything else, which it calls `name`.
operations::Value value_of(const std::string& name, const Json& json);

// The commands that these members make. They throw Problem.
RunSkill run_skill(const Members& members);
LoadOperation load_operation(const Members& members);
SetParameter set_parameter(const Members& members);
operations::Breakpoint breakpoint(const Members& members);

}  // namespace pal::server
