#include "programs/pal/reports/kept_proofs.hpp"

#include <algorithm>
#include <utility>

#include "analyzer/verdict/moved.hpp"
#include "pal/syntax/text_tokens.hpp"

namespace pal::program {
namespace {

/// A text and its undone change, of some skills of one file.
constexpr std::size_t most_models = 6;

/// Words of a text without its comments, each in a line.
class Words {
 public:
  explicit Words(const SourceManager& sources) : sources_(sources) {}

  /// `without`: sorted places of the file that are left out.
  void add(FileId file, const std::vector<SourceSpan>& without, std::string& words) const {
    const auto text = sources_.text(file);
    auto next = without.begin();
    for (const auto& token : syntax::text_tokens(text)) {
      if (token.kind == syntax::TextToken::Kind::comment) continue;
      while (next != without.end() && next->end <= token.begin) ++next;
      if (next != without.end() && next->begin <= token.begin) continue;
      words.append(text.substr(token.begin, token.end - token.begin)).push_back('\n');
    }
  }

  std::string at(const SourceSpan& where) const {
    std::string words;
    if (!where.valid()) return words;
    const auto text = sources_.text(where);
    for (const auto& token : syntax::text_tokens(text)) {
      if (token.kind != syntax::TextToken::Kind::comment)
        words.append(text.substr(token.begin, token.end - token.begin)).push_back('\n');
    }
    return words;
  }

 private:
  const SourceManager& sources_;
};

}  // namespace

ProofKey key_of(const pan::Network& skill, const pan::Environment& environment,
                const analyzer::Problem& problem, const SourceManager& sources) {
  const Words words(sources);
  ProofKey key;
  key.model = skill.skill.name + "\n" + environment.name + "\n";
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const FileId file(i);
    std::vector<SourceSpan> own;
    for (const auto& requirement : skill.requirements) {
      if (requirement.where.valid() && requirement.where.file == file) own.push_back(requirement.where);
    }
    std::sort(own.begin(), own.end(),
              [](const SourceSpan& a, const SourceSpan& b) { return a.begin < b.begin; });
    key.model += "\n" + sources.name(file) + "\n";
    words.add(file, own, key.model);
  }
  for (const auto& requirement : problem.requirements)
    key.requirements.push_back(requirement.name + "\n" + words.at(requirement.where));
  return key;
}

std::list<KeptProofs::Model>::iterator KeptProofs::model(const std::string& key) {
  const auto found =
      std::find_if(models_.begin(), models_.end(), [&](const Model& each) { return each.key == key; });
  if (found != models_.end()) models_.splice(models_.begin(), models_, found);
  return found;
}

std::vector<std::optional<KeptVerdict>> KeptProofs::find(const ProofKey& key,
                                                         const analyzer::Problem& problem) {
  std::vector<std::optional<KeptVerdict>> result(problem.requirements.size());
  const std::lock_guard lock(mutex_);
  const auto kept = model(key.model);
  if (kept == models_.end()) return result;
  for (std::size_t r = 0; r < result.size(); ++r) {
    const auto found = kept->verdicts.find(key.requirements[r]);
    if (found == kept->verdicts.end()) continue;
    auto now = analyzer::moved(found->second.verdict, *kept->problem, problem);
    if (!now) continue;
    now->where = problem.requirements[r].where;
    result[r] = KeptVerdict{std::move(*now), found->second.whole};
  }
  return result;
}

void KeptProofs::keep(const ProofKey& key, const analyzer::Problem& problem,
                      const std::vector<analyzer::Verdict>& verdicts, Found found) {
  const auto is_open = [](const analyzer::Verdict& verdict) {
    return verdict.state == analyzer::VerdictState::undecided;
  };
  if (std::all_of(verdicts.begin(), verdicts.end(), is_open)) return;
  const std::lock_guard lock(mutex_);
  if (model(key.model) == models_.end()) models_.push_front({key.model, nullptr, {}});
  Model& kept = models_.front();
  // Verdicts of an earlier text have its lines.
  if (kept.problem != nullptr) {
    std::map<std::string, KeptVerdict> now;
    for (auto& [requirement, each] : kept.verdicts) {
      if (auto verdict = analyzer::moved(each.verdict, *kept.problem, problem))
        now.emplace(requirement, KeptVerdict{std::move(*verdict), each.whole});
    }
    kept.verdicts = std::move(now);
  }
  kept.problem = std::make_shared<const analyzer::Problem>(problem);
  for (std::size_t r = 0; r < verdicts.size(); ++r) {
    if (is_open(verdicts[r])) continue;
    const bool whole = found == Found::whole || (found == Found::at_the_end && verdicts[r].exact);
    kept.verdicts[key.requirements[r]] = KeptVerdict{verdicts[r], whole};
  }
  while (models_.size() > most_models) models_.pop_back();
}

}  // namespace pal::program
