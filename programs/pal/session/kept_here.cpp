#include "programs/pal/session/kept_here.hpp"

#include <algorithm>

#include "pal/pan/times.hpp"

namespace pal::program {
namespace {

std::string hash_of_texts(const SourceManager& sources) {
  std::string all;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const FileId file(i);
    all += sources.name(file) + "\n" + study::sha256(sources.text(file)) + "\n";
  }
  return study::sha256(all);
}

}  // namespace

const char* name(analyzer::AnalysisChoice choice) {
  switch (choice) {
    case analyzer::AnalysisChoice::automatic:
      return "auto";
    case analyzer::AnalysisChoice::thorough:
      return "thorough";
    case analyzer::AnalysisChoice::exact:
      return "exact";
    case analyzer::AnalysisChoice::compositional:
      return "compositional";
    case analyzer::AnalysisChoice::half_open:
      break;
  }
  return "half-open";
}

study::KeyOptions key_options(const ProofLimits& limits) {
  return {name(limits.analysis), limits.max_states};
}

study::KeptProof kept_form(const analyzer::Analysis& analysis) {
  return {{}, analysis.verdicts, {}};
}

KeptHere::KeptHere(const pan::Network& skill, const pan::Environment& environment, const Session& session,
                   const ProofLimits& limits)
    : limits_(limits) {
  if (limits.cache == nullptr || limits.analysis == analyzer::AnalysisChoice::half_open) return;
  key_ = study::proof_key(study::sha256(study::canonical_text(skill)),
                          study::sha256(study::canonical_text(pan::with_times_of(skill, environment))),
                          key_options(limits));
  if (limits.addends) texts_ = hash_of_texts(session.sources);
}

std::optional<analyzer::Analysis> KeptHere::find(const analyzer::Problem& problem) const {
  if (key_.empty() || limits_.fresh) return std::nullopt;
  auto kept = limits_.cache->find(key_);
  if (!kept || !kept->refused.empty() || (!texts_.empty() && kept->addends_of != texts_) ||
      kept->verdicts.size() != problem.requirements.size())
    return std::nullopt;
  analyzer::Analysis analysis;
  for (std::size_t i = 0; i < kept->verdicts.size(); ++i) {
    analyzer::Verdict& verdict = kept->verdicts[i];
    if (verdict.state != analyzer::VerdictState::holds || verdict.requirement != problem.requirements[i].name)
      return std::nullopt;
    verdict.where = problem.requirements[i].where;
    analysis.verdicts.push_back(std::move(verdict));
  }
  return analysis;
}

void KeptHere::keep(const analyzer::Analysis& analysis) const {
  if (key_.empty()) return;
  study::KeptProof kept = kept_form(analysis);
  kept.addends_of = texts_;
  limits_.cache->keep(key_, kept);  // a cache that cannot be written costs time, nothing else
}

}  // namespace pal::program
