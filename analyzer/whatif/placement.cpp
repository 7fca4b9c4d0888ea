#include "analyzer/whatif/placement.hpp"

#include <algorithm>

namespace pal::analyzer::whatif {
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

void place(pan::Environment& environment, const std::vector<ThreadPlacement>& threads) {
  environment.placements.clear();
  for (const ThreadPlacement& each : threads) {
    while (environment.processors.size() <= each.processor.index()) add_processor(environment);
    const auto& processor = environment.processors[each.processor.index()];
    environment.placements.push_back({each.thread, processor.name, each.priority, {}});
  }
}

/// The processor that a requirement names; empty: none.
std::string named(const pan::Requirement& requirement) {
  if (const auto* load = std::get_if<pan::Load>(&requirement.measure)) return load->processor;
  if (const auto* busy = std::get_if<pan::BusyPeriod>(&requirement.measure)) return busy->processor;
  return "";
}

/// By processor: the first that is like it.
std::vector<std::size_t> likenesses(const pan::Network& network, const pan::Environment& environment) {
  const std::vector<pan::Processor>& all = environment.processors;
  const auto is_named = [&](const pan::Processor& processor) {
    return std::any_of(network.requirements.begin(), network.requirements.end(),
                       [&](const auto& requirement) { return named(requirement) == processor.name; });
  };
  std::vector<std::size_t> like(all.size());
  for (std::size_t p = 0; p < all.size(); ++p) {
    const auto alike = [&](std::size_t first) {
      return all[first].preemptive == all[p].preemptive && !is_named(all[first]) && !is_named(all[p]);
    };
    while (like[p] < p && !alike(like[p])) ++like[p];
  }
  return like;
}

class PlacementSearch {
 public:
  PlacementSearch(int processors, const pan::Environment& environment, RequirementChecker& checker,
                  const PlacementOptions& options)
      : environment_(environment), checker_(checker), options_(options) {
    found_.processors = processors;
    while (static_cast<int>(environment_.processors.size()) < processors) add_processor(environment_);
    for (const pan::Processor& each : environment_.processors) found_.names.push_back(each.name);
    like_ = likenesses(checker.network(), environment_);
    used_.resize(environment_.processors.size());
  }

  Placements run(const Problem& as_it_is) {
    for (const Thread& thread : as_it_is.threads)
      threads_.push_back({thread.name, ProcessorId(0), thread.priority});
    found_.broken.assign(as_it_is.requirements.size(), 0);
    requirements_ = requirements_of(as_it_is);
    if (static_cast<int>(threads_.size()) >= found_.processors) place_from(0, found_.processors);
    return std::move(found_);
  }

 private:
  bool enough() {
    if (options_.first_is_enough && !found_.meet.empty()) return true;
    if (found_.tried < options_.most && !checker_.stopped()) return false;
    found_.complete = false;
    return true;
  }

  /// Of free processors that are alike the first stands for all.
  bool stands_for_another(std::size_t processor) const {
    for (std::size_t p = like_[processor]; p < processor; ++p) {
      if (like_[p] == like_[processor] && used_[p] == 0) return true;
    }
    return false;
  }

  /// Places the threads from `next` on; `free` more processors have to get a thread.
  void place_from(std::size_t next, int free) {
    if (next == threads_.size()) return options_.priorities ? order(0) : attempt();
    const auto left = static_cast<int>(threads_.size() - next) - 1;
    for (std::size_t processor = 0; processor < used_.size(); ++processor) {
      const int still = used_[processor] == 0 ? free - 1 : free;
      if (still < 0 || still > left || (used_[processor] == 0 && stands_for_another(processor))) continue;
      threads_[next].processor = ProcessorId(processor);
      ++used_[processor];
      place_from(next + 1, still);
      --used_[processor];
      if (enough()) return;
    }
  }

  /// All orders of the threads of `processor` and of those behind it, first those without equals.
  void order(std::size_t processor) {
    if (processor == used_.size()) return attempt();
    std::vector<std::size_t> here;
    for (std::size_t s = 0; s < threads_.size(); ++s) {
      if (threads_[s].processor == ProcessorId(processor)) here.push_back(s);
    }
    if (here.empty()) return order(processor + 1);
    for (std::size_t ties = 0; ties < here.size(); ++ties) {
      std::vector<bool> tied(here.size() - 1);  // with the next
      std::fill(tied.end() - static_cast<std::ptrdiff_t>(ties), tied.end(), true);
      do {
        if (!orders_tied(processor, here, tied)) return;
      } while (std::next_permutation(tied.begin(), tied.end()));
    }
  }

  /// False: enough was tried.
  bool orders_tied(std::size_t processor, std::vector<std::size_t> sequence, const std::vector<bool>& tied) {
    do {
      bool once = true;  // equals in one order stand for all
      int priority = 1;
      for (std::size_t place = sequence.size(); place-- > 0;) {
        const bool tie = place + 1 < sequence.size() && tied[place];
        once = once && (!tie || sequence[place] < sequence[place + 1]);
        if (place + 1 < sequence.size() && !tie) ++priority;
        threads_[sequence[place]].priority = priority;
      }
      if (!once) continue;
      order(processor + 1);
      if (enough()) return false;
    } while (std::next_permutation(sequence.begin(), sequence.end()));
    return true;
  }

  void attempt() {
    ++found_.tried;
    place(environment_, threads_);
    const auto problem = checker_.problem(environment_);
    const Ruling ruling = problem ? checker_.ask(*problem, requirements_) : Ruling{};
    if (ruling.state == Is::fails) {
      found_.refuted.push_back({threads_, ruling});
      ++found_.broken[ruling.requirement.index()];
    } else {
      (ruling.state == Is::holds ? found_.meet : found_.undecided).push_back({threads_, ruling});
    }
  }

  pan::Environment environment_;
  RequirementChecker& checker_;
  const PlacementOptions& options_;
  std::vector<std::size_t> like_;  // by processor
  std::vector<int> used_;          // by processor: threads
  RequirementIds requirements_;
  std::vector<ThreadPlacement> threads_;
  Placements found_;
};

}  // namespace

pan::Environment placed(pan::Environment environment, const std::vector<ThreadPlacement>& threads) {
  place(environment, threads);
  return environment;
}

Placements placements_on(int processors, const pan::Environment& environment, RequirementChecker& checker,
                         const PlacementOptions& options) {
  const auto problem = checker.problem(environment);
  if (!problem) return {};
  return PlacementSearch(processors, environment, checker, options).run(*problem);
}

std::vector<Placements> fewest_processors(const pan::Environment& environment, RequirementChecker& checker,
                                          const PlacementOptions& options) {
  std::vector<Placements> all;
  const auto problem = checker.problem(environment);
  if (!problem) return all;
  PlacementOptions one = options;
  one.first_is_enough = true;
  for (int processors = 1; processors <= static_cast<int>(problem->threads.size()); ++processors) {
    all.push_back(placements_on(processors, environment, checker, one));
    if (!all.back().meet.empty() || checker.stopped()) break;
  }
  return all;
}

}  // namespace pal::analyzer::whatif
