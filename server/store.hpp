// Operations on the cell's disk, with all their versions. Each version is a file that is written once, so a
// crash at any instant leaves what was answered, whole.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/disk_file.hpp"
#include "server/event.hpp"

namespace pal::server {

struct StoredEntry {
  std::string name;
  std::uint64_t version = 0;  // the newest, from 1
  std::string operation;      // the name in the text
  WallTime saved{};
  std::string by, note;
  std::size_t size = 0;  // bytes
};
struct StoredText {
  StoredEntry entry;  // of the version that was read
  std::uint64_t newest = 0;
  std::string text;
};

/// FOLDER/NAME/000001.op.json, …, each with its 000001.json: who saved it, when, and why. Functions throw
/// StoreProblem. Reading may go on in several threads while one writes.
class Store {
 public:
  static constexpr std::size_t largest_text = std::size_t{1} << 20;
  static constexpr std::size_t most_names = 10'000;
  static constexpr std::uint64_t most_versions = 1'000;  // of a name; older ones are removed

  /// Makes the folder if it is not there. Throws std::runtime_error.
  explicit Store(std::string folder);

  std::vector<StoredEntry> list() const;
  /// The newest version, or this one.
  StoredText read(const std::string& name, std::optional<std::uint64_t> version = std::nullopt) const;
  /// On the disk when it returns. `based_on`: the version that was changed; 0: the name must be new.
  StoredEntry save(const std::string& name, const std::string& text, std::uint64_t based_on,
                   const std::string& by, const std::string& note);
  /// With all versions.
  StoredEntry rename(const std::string& name, const std::string& to, std::uint64_t based_on);
  /// Into FOLDER/.deleted, from where a person may take it back.
  void remove(const std::string& name, std::uint64_t based_on);
  /// The newest first.
  std::vector<StoredEntry> versions(const std::string& name) const;

 private:
  std::string folder_of(const std::string& name) const;
  std::vector<std::uint64_t> numbers(const std::string& name) const;
  std::uint64_t newest_of(const std::string& name) const;
  StoredEntry entry(const std::string& name, std::uint64_t version) const;

  std::string folder_;
};

}  // namespace pal::server
