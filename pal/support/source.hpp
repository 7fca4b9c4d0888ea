// Source texts by number, and places in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pal/support/id.hpp"

namespace pal {

using FileId = Id<struct FileTag>;

/// Bytes [begin, end) of one source text. An invalid file means: no place in any text.
struct SourceSpan {
  FileId file{};
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  bool valid() const { return file.valid(); }
  friend bool operator==(const SourceSpan&, const SourceSpan&) = default;
};

/// Line and column, both from 1; the column counts Unicode code points, a tab as one.
struct LineColumn {
  int line = 0;
  int column = 0;
};

/// Owns the texts that were read; hands out places. Files are added by those that may read them (the
/// driver, a test): the library itself opens nothing.
class SourceManager {
 public:
  /// Takes a text under the name that messages show. The id stays valid for the manager's life.
  FileId add(std::string name, std::string text);

  /// The file that was added under this name, if any.
  std::optional<FileId> find(std::string_view name) const;

  /// How many texts there are; their ids are 0 … size() - 1, in the order in which they were added.
  std::size_t size() const { return files_.size(); }

  const std::string& name(FileId file) const;
  std::string_view text(FileId file) const;
  std::string_view text(SourceSpan span) const;

  /// Where byte `offset` of `file` stands. Offsets past the end give the end.
  LineColumn line_column(FileId file, std::uint32_t offset) const;

  /// Line `line` (from 1) without its line break; empty if there is none.
  std::string_view line_text(FileId file, int line) const;

 private:
  struct File {
    std::string name;
    std::string text;
    std::vector<std::uint32_t> line_starts;
  };
  std::vector<File> files_;
};

}  // namespace pal
