// From PAL's names to C++ identifiers.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace pal::codegen {

/// "pc-force" → "pc_force", "request wrench" → "request_wrench". May be a keyword: for parts of identifiers
/// and of file names.
std::string snake_words(std::string_view name);

/// snake_words as an identifier: "class" → "pal_class". It never ends in an underscore, so that a member may.
std::string snake_case(std::string_view name);

/// "range-profile" → "RangeProfile", "SM1" → "SM1".
std::string camel_case(std::string_view name);

/// `text` as a C++ string literal, quotes included.
std::string literal(std::string_view text);

/// One scope of C++: hands out every identifier once.
class Scope {
 public:
  Scope() = default;
  explicit Scope(std::set<std::string> taken) : taken_(std::move(taken)) {}

  /// `wish`, or with the first number behind it that makes it different from all before.
  std::string unique(const std::string& wish);

 private:
  std::set<std::string> taken_;
};

}  // namespace pal::codegen
