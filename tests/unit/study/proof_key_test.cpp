#include "study/proof_key.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "pal/check/check.hpp"
#include "pal/check/read_sources.hpp"
#include "tests/unit/whatif/two_chains.hpp"

using namespace pal::study;

namespace {

std::string key_of(const std::string& text, const KeyOptions& options = {"auto", 1000}) {
  pal::MemoryFileSystem files;
  files.add("s.pal", text);
  pal::SourceManager sources;
  pal::Diagnostics diagnostics;
  const auto specification =
      pal::check::check(pal::check::read_sources(files, sources, {"s.pal"}, diagnostics), diagnostics);
  REQUIRE_FALSE(diagnostics.has_errors());
  return proof_key(sha256(canonical_text(specification.skills.at(0))),
                   sha256(canonical_text(specification.environments.at(0))), options);
}

std::string with(std::string text, const std::string& old, const std::string& now) {
  const auto at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), now);
}

}  // namespace

TEST_CASE("SHA-256 is that of FIPS 180-4") {
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_CASE("the version of the engine is that of its build") {
  CHECK(engine_version().starts_with("pal "));
  CHECK(engine_version().size() >= std::string("pal 0.1.0 ").size() + 40);
}

TEST_CASE("a comment, blanks and moved lines leave the key of a proof as it is") {
  const std::string text = pal::test::two_chains("9 ms");
  const std::string key = key_of(text);
  CHECK(key_of("# a comment\n\n\n" + text) == key);
  CHECK(key_of(with(text, "    heavy\n", "       heavy   # long\n\n")) == key);
  CHECK(key_of(with(text, "TIME heavy OF LS1 : 5 ms", "TIME heavy OF LS1 : 5000 us")) == key);
}

TEST_CASE("whatever a proof depends on changes its key") {
  const std::string text = pal::test::two_chains("9 ms");
  std::set<std::string> keys{key_of(text)};
  const std::vector<std::string> changed{
      pal::test::two_chains("8 ms"),
      with(text, "TIME heavy OF LS1 : 5 ms", "TIME heavy OF LS1 : 5.000001 ms"),
      with(text, "TIME heavy OF LS1 : 5 ms", "TIME heavy OF LS1 : 4 TO 5 ms"),
      with(text, "EVENT tick EVERY 10 ms", "EVENT tick EVERY 10 ms JITTER 1 ns"),
      with(text, "EVENT tick EVERY 10 ms", "EVENT tick EVERY 10 ms PHASE 1 ms"),
      with(text, "EVENT tick EVERY 10 ms", "EVENT tick SPORADIC 10 ms"),
      with(text, "PLACE LS1 ON P0 PRIORITY 2", "PLACE LS1 ON P0 PRIORITY 1"),
      with(text, "PROCESSOR P0", "PROCESSOR P0 NONPREEMPTIVE"),
      with(text, "    answer\n", "    answer\n    answer\n"),
      with(text, "ENVIRONMENT cell", "ENVIRONMENT other"),
      with(text, "END ENVIRONMENT", "  COST SEND 1 ns\nEND ENVIRONMENT"),
      with(text, "END ENVIRONMENT", "  LATENCY WITHIN PROCESSOR 1 ns\nEND ENVIRONMENT"),
  };
  for (const std::string& each : changed) keys.insert(key_of(each));
  keys.insert(key_of(text, {"exact", 1000}));
  keys.insert(key_of(text, {"auto", 1001}));
  CHECK(keys.size() == changed.size() + 3);
}
