#include "server/disk_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>

namespace pal::server {

void refuse(Refusal::Why why, std::string message, std::string hint) {
  throw StoreProblem{Refusal{why, std::move(message), std::move(hint)}};
}

void fail_on_disk(const std::string& path) {
  refuse(Refusal::Why::failed, fmt::format("{}: {}", path, std::generic_category().message(errno)),
         "look at the disk of the cell's computer");
}

DiskFile::DiskFile(const std::string& path, int flags)
    : number_(::open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, 0600)) {
  if (number_ < 0) fail_on_disk(path);
}

DiskFile::~DiskFile() {
  ::close(number_);
}

void DiskFile::write(const std::string& path, const std::string& text) const {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(number_, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail_on_disk(path);
    done += static_cast<std::size_t>(count);
  }
}

void DiskFile::sync(const std::string& path) const {
  if (::fsync(number_) != 0) fail_on_disk(path);
}

std::string DiskFile::read(const std::string& path, std::size_t most) const {
  std::string text;
  std::string piece(65536, '\0');
  for (;;) {
    const ssize_t count = ::read(number_, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_on_disk(path);
    if (count == 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
    if (text.size() > most) refuse(Refusal::Why::failed, path + ": it is too large");
  }
}

void sync_folder(const std::string& folder) {
  DiskFile(folder, O_RDONLY | O_DIRECTORY).sync(folder);
}

std::string write_aside(const std::string& folder, const std::string& text) {
  static std::atomic<unsigned> count = 0;
  const std::string path = fmt::format("{}/.new-{}-{}", folder, ::getpid(), ++count);
  ::unlink(path.c_str());
  const DiskFile file(path, O_WRONLY | O_CREAT | O_EXCL);
  file.write(path, text);
  file.sync(path);
  return path;
}

void replace_file(const std::string& folder, const std::string& name, const std::string& text) {
  const std::string fresh = write_aside(folder, text), path = folder + "/" + name;
  if (std::rename(fresh.c_str(), path.c_str()) != 0) fail_on_disk(path);
  sync_folder(folder);
}

}  // namespace pal::server
