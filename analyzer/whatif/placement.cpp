#include "analyzer/whatif/placement.hpp"

#include <algorithm>
#include <numeric>

namespace pal::analyzer {
namespace {

using Is = Verdict::State;

void add_processor(pan::Environment& environment) {
  pan::Processor more = environment.processors.back();
  for (int number = static_cast<int>(environment.processors.size());; ++number) {
    more.name = "P" + std::to_string(number);
    const auto same = [&](const pan::Processor& each) { return each.name == more.name; };
    if (std::none_of(environment.processors.begin(), environment.processors.end(), same)) break;
  }
  environment.processors.push_back(more);
}

void fit_processors(pan::Environment& environment, int processors) {
  while (static_cast<int>(environment.processors.size()) < processors) add_processor(environment);
  environment.processors.resize(static_cast<std::size_t>(processors));
}

void sit(pan::Environment& environment, const std::vector<Seat>& seats) {
  environment.placements.clear();
  for (const Seat& seat : seats) {
    const auto& processor = environment.processors[static_cast<std::size_t>(seat.processor)];
    environment.placements.push_back({seat.thread, processor.name, seat.priority, {}});
  }
}

class PlacementSearch {
 public:
  PlacementSearch(int processors, const pan::Environment& environment, Judge& judge,
                  const PlacementOptions& options)
      : environment_(environment), judge_(judge), options_(options) {
    found_.processors = processors;
    fit_processors(environment_, processors);
  }

  Placements run(const Problem& as_it_is) {
    for (const Thread& thread : as_it_is.threads) seats_.push_back({thread.name, 0, thread.priority});
    found_.broken.assign(as_it_is.requirements.size(), 0);
    requirements_.resize(as_it_is.requirements.size());
    std::iota(requirements_.begin(), requirements_.end(), std::size_t{0});
    for (const pan::Processor& processor : environment_.processors) {
      if (processor.preemptive != environment_.processors.front().preemptive) found_.interchangeable = false;
    }
    for (const Requirement& requirement : as_it_is.requirements) {
      if (!requirement.processors.empty() && requirement.processors.size() < as_it_is.processors.size())
        found_.interchangeable = false;
    }
    if (static_cast<int>(seats_.size()) >= found_.processors) seat(0, 0);
    return std::move(found_);
  }

 private:
  bool enough() {
    if (options_.first_is_enough && !found_.meet.empty()) return true;
    if (found_.tried < options_.most && !judge_.stopped()) return false;
    found_.complete = false;
    return true;
  }

  /// Seats the threads from `next` on; `used` processors have somebody. Of processors that are all alike the
  /// first free one stands for every free one, so that each partition of the threads comes once.
  void seat(std::size_t next, int used) {
    if (next == seats_.size()) {
      if (everybody_works()) options_.priorities ? order(0) : attempt();
      return;
    }
    const int last = found_.interchangeable ? std::min(used, found_.processors - 1) : found_.processors - 1;
    for (int processor = 0; processor <= last; ++processor) {
      const int now = found_.interchangeable ? std::max(used, processor + 1) : used;
      const auto left = static_cast<int>(seats_.size() - next) - 1;
      if (found_.interchangeable && now + left < found_.processors) continue;
      seats_[next].processor = processor;
      seat(next + 1, now);
      if (enough()) return;
    }
  }

  bool everybody_works() const {
    for (int processor = 0; processor < found_.processors; ++processor) {
      const auto here = [&](const Seat& seat) { return seat.processor == processor; };
      if (std::none_of(seats_.begin(), seats_.end(), here)) return false;
    }
    return true;
  }

  /// All orders of the threads of `processor` and of those behind it.
  void order(int processor) {
    if (processor == found_.processors) return attempt();
    std::vector<std::size_t> here;
    for (std::size_t s = 0; s < seats_.size(); ++s) {
      if (seats_[s].processor == processor) here.push_back(s);
    }
    std::vector<std::size_t> sequence = here;
    do {
      for (std::size_t place = 0; place < sequence.size(); ++place)
        seats_[sequence[place]].priority = static_cast<int>(sequence.size() - place);
      order(processor + 1);
      if (enough()) return;
    } while (std::next_permutation(sequence.begin(), sequence.end()));
  }

  void attempt() {
    ++found_.tried;
    sit(environment_, seats_);
    const auto problem = judge_.problem(environment_);
    const Ruling ruling = problem ? judge_.ask(*problem, requirements_) : Ruling{};
    if (ruling.state == Is::fails) {
      found_.refuted.push_back({seats_, ruling});
      ++found_.broken[static_cast<std::size_t>(ruling.requirement)];
    } else {
      (ruling.state == Is::holds ? found_.meet : found_.undecided).push_back({seats_, ruling});
    }
  }

  pan::Environment environment_;
  Judge& judge_;
  const PlacementOptions& options_;
  std::vector<std::size_t> requirements_;
  std::vector<Seat> seats_;
  Placements found_;
};

}  // namespace

pan::Environment placed(pan::Environment environment, int processors, const std::vector<Seat>& seats) {
  fit_processors(environment, processors);
  sit(environment, seats);
  return environment;
}

Placements placements_on(int processors, const pan::Environment& environment, Judge& judge,
                         const PlacementOptions& options) {
  const auto problem = judge.problem(environment);
  if (!problem) return {};
  return PlacementSearch(processors, environment, judge, options).run(*problem);
}

std::vector<Placements> fewest_processors(const pan::Environment& environment, Judge& judge,
                                          const PlacementOptions& options) {
  std::vector<Placements> all;
  const auto problem = judge.problem(environment);
  if (!problem) return all;
  PlacementOptions one = options;
  one.first_is_enough = true;
  for (int processors = 1; processors <= static_cast<int>(problem->threads.size()); ++processors) {
    all.push_back(placements_on(processors, environment, judge, one));
    if (!all.back().meet.empty() || judge.stopped()) break;
  }
  return all;
}

}  // namespace pal::analyzer
