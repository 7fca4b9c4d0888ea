#include "programs/pal/reports/chart_book.hpp"

#include <string>
#include <utility>

#include "analyzer/chart/timeline.hpp"
#include "programs/pal/reports/chart_caption.hpp"
#include "programs/pal/reports/proof_chart.hpp"
#include "programs/pal/session/measure_text.hpp"

namespace pal::program {
namespace {

/// With all that is inside them.
std::vector<analyzer::chart::Part> parts_of(const std::vector<analyzer::Reason>& reasons) {
  std::vector<analyzer::chart::Part> parts;
  for (const analyzer::Reason& reason : reasons)
    parts.push_back({segment_of(reason, 0), parts_of(reason.inside)});
  return parts;
}

class Writer {
 public:
  void add(const Proof& proof, std::size_t index, const std::optional<trace::Trace>& measured) {
    const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
    analyzer::chart::Subject subject;
    subject.skill = proof.problem.skill;
    subject.environment = proof.problem.environment;
    subject.caption = proof_caption(proof, index);
    subject.brief = bound_text(verdict) + " of " + whole_text(verdict.allowed().figure);
    if (const auto shown = shown_run(proof, index)) subject.views.push_back(view_of(*shown));
    if (measured && measured->skill == proof.problem.skill)
      subject.views.push_back(view_of(measured_run(proof, index, *measured)));
    book.subjects.push_back(std::move(subject));
  }

  analyzer::chart::Book book;

 private:
  analyzer::chart::View view_of(const ShownRun& shown) {
    book.runs.push_back(analyzer::chart::timeline(shown.run));
    return {shown.name,           book.runs.size() - 1,    shown.options.highlight,
            shown.options.losses, parts_of(shown.reasons), shown.options.window};
  }
};

}  // namespace

analyzer::chart::Book book_of(const std::vector<Proof>& proofs, const Proof& first, std::size_t index,
                              const std::optional<trace::Trace>& measured) {
  Writer writer;
  writer.book.title = first.problem.skill;
  for (const Proof& proof : proofs) {
    if (&proof == &first) writer.book.first = writer.book.subjects.size() + index;
    for (std::size_t r = 0; r < proof.analysis.verdicts.size(); ++r) writer.add(proof, r, measured);
  }
  return std::move(writer.book);
}

}  // namespace pal::program
