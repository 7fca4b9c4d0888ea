// Operations on the disk: versions, names, and a writer that is killed.
#include "server/store.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>

#include "server/access.hpp"

using namespace pal::server;

namespace {

struct StoreFolder {
  std::string path = std::filesystem::temp_directory_path() / ("pal-store-" + make_token());
  ~StoreFolder() { std::filesystem::remove_all(path); }
};

std::string operation(const std::string& name, std::size_t length = 0) {
  return R"({"operation-format": 1, "name": ")" + name + R"(", "description": ")" + std::string(length, 'x') +
         R"(", "icons": [{"id": "s", "kind": "start", "next": "e"}, {"id": "e", "kind": "exit"}]})";
}

template <class Use>
Refusal::Why why(const Use& use) {
  try {
    use();
  } catch (const StoreProblem& problem) {
    return problem.refusal.why;
  }
  FAIL("it was not refused");
  return {};
}

}  // namespace

TEST_CASE("an operation is saved by versions, and never over a newer one") {
  const StoreFolder folder;
  Store store(folder.path);
  CHECK(store.list().empty());
  CHECK(store.save("pick", operation("a"), 0, "ann", "first").version == 1);
  CHECK(store.save("pick", operation("b"), 1, "bob", "").version == 2);
  CHECK(why([&] { store.save("pick", operation("c"), 1, "ann", ""); }) == Refusal::Why::newer);
  CHECK(why([&] { store.save("pick", operation("c"), 0, "ann", ""); }) == Refusal::Why::exists);
  CHECK(why([&] { store.save("place", operation("c"), 1, "ann", ""); }) == Refusal::Why::absent);
  CHECK(why([&] { store.save("place", "{", 0, "ann", ""); }) == Refusal::Why::wrong);
  CHECK(store.read("pick").text == operation("b"));
  CHECK(store.read("pick", 1).text == operation("a"));
  CHECK(why([&] { store.read("pick", 3); }) == Refusal::Why::absent);
  const auto versions = store.versions("pick");
  REQUIRE(versions.size() == 2);
  CHECK(versions[0].by == "bob");
  CHECK(versions[1].note == "first");
  // Another server finds the same.
  CHECK(Store(folder.path).list().front().operation == "b");
  CHECK(store.rename("pick", "take", 2).name == "take");
  CHECK(why([&] { store.read("pick"); }) == Refusal::Why::absent);
  CHECK(store.versions("take").size() == 2);
  CHECK(why([&] { store.remove("take", 1); }) == Refusal::Why::newer);
  store.remove("take", 2);
  CHECK(store.list().empty());
}

TEST_CASE("no name leaves the folder") {
  const StoreFolder folder;
  Store store(folder.path);
  for (const char* name : {"", ".", "..", "../out", "a/b", "/etc/passwd", ".hidden", "a\\b", "a\nb",
                           "a\x1b[2J", "\xff", "x.op.json", " a", "a "}) {
    CAPTURE(name);
    CHECK(why([&] { store.save(name, operation("a"), 0, "", ""); }) == Refusal::Why::wrong);
    CHECK(why([&] { store.read(name); }) == Refusal::Why::wrong);
  }
  CHECK(why([&] { store.save(std::string(101, 'a'), operation("a"), 0, "", ""); }) == Refusal::Why::wrong);
  store.save("wäscht die Hände", operation("a"), 0, "", "");
  CHECK(store.list().front().name == "wäscht die Hände");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 2);  // and .deleted
}

namespace {

void kill_writers(int times) {
  const StoreFolder folder;
  std::mt19937 random(42);
  std::uint64_t answered = 0, before = 0;
  for (int i = 0; i < times; ++i) {
    int pipe[2];
    REQUIRE(::pipe(pipe) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
      Store store(folder.path);
      for (;;) {
        const auto there = store.list();
        const std::uint64_t version = there.empty() ? 0 : there.front().version;
        const std::string name = std::to_string(version + 1);
        store.save("o", operation(name, 20'000), version, "child", "");
        const std::uint64_t done = version + 1;
        if (::write(pipe[1], &done, sizeof done) != sizeof done) ::_exit(1);
      }
    }
    ::close(pipe[1]);
    std::uint64_t said = 0;
    // On a busy machine some must be let come so far.
    if (i % 5 == 0 && ::read(pipe[0], &said, sizeof said) == sizeof said) answered = said;
    ::usleep(std::uniform_int_distribution<useconds_t>(0, 15'000)(random));
    ::kill(child, SIGKILL);
    while (::read(pipe[0], &said, sizeof said) == sizeof said) answered = said;
    ::close(pipe[0]);
    ::waitpid(child, nullptr, 0);
    const auto all = Store(folder.path).list();
    if (all.empty() && answered == 0) continue;
    // What an earlier writer saved without an answer stays.
    answered = std::max(answered, before);
    const Store store(folder.path);
    const StoredText last = store.read("o");
    // A save that was not answered may be there, too.
    REQUIRE((last.newest == answered || last.newest == answered + 1));
    before = last.newest;
    for (const std::uint64_t version : {std::max<std::uint64_t>(answered, 1), last.newest})
      REQUIRE(store.read("o", version).text == operation(std::to_string(version), 20'000));
  }
  CHECK(answered > 0);
}

}  // namespace

TEST_CASE("when the writer is killed, the last answered save is there, whole") {
  kill_writers(50);
}

// The target store_kills runs it.
TEST_CASE("… a thousand times", "[.kills]") {
  kill_writers(1000);
}
