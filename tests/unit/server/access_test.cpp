#include "server/access.hpp"

#include <sys/stat.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "server/announcement.hpp"

using namespace pal::server;

TEST_CASE("a token is the whole token") {
  const std::string token = make_token();
  CHECK(token.size() == 32);
  CHECK(token != make_token());
  CHECK(same_token(token, token));
  CHECK_FALSE(same_token("", token));
  CHECK_FALSE(same_token(token.substr(1), token));
  CHECK_FALSE(same_token(token + "0", token));
  CHECK_FALSE(same_token("", ""));  // no token opens nothing
}

TEST_CASE("only this machine's names and pages are accepted, unless others are named") {
  AccessRules rules;
  rules.port = 7400;
  CHECK(host_allowed("localhost:7400", rules));
  CHECK(host_allowed("LOCALHOST", rules));
  CHECK(host_allowed("[::1]:7400", rules));
  CHECK_FALSE(host_allowed("", rules));
  CHECK_FALSE(host_allowed("localhost:7401", rules));
  CHECK_FALSE(host_allowed("evil.example:7400", rules));
  CHECK_FALSE(host_allowed("127.0.0.1.evil.example", rules));
  CHECK(origin_allowed("", rules));
  CHECK(origin_allowed("http://127.0.0.1:7400", rules));
  CHECK_FALSE(origin_allowed("null", rules));
  CHECK_FALSE(origin_allowed("http://127.0.0.1:8000", rules));
  CHECK_FALSE(origin_allowed("https://evil.example", rules));
  rules.origins = {"http://127.0.0.1:8000"};
  rules.hosts.push_back("cell.example");
  CHECK(origin_allowed("http://127.0.0.1:8000", rules));
  CHECK(host_allowed("cell.example:7400", rules));
}

TEST_CASE("others cannot read the token's file, and a readable one is not trusted") {
  const std::string folder = std::filesystem::temp_directory_path() / ("pal-announcement-" + make_token());
  const std::string path = folder + "/workcell.json";
  announce(path, {"127.0.0.1", 7400, {"secret", "", ""}});
  struct stat found {};
  REQUIRE(::stat(path.c_str(), &found) == 0);
  CHECK((found.st_mode & 0777) == 0600);
  CHECK(read_announcement(path).tokens.programmer == "secret");
  CHECK(read_announcement(path).port == 7400);
  ::chmod(path.c_str(), 0644);
  CHECK_THROWS(read_announcement(path));
  ::chmod(path.c_str(), 0600);
  std::ofstream(path) << "[]";
  CHECK_THROWS(read_announcement(path));
  CHECK_THROWS(read_announcement(path + "x"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("each server of a machine has a place of its own, and the one that listens is found") {
  const std::string folder = std::filesystem::temp_directory_path() / ("pal-announcement-" + make_token());
  std::filesystem::create_directories(folder);
  const char* const before = std::getenv("XDG_RUNTIME_DIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("XDG_RUNTIME_DIR", folder.c_str(), 1);
  CHECK(default_announcement("touch", 7400) == folder + "/workcell-touch-7400.json");
  CHECK(default_announcement("touch", 7401) != default_announcement("touch", 7400));
  CHECK(default_announcement("../a b", 1) == folder + "/workcell-___a_b-1.json");
  CHECK(announced_servers().empty());
  boost::asio::io_context io;
  boost::asio::ip::tcp::acceptor listening(io, {boost::asio::ip::make_address("127.0.0.1"), 0});
  const std::uint16_t port = listening.local_endpoint().port();
  announce(default_announcement("touch", port), {"127.0.0.1", port, {"secret", "", ""}});
  announce(default_announcement("parts", 1), {"127.0.0.1", 1, {"secret", "", ""}});  // it was killed
  CHECK(announced_servers() == std::vector{default_announcement("touch", port)});
  listening.close();
  CHECK(announced_servers().empty());
  if (before != nullptr) {
    ::setenv("XDG_RUNTIME_DIR", kept.c_str(), 1);
  } else {
    ::unsetenv("XDG_RUNTIME_DIR");
  }
  std::filesystem::remove_all(folder);
}
