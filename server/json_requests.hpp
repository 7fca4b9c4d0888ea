// Requests of the JSON protocol: JSON-RPC 2.0, and the parameters of its methods.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "server/json_values.hpp"

namespace pal::server {

// JSON-RPC's own error codes, then ours: `first_refusal` + Refusal::Why.
constexpr int no_json = -32700, no_request = -32600, no_method = -32601, bad_parameters = -32602,
              internal_error = -32603;
constexpr int not_admitted = 1, first_refusal = 2;

/// Why a request is refused; what the functions below throw.
struct Problem {
  int code = 0;
  std::string message;
  Json data = Json::object();  // the schema's ErrorData
};

Problem problem_of(const Refusal& refusal);
Problem problem_of(int code, std::string message, std::string hint = {});

[[noreturn]] void fail(int code, std::string message);
[[noreturn]] void fail(Refusal::Why why, std::string message, std::string hint = {});

/// A discarded value if the text is not JSON. Throws Problem if it is too deep, so that nothing deep gets as
/// far as to code that calls itself.
Json parse(std::string_view text);

/// The members of "params": an object, or nothing. Throws Problem for anything else. Copies share them.
class Members {
 public:
  Members() = default;
  /// Takes them out of the request.
  explicit Members(Json& request);
  /// Throws Problem unless it is there and is a text.
  std::string text(const char* name) const;
  /// `otherwise` if it is not there.
  std::string text(const char* name, const char* otherwise) const;
  /// Null if it is not there.
  const Json* find(const char* name) const;
  /// A whole number within these bounds. Throws Problem.
  std::int64_t whole(const char* name, std::int64_t low, std::int64_t high) const;
  std::optional<std::int64_t> may_be_whole(const char* name, std::int64_t low, std::int64_t high) const;
  /// False if it is not there.
  bool truth(const char* name) const;
  /// The text of each file by its name; empty if it is not there.
  std::map<std::string, std::string> files() const;
  /// A text of at most so many bytes; empty if it is not there.
  std::string short_text(const char* name, std::size_t most) const;

 private:
  std::shared_ptr<const Json> json_ = std::make_shared<Json>(Json::object());
};

/// A message as a request of JSON-RPC, or why it is none.
struct ParsedRequest {
  Json id;  // null: it is not known
  bool answered = true;
  std::string method;
  Members members;
  std::optional<Problem> problem;
};

ParsedRequest read_request(std::string_view text);

/// A number, true, false or a text. Throws Problem for anything else, which it calls `name`.
operations::Value value_of(const std::string& name, const Json& json);

// The commands that these members make. They throw Problem.
RunSkill run_skill(const Members& members);
SetParameter set_parameter(const Members& members);
SetBreakpoint set_breakpoint(const Members& members);
AnswerQuestion answer_question(const Members& members);

}  // namespace pal::server
