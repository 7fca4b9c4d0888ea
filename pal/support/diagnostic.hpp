// Findings about a specification: collected by the stages, rendered by the driver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "pal/support/source.hpp"

namespace pal {

/// The rows of the table in diagnostic_code.hpp. Include that to report findings or to distinguish codes;
/// code that only carries findings need not.
enum class Code : std::uint16_t;

/// The rows of findings and of their notes in finding.hpp, and what reports them. Include that to report
/// findings.
enum class Finding : std::uint16_t;
enum class Remark : std::uint16_t;
template <class Row, std::size_t count>
struct RowWith;
template <std::size_t count>
using FindingWith = RowWith<Finding, count>;
template <std::size_t count>
using RemarkWith = RowWith<Remark, count>;
struct PartialDiagnostic;

enum class Severity { note, warning, error };

/// A second place that helps to understand the first. Its text is a row of the table of notes.
struct Note {
  template <class... Arguments>
  Note(SourceSpan at, std::type_identity_t<RemarkWith<sizeof...(Arguments)>> remark,
       const Arguments&... arguments);

  SourceSpan where;
  std::string text;
};

/// A piece of text, perhaps empty, and the text that should replace it.
struct Edit {
  SourceSpan where;
  std::string text;
};

/// One finding. `message` is lower case without a full stop, and says what is wrong at `where`, the narrowest
/// place possible. `hint` says what to do; following it makes the finding go away. If a program can follow
/// it, `fix` has the edits, all of which must be made; else it is empty. Message and hint are made of the row
/// of `finding` and of its `arguments`.
struct Diagnostic {
  Code code;
  Severity severity;
  SourceSpan where;
  std::string message;
  std::vector<Note> notes;
  std::string hint;
  std::vector<Edit> fix;
  std::string requirement = {};  // the name of the one it is about; empty: none
  Finding finding = {};
  std::vector<std::string> arguments = {};

  /// Adds a second place. There is an argument for each placeholder of the row.
  template <class... Arguments>
  Diagnostic& note(SourceSpan at, std::type_identity_t<RemarkWith<sizeof...(Arguments)>> remark,
                   const Arguments&... arguments);
  /// Is told in this way from now on.
  Diagnostic& say(const PartialDiagnostic& what);
  /// Asks for the similar name `near`, if there is one, in place of the hint. `quote` stands around it.
  Diagnostic& suggest(const std::optional<std::string>& near, const char* quote = "'");
};

/// Numbers of findings.
struct FindingCounts {
  std::size_t errors = 0;
  std::size_t warnings = 0;

  std::size_t sum() const { return errors + warnings; }
  std::size_t& of(Severity severity) { return severity == Severity::error ? errors : warnings; }
};

/// Collects the findings of the stages. Stages go on after an error as far as they can.
class Diagnostics {
 public:
  /// How many findings of each severity are kept. Others are only counted, so that no input can fill the
  /// memory.
  static constexpr std::size_t most_kept = 10'000;

  /// Reports with the severity that the table gives the finding's code. There is an argument, a text or a
  /// whole number, for each placeholder of its row, in the order in which they first stand in text and hint.
  template <class... Arguments>
  Diagnostic& report(std::type_identity_t<FindingWith<sizeof...(Arguments)>> finding, SourceSpan where,
                     const Arguments&... arguments);
  Diagnostic& report(const PartialDiagnostic& what, SourceSpan where);

  /// Reports what was found elsewhere.
  Diagnostic& report(const Diagnostic& found);

  /// Later findings that begin in `place` are consequences of a reported one, and are dropped.
  void distrust(SourceSpan place) { distrusted_.push_back(place); }

  std::size_t errors() const { return errors_; }
  bool has_errors() const { return errors_ != 0; }

  /// What was kept, in the order reported.
  const std::vector<Diagnostic>& all() const { return all_; }

  /// How many findings were counted and not kept.
  const FindingCounts& not_kept() const { return not_kept_; }

  /// In the order a reader wants: by file, then place, then code; repeats of one finding once.
  std::vector<Diagnostic> sorted() const;

 private:
  Diagnostic& keep(Diagnostic found);

  std::vector<Diagnostic> all_;
  std::vector<SourceSpan> distrusted_;
  std::vector<Diagnostic> dropped_;  // the last one dropped, which its finder may still be writing to
  std::size_t errors_ = 0;
  FindingCounts kept_;
  FindingCounts not_kept_;
};

}  // namespace pal
