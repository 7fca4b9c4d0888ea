#include "study/proof_store.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "study/proof_key.hpp"

using namespace pal::study;
namespace fs = std::filesystem;

namespace {

/// An empty folder that goes with the test.
struct Folder {
  std::string path = (fs::temp_directory_path() / ("pal-proofs-" + std::to_string(::getpid()))).string();
  Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path); }
};

KeptProof sample() {
  pal::analyzer::Verdict verdict;
  verdict.requirement = "soon";
  verdict.measure = pal::analyzer::Requirement::Measure::response;
  verdict.state = pal::analyzer::VerdictState::holds;
  verdict.method = pal::analyzer::Method::compositional;
  verdict.limit = pal::Duration(9);
  verdict.at_least = true;
  verdict.bound = pal::Duration(7);
  verdict.exact = true;
  verdict.attained_load = pal::Duration(-3);
  verdict.witness.emplace();
  verdict.witness->measured.value = 7;
  verdict.gave_up = true;
  verdict.taken_as_lost = {{pal::analyzer::DeviceId(2), 1, 5}};
  verdict.addends = {{4, "SM1", "a \"tab\"\t", "s.pal", 3, {{1, "", "inside", "", 0, {}}}}};
  return {"", {verdict, {}}, "texts"};
}

std::string only_file(const std::string& folder) {
  std::string found;
  for (const auto& each : fs::recursive_directory_iterator(folder))
    if (each.is_regular_file()) found = each.path().string();
  return found;
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

TEST_CASE("a proof comes back as it was kept") {
  const Folder folder;
  ProofStore store(folder.path);
  const std::string key = sha256("a");
  CHECK_FALSE(store.find(key));
  CHECK_FALSE(store.has(key));
  REQUIRE_FALSE(store.keep(key, sample()));
  CHECK(store.has(key));
  const auto kept = store.find(key);
  REQUIRE(kept);
  CHECK(file_text(*kept, key) == file_text(sample(), key));
  REQUIRE(kept->verdicts.size() == 2);
  const pal::analyzer::Verdict& verdict = kept->verdicts[0];
  CHECK(verdict.bound == pal::Duration(7));
  CHECK(verdict.at_least);
  CHECK(verdict.attained_load == pal::Duration(-3));
  CHECK(pal::analyzer::attained(verdict) == pal::Duration(7));
  CHECK(verdict.taken_as_lost[0].in == 5);
  REQUIRE(verdict.addends.size() == 1);
  CHECK(verdict.addends[0].what == "a \"tab\"\t");
  CHECK(verdict.addends[0].inside[0].what == "inside");
  CHECK_FALSE(kept->verdicts[1].bound);
  CHECK_FALSE(kept->verdicts[1].witness);
  REQUIRE_FALSE(store.keep(sha256("b"), {"PAL0708: the period", {}, {}}));
  CHECK(store.find(sha256("b"))->refused == "PAL0708: the period");
}

TEST_CASE("a kept proof that was cut off, changed or renamed is not believed") {
  const Folder folder;
  ProofStore store(folder.path);
  const std::string key = sha256("a");
  REQUIRE_FALSE(store.keep(key, sample()));
  const std::string path = only_file(folder.path);
  const std::string whole = read(path);
  std::size_t believed = 0;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(path, whole.substr(0, length));
    believed += store.find(key) ? 1U : 0U;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    write(path, changed);
    believed += store.find(key) ? 1U : 0U;
  }
  CHECK(believed == 0);
  CHECK(store.damaged() == 2 * whole.size());
  write(path, whole);
  CHECK(store.find(key));
  const std::string other = sha256("b");
  REQUIRE_FALSE(store.keep(other, sample()));
  write(folder.path + "/" + other.substr(0, 2) + "/" + other.substr(2) + ".proof", whole);
  CHECK_FALSE(store.find(other));
  // It is made again, and whole again.
  REQUIRE_FALSE(store.keep(other, sample()));
  CHECK(store.find(other));
}

TEST_CASE("a folder that grows too large loses the proofs that were not used for longest") {
  const Folder folder;
  ProofStore store(folder.path);
  const auto now = fs::file_time_type::clock::now();
  for (int i = 0; i < 6; ++i) {
    const std::string key = sha256(std::to_string(i));
    REQUIRE_FALSE(store.keep(key, sample()));
    fs::last_write_time(folder.path + "/" + key.substr(0, 2) + "/" + key.substr(2) + ".proof",
                        now - std::chrono::hours(10 - i));
  }
  REQUIRE(store.find(sha256("0")));  // the oldest, and used now
  constexpr std::uint64_t block = 4096;
  CHECK(store.trim(6 * block) == 0);
  CHECK(store.trim(3 * block) == 3);
  CHECK(store.has(sha256("0")));
  for (const char* gone : {"1", "2", "3"}) CHECK_FALSE(store.has(sha256(gone)));
  for (const char* stays : {"4", "5"}) CHECK(store.has(sha256(stays)));
}

TEST_CASE("what a killed process left half written goes after an hour, and not before") {
  const Folder folder;
  const ProofStore store(folder.path);
  fs::create_directories(folder.path + "/aa");
  for (const char* name : {"/aa/old.half", "/aa/new.half"}) write(folder.path + name, "x");
  fs::last_write_time(folder.path + "/aa/old.half", fs::file_time_type::clock::now() - std::chrono::hours(2));
  store.trim(usual_store_size);
  CHECK_FALSE(fs::exists(folder.path + "/aa/old.half"));
  CHECK(fs::exists(folder.path + "/aa/new.half"));
}

TEST_CASE("processes that keep, find and trim at the same time see whole proofs or none") {
  const Folder folder;
  constexpr int processes = 4, turns = 300;
  for (int p = 0; p < processes; ++p) {
    if (::fork() != 0) continue;
    ProofStore store(folder.path);
    bool good = true;
    for (int i = 0; i < turns; ++i) {
      const std::string key = sha256(std::to_string(i % 7));
      good = good && !store.keep(key, sample());
      const auto kept = store.find(key);
      good = good && (!kept || file_text(*kept, key) == file_text(sample(), key));
      if (p == 0 && i % 50 == 0) store.trim(8192);
    }
    ::_exit(good && store.damaged() == 0 ? 0 : 1);
  }
  for (int p = 0; p < processes; ++p) {
    int status = 0;
    ::wait(&status);
    CHECK(status == 0);
  }
}

TEST_CASE("a folder that cannot be written says so") {
  const Folder folder;
  write(folder.path, "a file stands in its place");
  const auto trouble = ProofStore(folder.path).keep(sha256("a"), sample());
  REQUIRE(trouble);
  CHECK(trouble->starts_with("cannot write '" + folder.path));
}
