// Whether what a client wants to run may run in this cell.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>

#include "operations/check.hpp"
#include "operations/json_value.hpp"
#include "pal/support/file_system.hpp"
#include "server/command.hpp"

namespace pal::server {

/// The texts that a client sent; the server reads no file that it names.
class SentFiles final : public FileSystem {
 public:
  explicit SentFiles(const std::map<std::string, std::string>& files) : files_(files) {}
  std::variant<std::string, FileError> read(const std::string& path, std::size_t most) const override;

 private:
  const std::map<std::string, std::string>& files_;
};

/// The first mistake in a skill and its parameters, with a way out; nothing, if it may run.
std::optional<Refusal> mistake_in(const RunSkill& command, const operations::Cell& cell);

/// The operation that the command's files hold, or the first mistake in them, with its place and a way out.
/// `stop` ends the check.
std::variant<operations::Program, Refusal> program_of(const LoadOperation& command,
                                                      const operations::Cell& cell,
                                                      const operations::Stop& stop);

/// Looks up fields in texts of operations, each of which is read once.
class FieldFinder {
 public:
  explicit FieldFinder(const SourceManager& sources) : sources_(sources) {}
  /// The field in which the place lies, of an icon or of the operation: "parameters/force", "ways/0/to".
  /// Empty: in none.
  std::string at(SourceSpan where);

 private:
  const SourceManager& sources_;
  std::map<FileId, std::optional<operations::JsonValue>> texts_;
};

}  // namespace pal::server
