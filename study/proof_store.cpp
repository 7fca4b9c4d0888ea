#include "study/proof_store.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <vector>

namespace pal::study {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view proof_ending = ".proof";
constexpr std::string_view half_ending = ".half";
/// A file that was used since then is young enough, seconds.
constexpr std::time_t just_used = 60;

struct Closed {
  int descriptor;
  ~Closed() {
    if (descriptor >= 0) ::close(descriptor);
  }
};

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Less than `size` bytes if the file is shorter by now.
std::string read_all(int descriptor, std::size_t size) {
  std::string text(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = ::read(descriptor, text.data() + done, size - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  text.resize(done);
  return text;
}

/// Unlike any other of this machine and of others.
std::string half_name(const std::string& path) {
  static const std::string machine = [] {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return std::string(name.data());
  }();
  static unsigned count = 0;
  return path + "." + machine + "." + std::to_string(::getpid()) + "." + std::to_string(++count) +
         std::string(half_ending);
}

}  // namespace

std::string ProofStore::path_of(const std::string& key) const {
  return folder_ + "/" + key.substr(0, 2) + "/" + key.substr(2) + std::string(proof_ending);
}

bool ProofStore::has(const std::string& key) const {
  return ::access(path_of(key).c_str(), R_OK) == 0;
}

std::optional<KeptProof> ProofStore::find(const std::string& key) {
  const std::string path = path_of(key);
  const Closed file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.descriptor < 0) return std::nullopt;
  struct stat status {};
  if (::fstat(file.descriptor, &status) != 0) return std::nullopt;
  auto proof = kept_proof(read_all(file.descriptor, static_cast<std::size_t>(status.st_size)), key);
  if (!proof) {
    ++damaged_;
    return std::nullopt;
  }
  // Used now. A folder that may not be written keeps its order.
  if (std::time(nullptr) - status.st_mtim.tv_sec > just_used) ::futimens(file.descriptor, nullptr);
  return proof;
}

std::optional<std::string> ProofStore::keep(const std::string& key, const KeptProof& proof) const {
  const std::string path = path_of(key);
  std::error_code error;
  fs::create_directories(fs::path(path).parent_path(), error);
  if (error) return "cannot write '" + path + "': " + error.message();
  const std::string half = half_name(path);
  const auto failed = [&half, &path] {
    const std::string reason = std::strerror(errno);
    ::unlink(half.c_str());
    return "cannot write '" + path + "': " + reason;
  };
  {
    const Closed file{::open(half.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)};
    if (file.descriptor < 0 || !write_all(file.descriptor, file_text(proof, key))) return failed();
  }
  if (::rename(half.c_str(), path.c_str()) != 0) return failed();
  return std::nullopt;
}

std::size_t ProofStore::trim(std::uint64_t bytes) const {
  struct File {
    timespec used;
    std::uint64_t size;
    std::string path;
  };
  std::vector<File> files;
  std::uint64_t all = 0;
  std::error_code error;
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  constexpr std::time_t long_ago = 3600;
  for (fs::recursive_directory_iterator each(folder_, fs::directory_options::skip_permission_denied, error),
       end;
       !error && each != end; each.increment(error)) {
    const std::string path = each->path().string();
    const bool half = path.ends_with(half_ending);
    if (!half && !path.ends_with(proof_ending)) continue;
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
    if (half) {
      if (now - status.st_mtim.tv_sec > long_ago) ::unlink(path.c_str());
      continue;
    }
    constexpr std::uint64_t block = 512;  // stat(2)
    files.push_back({status.st_mtim, static_cast<std::uint64_t>(status.st_blocks) * block, path});
    all += files.back().size;
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) {
    return std::tie(a.used.tv_sec, a.used.tv_nsec, a.path) < std::tie(b.used.tv_sec, b.used.tv_nsec, b.path);
  });
  std::size_t removed = 0;
  for (const File& file : files) {
    if (all <= bytes) break;
    if (::unlink(file.path.c_str()) == 0) ++removed;
    all -= file.size;
  }
  return removed;
}

}  // namespace pal::study
