#include "server/announcement.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace pal::server {
namespace {

[[noreturn]] void fail_at(const std::string& path, const std::string& why) {
  throw std::runtime_error(path + ": " + why);
}

std::string last_error() {
  return std::generic_category().message(errno);
}

/// The files of a folder that another user owns could be exchanged.
void make_folder(const std::string& folder) {
  if (folder.empty()) return;
  if (::mkdir(folder.c_str(), 0700) == 0) return;
  struct stat found {};
  if (errno != EEXIST || ::lstat(folder.c_str(), &found) != 0) fail_at(folder, last_error());
  const bool shared = (found.st_mode & (S_IWGRP | S_IWOTH)) != 0 && (found.st_mode & S_ISVTX) == 0;
  if (!S_ISDIR(found.st_mode) || (found.st_uid != ::geteuid() && found.st_uid != 0) || shared)
    fail_at(folder, "others can change what is in this folder");
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

namespace {

/// Whether a server listens where the file says. One that was killed has left its file and does not.
bool still_listens(const Announcement& announced) {
  boost::asio::io_context io;
  boost::system::error_code problem;
  const auto address = boost::asio::ip::make_address(
      announced.address == "localhost" ? "127.0.0.1" : announced.address, problem);
  if (problem) return false;
  boost::beast::tcp_stream stream(io);
  bool connected = false;
  stream.expires_after(std::chrono::seconds(1));
  stream.async_connect({address, announced.port},
                       [&connected](const boost::system::error_code& failed) { connected = !failed; });
  io.run();
  return connected;
}

constexpr std::string_view announcement_begin = "workcell-", announcement_end = ".json";

std::string usual_folder() {
  if (const char* folder = std::getenv("XDG_RUNTIME_DIR"); folder != nullptr && *folder != '\0')
    return folder;
  return fmt::format("/tmp/workcell-{}", ::geteuid());
}

std::optional<Announcement> announced_at(const std::string& path) {
  try {
    return read_announcement(path);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

}  // namespace

std::string default_announcement(const std::string& cell, std::uint16_t port) {
  std::string name = cell;
  for (char& each : name)
    if (std::isalnum(static_cast<unsigned char>(each)) == 0 && each != '-') each = '_';
  return fmt::format("{}/{}{}-{}{}", usual_folder(), announcement_begin, name, port, announcement_end);
}

std::vector<std::string> announced_servers() {
  std::vector<std::string> result;
  std::error_code problem;
  for (std::filesystem::directory_iterator each(usual_folder(), problem), end; !problem && each != end;
       each.increment(problem)) {
    const std::string name = each->path().filename().string();
    if (!name.starts_with(announcement_begin) || !name.ends_with(announcement_end)) continue;
    const auto announced = announced_at(each->path().string());
    if (announced && still_listens(*announced)) result.push_back(each->path().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

void withdraw(const std::string& path, const Announcement& announcement) {
  const auto there = announced_at(path);
  if (there && there->tokens.programmer == announcement.tokens.programmer) ::unlink(path.c_str());
}

void announce(const std::string& path, const Announcement& announcement) {
  const auto there = announced_at(path);
  // Our own port is open already, so a file that names it is of a server that is gone.
  if (there && there->port != announcement.port && still_listens(*there))
    fail_at(path, fmt::format("another server is announced here, and listens at {}:{}; end it first",
                              there->address, there->port));
  make_folder(std::filesystem::path(path).parent_path().string());
  const std::string fresh = fmt::format("{}.{}", path, ::getpid());
  const Descriptor file(::open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (file.number() < 0) fail_at(fresh, last_error());
  const nlohmann::ordered_json json{{"workcell-server", 1},
                                    {"address", announcement.address},
                                    {"port", announcement.port},
                                    {"token", announcement.tokens.programmer},
                                    {"tokens",
                                     {{"programmer", announcement.tokens.programmer},
                                      {"operator", announcement.tokens.operating},
                                      {"viewer", announcement.tokens.viewer}}}};
  const std::string text = json.dump() + "\n";
  if (::write(file.number(), text.data(), text.size()) != static_cast<ssize_t>(text.size()) ||
      ::rename(fresh.c_str(), path.c_str()) != 0) {
    const std::string why = last_error();
    ::unlink(fresh.c_str());
    fail_at(path, why);
  }
}

Announcement read_announcement(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) fail_at(path, last_error());
  struct stat found {};
  if (::fstat(file.number(), &found) != 0) fail_at(path, last_error());
  if (!S_ISREG(found.st_mode) || (found.st_uid != ::geteuid() && found.st_uid != 0) ||
      (found.st_mode & 077) != 0)
    fail_at(path, "others can read or own this file; chmod 600 it, or start the server again");
  std::array<char, 4096> text{};
  const ssize_t size = ::read(file.number(), text.data(), text.size());
  if (size < 0) fail_at(path, last_error());
  const auto json = nlohmann::json::parse(text.begin(), text.begin() + size, nullptr, false);
  if (!json.is_object() || json.value("workcell-server", 0) != 1) fail_at(path, "this announces no server");
  try {
    const auto tokens = json.value("tokens", nlohmann::json::object());
    return {json.at("address"),
            json.at("port"),
            {json.at("token"), tokens.value("operator", ""), tokens.value("viewer", "")}};
  } catch (const nlohmann::json::exception&) {
    fail_at(path, "this announces no server");
  }
}

}  // namespace pal::server
