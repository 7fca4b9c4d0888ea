#include "analyzer/slice/slice.hpp"

#include <algorithm>

#include "analyzer/slice/talk.hpp"

namespace pal::analyzer {
namespace {

class Slicer {
 public:
  Slicer(const Problem& problem, const Cone& cone, Relaxation relaxation)
      : whole_(problem), cone_(cone), relaxation_(relaxation), talk_(talk_of(problem)), made_(problem) {}

  Problem make() {
    for (const ChannelId c : made_.channels.ids()) loosen(c);
    for (const DeviceId d : made_.devices.ids()) {
      if (!cone_.devices[d]) made_.devices[d].behaviour = std::monostate();
      if (relaxation_.periods) space_out(made_.devices[d]);
      made_.devices[d].seldom = relaxation_.periods && cone_.pacers[d];
    }
    free_conditions();
    for (const ThreadId t : made_.threads.ids()) {
      if (cone_.threads[t]) {
        hold_waits(t);
        note_beginning(t);
      } else {
        leave_out(made_.threads[t]);
      }
    }
    return std::move(made_);
  }

 private:
  /// Whether all parties at both ends are kept.
  bool is_kept(ChannelId channel) const {
    for (const ThreadId t : talk_.ids()) {
      const bool uses = talk_[t].sends.contains(channel) || talk_[t].waits.contains(channel);
      if (uses && !cone_.threads[t]) return false;
    }
    const Channel& of = whole_.channels[channel];
    if (of.sender_device.valid() && !cone_.devices[of.sender_device]) return false;
    return !of.served || cone_.devices[of.receiver_device];
  }

  /// A request and its answer are followed together or not at all.
  void loosen(ChannelId channel) {
    Channel& of = made_.channels[channel];
    // A device takes at once what it does not serve, whatever is left out.
    if (of.receiver_device.valid() && !of.served) return;
    const bool kept = is_kept(channel) && (!of.answer.valid() || is_kept(of.answer)) &&
                      (!of.answers.valid() || is_kept(of.answers));
    if (kept) return;
    of.loose = true;
    const ChannelId request = of.answers.valid() ? of.answers : channel;
    of.withdrawable = whole_.channels[request].answer.valid() && may_be_withdrawn(request);
  }

  /// Whether a thread may give up waiting for the answer to a request, or be stopped before it has it.
  bool may_be_withdrawn(ChannelId request) const {
    for (const ThreadId t : talk_.ids()) {
      if (talk_[t].sends.contains(request) && whole_.threads[t].parent.valid()) return true;
      for (const StepId s : talk_[t].steps) {
        const Step& step = whole_.steps[s];
        if (step.kind != Step::Kind::wait || !step.within) continue;
        const auto answer =
            std::find(step.channels.begin(), step.channels.end(), whole_.channels[request].answer);
        if (answer != step.channels.end()) return true;
      }
    }
    return false;
  }

  static void space_out(Device& device) {
    auto* event = std::get_if<pan::EventDevice>(&device.behaviour);
    if (event == nullptr) return;
    event->sporadic = true;
    event->phase.reset();
  }

  void free_conditions() {
    std::uint64_t left_out = 0;
    std::uint64_t told = 0;  // a set says which value
    for (const ThreadId t : talk_.ids()) {
      for (const StepId s : talk_[t].steps) {
        const Step& step = whole_.steps[s];
        if (step.kind != Step::Kind::set) continue;
        const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(step.condition.index());
        if (!cone_.threads[t]) left_out |= bit;
        if (step.value) told |= bit;
      }
    }
    made_.free_conditions = left_out | (relaxation_.conditions ? ~told : 0);
    find_setters();
  }

  void find_setters() {
    for (const ConditionId c : whole_.conditions.ids()) {
      Setters setters;
      setters.threads.assign(talk_.size(), false);
      bool together = true;
      for (const ThreadId t : talk_.ids()) {
        if (!talk_[t].sets.contains(c)) continue;
        const ProcessorId processor = whole_.threads[t].processor;
        setters.threads[t] = true;
        together = together && (!setters.processor.valid() || setters.processor == processor);
        setters.processor = processor;
      }
      if (!together) setters.processor = {};
      made_.setters.push_back(std::move(setters));
    }
  }

  /// A device that is left out answers no sooner than it can.
  void hold_waits(ThreadId thread) {
    for (const StepId s : talk_[thread].steps) {
      const Step& step = whole_.steps[s];
      if (step.kind != Step::Kind::wait || step.channels.size() != 1) continue;
      if (made_.channels[step.channels.front()].loose)
        made_.steps[s].arrival.best = least_wait(whole_, talk_, thread, s);
    }
  }

  void note_beginning(ThreadId thread) {
    if (whole_.threads[thread].parent.valid()) return;
    for (const StepId s : talk_[thread].beginning) made_.steps[s].before_blocks = true;
  }

  void leave_out(Thread& thread) {
    thread.left_out = true;
    if (!thread.parent.valid()) return;
    // Only its end can be seen, and how long it goes on when it is cancelled.
    const StepId waits(made_.steps.size());
    const StepId works(waits.index() + 1);
    const StepId ends(waits.index() + 2);
    Step wait;
    wait.kind = Step::Kind::wait;
    wait.next = {works};
    if (thread.can_end) wait.next.push_back(ends);
    Step work;
    work.kind = Step::Kind::activity;
    work.cost = {0, Range::unbounded};
    work.next = {waits};  // never taken: it is cancelled
    made_.steps.push_back(wait);
    made_.steps.push_back(work);
    made_.steps.push_back(Step());
    thread.entry = waits;
    thread.processor = ProcessorId(made_.processors.size());
    pan::Processor alone;
    alone.preemptive = true;
    made_.processors.push_back(alone);
  }

  const Problem& whole_;
  const Cone& cone_;
  Relaxation relaxation_;
  Table<ThreadId, ThreadTalk> talk_;
  Problem made_;
};

}  // namespace

Problem slice_of(const Problem& problem, const Cone& cone, Relaxation relaxation) {
  return Slicer(problem, cone, relaxation).make();
}

}  // namespace pal::analyzer
