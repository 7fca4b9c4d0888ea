#include "analyzer/verdict/loop_growth.hpp"

#include <utility>

#include "analyzer/runs/growing_loop.hpp"
#include "analyzer/verdict/sentence.hpp"
#include "analyzer/verdict/story.hpp"

namespace pal::analyzer {

bool set_loop_growth(const Problem& problem, const Requirement& requirement,
                     const std::function<bool()>& stop, Verdict& verdict) {
  using State = Verdict::State;
  if (verdict.loop_growth) return true;
  const bool open = verdict.state == State::undecided || verdict.state == State::fails;
  const bool lost = verdict.witness && verdict.witness->failed;  // an event without a response says more
  if (!open || verdict.bound || lost) return false;
  auto found = find_growing_loop(problem, requirement, stop);
  if (!found) return false;
  verdict.state = State::fails;
  verdict.exact = false;
  verdict.gave_up = false;
  verdict.witness = std::move(found->beyond);
  verdict.addends.clear();
  verdict.reasons = reasons(problem, requirement, found->first_turns);
  const std::string length = milliseconds(found->stretch);
  verdict.explanation = "in each " + length +
                        " the run comes back to where it was, except that the value is " + length +
                        " greater: this can be repeated as often as one likes";
  verdict.loop_growth = LoopGrowth{found->loop, std::move(found->first_turns),
                                   phase_without(problem, requirement, found->loop, stop)};
  return true;
}

}  // namespace pal::analyzer
