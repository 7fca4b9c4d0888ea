// Changes of statements that make a finding go away, each tried before it is offered.
#pragma once

#include <string>
#include <vector>

#include "language_server/analysis.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/file_system.hpp"

namespace pal::language_server {

struct Repair {
  std::string title;  // "insert TXM( request force from LS1 ) before WTM( force from LS1 )"
  std::vector<Edit> edits;
};

/// For a finding of `analysis` at a statement of a module, without a fix of its own. With each repair the
/// finding is gone and no other has come; those that ask least of the text are first. The search takes about
/// `seconds` at most. `files`: those that `analysis` was made from.
std::vector<Repair> repairs(const FileSystem& files, const Analysis& analysis, const Diagnostic& finding,
                            double seconds);

}  // namespace pal::language_server
