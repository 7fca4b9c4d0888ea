#include "analyzer/verdict/origins.hpp"

#include <algorithm>

#include "analyzer/problem/flow.hpp"

namespace pal::analyzer {

using trace::Kind;

Origins::Origins(const Problem& problem, const Requirement& requirement, const trace::Trace& run)
    : problem_(problem),
      requirement_(requirement),
      run_(run),
      threads_(problem.threads.size()),
      reads_(problem.threads.size()),
      requests_(problem.channels.size()),
      kept_(problem.kept.size()),
      conditions_(problem.conditions.size()),
      sets_(problem.conditions.size()) {
  if (requirement.condition.valid()) conditions_[requirement.condition].number = 0;
  for (const ThreadId t : problem.threads.ids()) {
    if (requirement.samples.empty()) break;
    for (const StepId s : steps_of(problem, problem.threads[t])) steps_[{t, problem.steps[s].statement}] = s;
  }
  for (std::size_t e = 0; e < run.events.size(); ++e) follow(e);
}

/// The step of a thread's event, if samples are followed.
const Step* Origins::step_of(const trace::Event& event) const {
  const auto found = steps_.find({ThreadId::of(event.actor), StatementId::of(event.statement)});
  return found == steps_.end() ? nullptr : &problem_.steps[found->second];
}

/// The statement gives its thread the samples of the messages that it uses.
void Origins::use(std::size_t index) {
  const trace::Event& event = run_.events[index];
  const Step* step = step_of(event);
  if (step == nullptr) return;
  for (const KeptId k : step->uses) {
    const Known& kept = kept_[k];
    if (kept.what.number < 0 || kept.what.number <= known(ThreadId::of(event.actor)).number) continue;
    gain(ThreadId::of(event.actor), index, kept.what);
    kept_since_[index] = kept.event;
  }
}

bool Origins::is_source(ChannelId channel) const {
  const std::vector<ChannelId>& samples = requirement_.samples;
  return requirement_.is_event(channel) ||
         std::find(samples.begin(), samples.end(), channel) != samples.end();
}

Origin Origins::birth(std::size_t event) {
  births_.push_back({run_.events[event].time_ns, event, static_cast<int>(births_.size()) + 1});
  return births_.back();
}

const Origin& Origins::known(ThreadId thread) const {
  static const Origin nothing;
  const std::vector<Gained>& all = threads_[thread];
  return all.empty() ? nothing : all.back().what;
}

void Origins::gain(ThreadId thread, std::size_t event, const Origin& what) {
  const bool of_samples = !requirement_.samples.empty();
  if (what.number < 0 || (of_samples && what.number <= known(thread).number)) return;
  threads_[thread].push_back({event, what});
}

void Origins::follow(std::size_t index) {
  const trace::Event& event = run_.events[index];
  const auto thread = ThreadId::of(event.actor);
  const bool device = thread.valid() && !problem_.threads.contains(thread);
  const std::pair<int, int> message{event.subject, event.value};
  switch (event.kind) {
    case Kind::block: {
      // The blocks of a CONCURRENT begin with what their parent has.
      const bool forks = event.subject < 0 && thread.valid() && !device;
      for (const ThreadId block : problem_.threads.ids()) {
        if (!forks || problem_.threads[block].parent != thread) continue;
        threads_[block].push_back({index, known(thread)});
        reads_[block] = reads_[thread];
      }
      return;
    }
    case Kind::done: {
      const Step* step = step_of(event);
      if (step == nullptr || step->kind != Step::Kind::activity) return;
      use(index);
      for (const KeptId k : step->writes) kept_[k] = {known(thread), index};
      return;
    }
    case Kind::put: {
      if (!device) use(index);
      puts_[message] = index;
      const ChannelId request = problem_.channels[ChannelId::of(event.subject)].answers;
      // A sample that answers a request is born when the device takes that.
      const bool served = device && request.valid();
      const Origin asked_by = served ? answered(request) : Origin{};
      const bool born_now =
          is_source(ChannelId::of(event.subject)) && !(served && requirement_.events.empty());
      messages_[message] = born_now ? birth(index) : device ? asked_by : known(thread);
      return;
    }
    case Kind::overrun:
    case Kind::drop: {
      // An answer that no thread gets answers its request all the same.
      const ChannelId request = problem_.channels[ChannelId::of(event.subject)].answers;
      if (device && request.valid()) answered(request);
      return;
    }
    case Kind::take: {
      const Origin carried = messages_[message];
      if (!device) {
        if (puts_.contains(message)) put_of_[index] = puts_[message];
        // What a thread has read of a condition stays with it: a message tells only why it went on no sooner.
        const bool reads = requirement_.condition.valid() && reads_[thread];
        if (!reads || carried.number == known(thread).number) gain(thread, index, carried);
        const KeptId kept = problem_.channels[ChannelId::of(event.subject)].kept;
        if (kept.valid()) kept_[kept] = {carried, index};
        return;
      }
      const ChannelId answer = problem_.channels[ChannelId::of(event.subject)].answer;
      const bool sample = answer.valid() && !requirement_.samples.empty() && is_source(answer);
      requests_[ChannelId::of(event.subject)].push_back(sample                         ? birth(index)
                                                        : !requirement_.events.empty() ? carried
                                                                                       : Origin{});
      return;
    }
    case Kind::set: {
      const auto condition = ConditionId::of(event.subject);
      sets_[condition] = index;
      use(index);
      if (condition == requirement_.condition) conditions_[condition] = birth(index);
      if (!requirement_.samples.empty()) conditions_[condition] = known(thread);
      return;
    }
    case Kind::read: {
      const auto condition = ConditionId::of(event.subject);
      set_of_[index] = sets_[condition];
      const bool watched = condition == requirement_.condition || !requirement_.samples.empty();
      if (watched) gain(thread, index, conditions_[condition]);
      if (condition == requirement_.condition) reads_[thread] = true;
      return;
    }
    default:
      return;
  }
}

Origin Origins::answered(ChannelId request) {
  std::deque<Origin>& taken = requests_[request];
  if (taken.empty()) return {};
  const Origin oldest = taken.front();
  taken.pop_front();
  return oldest;
}

std::optional<Gained> Origins::gained(ThreadId thread, std::size_t before) const {
  const std::vector<Gained>& all = threads_[thread];
  const auto after = std::partition_point(all.begin(), all.end(),
                                          [before](const Gained& each) { return each.event <= before; });
  if (after == all.begin() || std::prev(after)->what.number < 0) return std::nullopt;
  return *std::prev(after);
}

std::optional<std::size_t> Origins::put_of(std::size_t take) const {
  const auto found = put_of_.find(take);
  return found == put_of_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> Origins::kept_since(std::size_t use) const {
  const auto found = kept_since_.find(use);
  return found == kept_since_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> Origins::set_of(std::size_t read) const {
  const auto found = set_of_.find(read);
  return found == set_of_.end() ? std::nullopt : found->second;
}

std::optional<Origin> Origins::next_birth(Nanoseconds born) const {
  for (const Origin& each : births_) {
    if (each.born > born) return each;
  }
  return std::nullopt;
}

}  // namespace pal::analyzer
