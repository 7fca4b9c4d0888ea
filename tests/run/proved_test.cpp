// The generated skills on the runtime against what the analyzer proved of their PAL. Nothing that a run
// measures may exceed its bound, and runs come near the bound.
#include <catch2/catch.hpp>
#include <map>
#include <sstream>

#include "pal/runtime/dispatcher.hpp"
#include "programs/pal/reports/proof_chart.hpp"
#include "tests/run/support/bench.hpp"
#include "tests/run/support/touch_cell.hpp"
#include "tests/support/built_skills.hpp"

using namespace pal;
using namespace pal::test;

namespace {

program::Proof prove(const runtime::SkillPlugin& skill) {
  const std::string folder = std::string(PAL_SOURCE_DIR) + "/";
  const DiskFileSystem files;
  std::ostringstream out, err;
  program::Session session;
  program::Selection selection;
  selection.files = {folder + std::string(skill.pal_file)};
  selection.environments = {folder + std::string(skill.environment_file)};
  REQUIRE(program::read(selection, {out, err, files}, session));
  auto proofs = program::prove(session, {});
  REQUIRE(proofs.size() == 1);
  return std::move(proofs.front());
}

trace::Trace run(const runtime::SkillPlugin& skill, runtime::Time phase, runtime::Time answer,
                 const runtime::RunOptions& options) {
  Tool tool;
  tool.wall = 12;
  ForceSensor sensor(tool, answer);
  AlterPort alter(tool, phase);
  runtime::Device* devices[] = {&sensor, &alter};
  NoWorld world;
  const auto made = skill.make();
  return runtime::Dispatcher(devices, world).run(*made, {}, options).trace;
}

}  // namespace

TEST_CASE("no run measures more than was proved") {
  for (const runtime::SkillPlugin* plugin : built_skills()) {
    const runtime::SkillPlugin& skill = *plugin;
    // Those that need no more than this cell has; the others run in the workcell (tests/run/skills).
    const auto made = skill.make();
    const auto& needed = made->wiring().devices;
    if (!std::all_of(needed.begin(), needed.end(),
                     [](std::string_view device) { return device == "force-torque" || device == "alter"; }))
      continue;
    CAPTURE(skill.name);
    const program::Proof proof = prove(skill);
    std::map<std::string, Duration> greatest;
    for (int i = 0; i < 56; ++i) {
      for (const auto costs :
           {runtime::CostPolicy::worst, runtime::CostPolicy::best, runtime::CostPolicy::random}) {
        const auto answer = i % 2 == 0 ? runtime::Time(6ms) : runtime::Time(5700us);
        const trace::Trace measured =
            run(skill, i * 500us, answer, {.costs = costs, .seed = static_cast<std::uint64_t>(i)});
        for (std::size_t k = 0; k < proof.analysis.verdicts.size(); ++k) {
          const auto& verdict = proof.analysis.verdicts[k];
          const auto longest = program::longest_in(measured, proof, k);
          if (!longest) continue;
          CAPTURE(verdict.requirement, i, costs);
          REQUIRE(verdict.bound);
          CHECK(Duration(longest->length_ns()) <= *verdict.bound);
          auto& most = greatest[verdict.requirement];
          most = std::max(most, Duration(longest->length_ns()));
        }
      }
    }
    // Half-millisecond phases miss the very worst one by less than half a millisecond of 7.3 or 35.
    const auto age = std::find_if(proof.analysis.verdicts.begin(), proof.analysis.verdicts.end(),
                                  [](const auto& verdict) { return verdict.requirement == "fresh-force"; });
    CHECK(greatest["fresh-force"] > *age->bound - 500us);
    CHECK(greatest["answer-alter"] > 0us);
  }
}
