// The files of the editor's folders: texts that are open and not saved stand in place of those on the disk.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "language_server/text.hpp"
#include "pal/check/project.hpp"
#include "pal/support/file_system.hpp"

namespace pal::language_server {

/// A text that is open in the editor.
struct Document {
  std::string uri;  // as the client writes it
  std::int64_t version = 0;
  std::shared_ptr<const Text> text;
};

/// For one thread.
class Workspace : public FileSystem {
 public:
  /// `disk` must outlive this.
  explicit Workspace(const FileSystem& disk) : disk_(disk) {}

  void set_folders(std::vector<std::string> folders);
  const std::vector<std::string>& folders() const { return folders_; }

  void open(const std::string& path, Document document);
  /// Contract: the document is open.
  void change(const std::string& path, std::int64_t version, std::shared_ptr<const Text> text);
  void close(const std::string& path);
  const Document* find(const std::string& path) const;
  const std::map<std::string, Document>& documents() const { return documents_; }
  /// The file may have changed on the disk, begun or ended.
  void reload(const std::string& path);

  /// Grows whenever something here changes.
  std::uint64_t revision() const { return revision_; }
  /// Differs if and only if the text of the file may differ.
  std::uint64_t revision(const std::string& path) const;

  /// Grows whenever a file comes or goes, or says something else in project().
  std::uint64_t structure() {
    project();
    return structure_;
  }

  /// All PAL files of the folders, those that are open, and what they use; in the order of their paths.
  const std::vector<check::ProjectFile>& project();
  /// The folder that holds `path`, or else its own.
  std::string top(const std::string& path) const;

  /// The text of a file, open or not; nullptr if it cannot be read.
  std::shared_ptr<const Text> text(const std::string& path) const;
  /// The URI of a file, spelled as the client spells it, if it is open.
  std::string uri(const std::string& path) const;

  std::variant<std::string, FileError> read(const std::string& path,
                                            std::size_t most = largest_file) const override;
  std::optional<std::vector<std::string>> list(const std::string& path,
                                               std::string_view ending) const override;
  std::string identity(const std::string& path) const override;

 private:
  void scan(const std::string& path);

  const FileSystem& disk_;
  std::vector<std::string> folders_;
  std::map<std::string, Document> documents_;
  std::map<std::string, std::uint64_t> revisions_;
  std::uint64_t revision_ = 0;
  mutable std::map<std::string, std::shared_ptr<const Text>> read_;  // from the disk
  std::map<std::string, check::ProjectFile> scanned_;
  bool listed_ = false;
  std::vector<check::ProjectFile> project_;
  std::uint64_t project_revision_ = 0;
  std::uint64_t structure_ = 0;
};

}  // namespace pal::language_server
