// The fields of an object in a file of operations, each asked for by name.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "operations/json_value.hpp"
#include "operations/model.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/finding.hpp"

namespace pal::operations {

/// Reports PAL1002: fields that are missing, of the wrong type, given twice, or that nobody asked for. A
/// value that was refused is one finding; the field does not count as missing, too.
class Fields {
 public:
  using Kind = JsonValue::Kind;

  /// Both outlive the fields.
  Fields(const JsonValue& object, Diagnostics& diagnostics);

  const JsonValue* find(const std::string& name);
  /// Null, and a finding, if it is of another kind; `what` says what it must be.
  const JsonValue* find(const std::string& name, Kind kind, const char* what);
  std::string text(const std::string& name, SourceSpan* where = nullptr);
  std::string needed_text(const std::string& name, SourceSpan* where = nullptr);
  Connection connection(const std::string& name);

  void refuse(const std::string& name) { refused_.push_back(name); }
  bool refused(const std::string& name) const;
  void missing(const std::string& name);
  template <class... Arguments>
  Diagnostic& report(std::type_identity_t<FindingWith<sizeof...(Arguments)>> finding, SourceSpan where,
                     const Arguments&... arguments) {
    return diagnostics_.report(finding, where, arguments...);
  }
  /// Once all that can be there has been asked for.
  void refuse_the_rest();

 private:
  const JsonValue& object_;
  Diagnostics& diagnostics_;
  std::vector<bool> taken_;
  std::vector<std::string> known_, refused_;
};

/// The values that a number may have.
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool whole = false;
  const char* what = "a number";
  const char* unit = "";
};
inline constexpr double longest_time = 86'400;  // s
inline constexpr Range any_number{};
inline constexpr Range any_time{0, longest_time, false, "a time", " s"};

/// A completion code: a whole number of at most seven digits.
bool is_code(const JsonValue& value);

/// {"count-of": "icon"}, {"argument": "name"}, or {"output-of": "icon", "name": "figure"}. Written: it is
/// none of these, and that is reported.
Source read_source(const JsonValue& object, Diagnostics& diagnostics);

/// A number, or where it comes from when the operation runs. Nothing: it is not there, or has been refused.
std::optional<Amount> amount_of(const JsonValue& value, const std::string& name, const Range& range,
                                Fields& fields, Diagnostics& diagnostics);
std::optional<Amount> read_amount(const std::string& name, const Range& range, Fields& fields,
                                  Diagnostics& diagnostics);
/// A number that must be written.
std::optional<double> read_number(const std::string& name, const Range& range, Fields& fields,
                                  Diagnostics& diagnostics);

}  // namespace pal::operations
