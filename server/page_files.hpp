// Files for a browser: those of a few folders, and nothing outside them.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pal::server {

/// The files below `folder` are at the addresses below `prefix`, which begins and ends with a slash.
struct PageFolder {
  std::string prefix, folder;
};

/// Fields of an HTTP request; empty: it has none.
struct PageRequest {
  std::string target, host, accept_encoding, if_none_match;
};
struct PageAnswer {
  unsigned status = 200;
  std::vector<std::pair<std::string, std::string>> fields;
  std::string body;
};

/// One thread only.
class PageFiles {
 public:
  explicit PageFiles(std::vector<PageFolder> folders);
  ~PageFiles();
  PageFiles(const PageFiles&) = delete;
  PageFiles& operator=(const PageFiles&) = delete;

  /// A file with a strict content security policy; 304 if the browser has it; 404 with words.
  PageAnswer answer(const PageRequest& request) const;

 private:
  struct File;
  const File* find(const std::string& path) const;

  std::vector<PageFolder> folders_;
  mutable std::map<std::string, std::unique_ptr<File>> files_;  // that were asked for, by path
};

}  // namespace pal::server
