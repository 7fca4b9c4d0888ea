// What was proved stays proved while only comments and blank lines change, also if the proof was ended early.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "language_server/analysis.hpp"
#include "programs/pal/reports/editor_proofs.hpp"
#include "tests/unit/language_server/client.hpp"

using namespace pal;
using namespace pal::language_server;

namespace {

/// A file of the shipped skills, open in an editor.
class Opened {
 public:
  explicit Opened(const std::string& file) : workspace_(disk_), path_(folder() + file) {
    workspace_.set_folders({folder()});
    text_ = workspace_.text(path_)->content();
    workspace_.open(path_, {"file://" + path_, 1, std::make_shared<const Text>(text_)});
  }

  const std::string& text() const { return text_; }
  std::shared_ptr<const Analysis> with(const std::string& text) {
    workspace_.change(path_, 2, std::make_shared<const Text>(text));
    auto made = analyze(workspace_, inputs_of(workspace_, path_, {}), {});
    REQUIRE_FALSE(made->diagnostics.has_errors());
    return made;
  }

 private:
  static std::string folder() { return std::string(PAL_SOURCE_DIR) + "/skills_pal/"; }

  DiskFileSystem disk_;
  Workspace workspace_;
  std::string path_, text_;
};

bool is_open(const ProvedRequirement& requirement) {
  return requirement.state == "open" || requirement.state == "undecided";
}

std::vector<std::string> states(const Proofs& proofs) {
  std::vector<std::string> result;
  for (const auto& proof : proofs) {
    for (const auto& each : proof.requirements) result.push_back(each.name + " " + each.state);
  }
  return result;
}

/// A proof that a newer text ends as soon as `enough` says so of what is known.
void prove_until(const Analysis& analysis, const Prover& prover,
                 const std::function<bool(const Proofs&)>& enough) {
  bool newer = false;
  prove(
      analysis, prover, Depth::quick, 3600, [&] { return newer; },
      [&](const Proofs& now) { newer = newer || enough(now); });
  REQUIRE(newer);
}

/// How often a proof tells what it knows: never, if all was kept.
int told_by_proof(const Analysis& analysis, const Prover& prover, Proofs& proofs) {
  int told = 0;
  proofs = prove(
      analysis, prover, Depth::quick, 3600, [] { return false; }, [&](const Proofs&) { ++told; });
  return told;
}

bool all_decided(const Proofs& now) {
  return !now.front().requirements.empty() &&
         std::none_of(now.front().requirements.begin(), now.front().requirements.end(), is_open);
}

}  // namespace

TEST_CASE("a comment leaves proofs as they are, though it came before the proof had ended") {
  Opened file("touch/touch_read_first.pal");
  const program::EditorProver prover;
  prove_until(*file.with(file.text()), prover, all_decided);
  Proofs proofs, fresh;
  const auto commented = file.with("# one line\n\n" + file.text() + "# and one\n");
  CHECK(told_by_proof(*commented, prover, proofs) == 0);
  CHECK(told_by_proof(*commented, program::EditorProver(), fresh) > 0);
  CHECK(states(proofs) == states(fresh));
  CHECK(std::find(states(proofs).begin(), states(proofs).end(), "fresh-force fails") != states(proofs).end());
}

TEST_CASE("of a proof that was ended what was decided is kept, and what was not is proved") {
  Opened file("touch/touch_read_first.pal");
  const program::EditorProver prover;
  std::size_t decided = 0;
  prove_until(*file.with(file.text()), prover, [&](const Proofs& now) {
    const auto& all = now.front().requirements;
    decided = static_cast<std::size_t>(all.size() - std::count_if(all.begin(), all.end(), is_open));
    return decided > 0;
  });
  Proofs proofs, fresh;
  const auto commented = file.with(file.text() + "\n# a comment\n");
  const int told = told_by_proof(*commented, prover, proofs);
  CHECK((told == 0) == (decided == proofs.front().requirements.size()));
  told_by_proof(*commented, program::EditorProver(), fresh);
  CHECK(states(proofs) == states(fresh));
}

TEST_CASE("another word is proved anew") {
  Opened file("touch/touch_read_first.pal");
  const program::EditorProver prover;
  prove_until(*file.with(file.text()), prover, all_decided);
  Proofs proofs;
  const auto changed =
      file.with(test::replaced(file.text(), "          advance\n", "          advance\n          advance\n"));
  CHECK(told_by_proof(*changed, prover, proofs) > 0);
}
