// Witnesses as a file: what `pal check --witness` writes and `pal replay` reads (docs/reference/witness.md).
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "pal/trace/trace.hpp"

namespace pal::analyzer::run_checker {

/// One event of the analysis's script: which timer fires when, and how each open choice of the skill is made.
struct Firing {
  std::int64_t at = 0;
  std::string timer;  // thread, message or device; empty: the start
  std::vector<std::uint8_t> choices;
};

/// Where a thread runs, if not where the environment says.
struct FiledPlacement {
  std::string thread;
  int processor = 0;  // index
  int priority = 0;
};

/// A run, and what it shows of a requirement.
struct FiledWitness {
  std::string skill;
  std::string environment;
  std::string identity;                   // of the skill and the environment that it is a run of
  std::vector<FiledPlacement> placement;  // all threads; empty: as the environment says
  std::string requirement;
  std::string measure;  // "age", "response", …
  bool failed = false;  // shows an event without a response, and no value
  bool grows = false;   // the value has grown so far when the run ends, and is not measured yet
  std::int64_t value = 0;
  std::int64_t born = 0;
  std::int64_t at = 0;
  std::vector<Firing> script;
  trace::Trace run;
};

/// The witness as it stands in the file.
std::string filed_text(const FiledWitness& witness);

/// {"witnesses": [...]} of what filed_text gave.
std::string file_of(const std::vector<std::string>& texts);

/// {"witnesses": [...]}; the same witnesses give the same bytes.
void write_witnesses(const std::vector<FiledWitness>& witnesses, std::ostream& out);

/// Throws std::runtime_error that says what is wrong.
std::vector<FiledWitness> read_witnesses(std::istream& in);

/// Sixteen hexadecimal digits that change with `text` (FNV-1a).
std::string identity(const std::string& text);

}  // namespace pal::analyzer::run_checker
