// The folder in which proofs are kept, a file each, under the hash of what they depend on. Several processes
// and machines may use one at the same time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "study/kept_proof.hpp"

namespace pal::study {

/// The usual size of a folder: some 500,000 proofs.
constexpr std::uint64_t usual_store_size = std::uint64_t{1} << 30;

class ProofStore {
 public:
  explicit ProofStore(std::string folder) : folder_(std::move(folder)) {}

  const std::string& folder() const { return folder_; }

  /// A file that is not as it was written counts as none, and is counted. A proof that is found becomes one
  /// of the youngest, to the minute.
  std::optional<KeptProof> find(const std::string& key);

  /// Whether there is a file; nothing is read.
  bool has(const std::string& key) const;

  /// Written whole or not at all. What went wrong, or nothing.
  std::optional<std::string> keep(const std::string& key, const KeptProof& proof) const;

  /// Files that find() did not believe.
  std::size_t damaged() const { return damaged_; }

  /// Removes the oldest until the folder has at most `bytes` (counted in blocks of the disk). Returns how
  /// many. Also removes what a process that was killed left half written more than an hour ago.
  std::size_t trim(std::uint64_t bytes) const;

 private:
  std::string path_of(const std::string& key) const;

  std::string folder_;
  std::size_t damaged_ = 0;
};

}  // namespace pal::study
