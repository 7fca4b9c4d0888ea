// Operations of a request completed from the store.
#pragma once

#include <optional>
#include <string>

#include "pal/support/file_system.hpp"
#include "server/json_requests.hpp"
#include "server/session.hpp"
#include "server/store.hpp"

namespace pal::server {

/// The files of a request; those that were not sent are taken from the store: "pick.op.json" is the newest
/// version of `pick`. What was taken is in the files afterwards.
class RequestFiles final : public FileSystem {
 public:
  /// Both outlive it; the store may be null.
  RequestFiles(std::map<std::string, std::string>& files, const Store* store)
      : files_(files), store_(store) {}
  std::variant<std::string, FileError> read(const std::string& path, std::size_t most) const override;

 private:
  std::map<std::string, std::string>& files_;
  const Store* store_;
};

/// The store; throws Problem if this server has none.
Store& store_of(SessionContext& context);
/// Calls it, with the store's problems as the protocol's.
template <class Use>
auto with_store(Use use) {
  try {
    return use();
  } catch (const StoreProblem& problem) {
    throw problem_of(problem.refusal);
  }
}

/// Throws Problem.
LoadOperation load_stored(SessionContext& context, const std::string& name,
                          std::optional<std::uint64_t> version);
/// Adds the files that the operation needs and that were not sent.
void add_stored_files(SessionContext& context, LoadOperation& command);

}  // namespace pal::server
