// What is wrong with a specification: collected by the stages, rendered by the driver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pal/support/source.hpp"

namespace pal {

/// The rows of the table in diagnostic_code.hpp: who reports or tells codes apart includes that; who only
/// carries findings does not.
enum class Code : std::uint16_t;

enum class Severity { note, warning, error };

/// A second place that helps to understand the first.
struct Note {
  SourceSpan where;
  std::string text;
};

/// A piece of text, maybe of no length, and what is to stand there instead.
struct Edit {
  SourceSpan where;
  std::string text;
};

/// One finding. `message` is lower case without a full stop and says what is wrong at `where`, the narrowest
/// place there is; `hint` says what to do about it, and following it makes the finding go away. Where a
/// program can follow it, `fix` has the edits, all of them to be made; else it is empty.
struct Diagnostic {
  Code code;
  Severity severity;
  SourceSpan where;
  std::string message;
  std::vector<Note> notes;
  std::string hint;
  std::vector<Edit> fix;
};

/// Numbers of findings.
struct FindingCounts {
  std::size_t errors = 0;
  std::size_t warnings = 0;

  std::size_t sum() const { return errors + warnings; }
  std::size_t& of(Severity severity) { return severity == Severity::error ? errors : warnings; }
};

/// Where stages leave their findings. Stages go on after an error as far as they can.
class Diagnostics {
 public:
  /// Of each severity; what is beyond is counted only, so that no input can fill the memory with findings.
  static constexpr std::size_t most_kept = 10'000;

  /// Reports with the severity that the table gives the code.
  Diagnostic& report(Code code, SourceSpan where, std::string message, std::string hint = {});

  /// What is found from now on to begin in `place` only follows from what was reported there, and is dropped.
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
  std::vector<Diagnostic> all_;
  std::vector<SourceSpan> distrusted_;
  std::vector<Diagnostic> dropped_;  // the last one dropped, which its finder may still be writing to
  std::size_t errors_ = 0;
  FindingCounts kept_;
  FindingCounts not_kept_;
};

}  // namespace pal
