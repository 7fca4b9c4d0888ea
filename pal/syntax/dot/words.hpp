// Values of the attributes of a PAN: names, messages, numbers, guards, headings of activities.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/dot/graph.hpp"
#include "pal/syntax/statement.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// Ends the reading of something that was reported. Never leaves pal/syntax.
struct Reported {};

/// The parts of "a;b", each at the place of the whole.
std::vector<DotValue> dot_parts(const DotValue& value);

/// Reads values. A value of the wrong form is reported (PAL0115); then it throws Reported.
class DotWords {
 public:
  explicit DotWords(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  Name name(const DotValue& from);
  /// A name that may stand alone as a statement.
  Name activity_name(const DotValue& from);
  /// "force", or "request force".
  MessageName message(const DotValue& from);
  PartyName party(const DotValue& from);
  bool truth(const DotValue& from);
  /// A whole number from 0 to `most`.
  std::int64_t number(const DotValue& from, std::int64_t most);
  /// A condition as PAL writes it.
  Guard guard(const DotValue& from);
  /// "think READS force WRITES motion": as the heading of a module has it, without the word ACTIVITY.
  ActivityHeading activity(const DotValue& from);
  pan::ModuleKind module_kind(const DotValue& from);
  /// Texts of a template: "a force; of the tool" stands there as "a force%3B of the tool".
  std::vector<std::string> texts(const DotValue& from);
  /// Names of a template's slot, or NONE.
  NameSlot slot(const DotValue& from);

 private:
  [[noreturn]] void fail(const DotValue& at, const PartialDiagnostic& what);

  Diagnostics& diagnostics_;
};

}  // namespace pal::syntax
