#include "analyzer/slice/cone.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "analyzer/machine/watch.hpp"
#include "analyzer/slice/talk.hpp"

namespace pal::analyzer {
namespace {

using Measure = Requirement::Measure;

/// How far what a thread waits for is kept, too.
enum class Hold {
  none,    // the thread is left out
  loose,   // it only takes time from others: what modules tell it may come at any time
  strong,  // what it waits for again and again is kept
};

class Finder {
 public:
  Finder(const Problem& problem, const Requirement& requirement, ProcessorId processor, Reach reach)
      : problem_(problem),
        requirement_(requirement),
        reach_(reach),
        watch_(watch_of(problem, requirement, processor)),
        talk_(talk_of(problem)),
        hold_(problem.threads.size(), Hold::none),
        devices_(problem.devices.size()) {}

  Cone find() {
    seed();
    for (changed_ = true; changed_;) {
      changed_ = false;
      for (const ThreadId t : hold_.ids()) {
        if (hold_[t] != Hold::none) around(t);
      }
      share_processors();
      for (const DeviceId d : devices_.ids()) {
        if (devices_[d]) around_device(d);
      }
    }
    Cone cone;
    for (const Hold hold : hold_) cone.threads.push_back(hold != Hold::none);
    cone.devices = devices_;
    cone.pacers = pacers();
    return cone;
  }

 private:
  void keep(ThreadId thread, Hold hold) {
    if (hold_[thread] >= hold) return;
    hold_[thread] = hold;
    changed_ = true;
  }
  void keep_device(DeviceId device) {
    if (!device.valid() || devices_[device]) return;
    devices_[device] = true;
    changed_ = true;
  }
  void keep_if(Hold hold, const std::function<bool(const ThreadTalk&)>& meant) {
    for (const ThreadId t : talk_.ids()) {
      if (meant(talk_[t])) keep(t, hold);
    }
  }
  /// Both ends of a channel, and all others that use it.
  void keep_channel(ChannelId channel) {
    keep_if(Hold::strong, [channel](const ThreadTalk& talk) {
      return talk.sends.contains(channel) || talk.waits.contains(channel);
    });
    const Channel& of = problem_.channels[channel];
    keep_device(of.sender_device);
    if (of.served) keep_device(of.receiver_device);
  }

  void keep_channels_of(DeviceId device) {
    for (const ChannelId c : problem_.channels.ids()) {
      const Channel& of = problem_.channels[c];
      if (of.sender_device == device || (of.receiver_device == device && of.served)) keep_channel(c);
    }
  }

  // What is measured, and what carries it.

  void seed() {
    keep_if(Hold::strong, [this](const ThreadTalk& talk) {
      return std::any_of(talk.steps.begin(), talk.steps.end(),
                         [this](StepId step) { return watch_.at[step] || is_of_phase(step); });
    });
    if (requirement_.device.valid()) keep_device(requirement_.device);
    if (watch_.kind == Watch::Kind::loss) keep_channels_of(requirement_.device);
    for (const ChannelId channel : requirement_.events) keep_channel(channel);
    for (const ChannelId channel : requirement_.samples) keep_channel(channel);
    if (watch_.kind == Watch::Kind::age) {
      keep_if(Hold::strong, [this](const ThreadTalk& talk) { return talk.sets.contains(watch_.condition); });
    }
    if (watch_.kind == Watch::Kind::busy) {
      for (const ThreadId t : hold_.ids()) {
        if (problem_.threads[t].processor == watch_.processor) keep(t, Hold::strong);
      }
    }
    if (watch_.kind == Watch::Kind::response || watch_.kind == Watch::Kind::sample) carriers();
  }

  /// Whether it begins or ends the part of a run that is measured.
  bool is_of_phase(StepId step) const {
    const Phase& phase = watch_.phase;
    return (!phase.after.empty() && phase.after[step]) || (!phase.during.empty() && phase.during[step]);
  }

  /// Channels and conditions by which the measured value may come to a statement of the requirement. They lie
  /// between where it may be known and where it may still count.
  void carriers() {
    Table<ThreadId, bool> knows(talk_.size());
    Table<ThreadId, bool> counts(talk_.size());
    const bool samples = watch_.kind == Watch::Kind::sample;
    if (samples) find_echoes();
    const std::vector<ChannelId>& sources = samples ? requirement_.samples : requirement_.events;
    for (const ThreadId t : talk_.ids()) {
      for (const ChannelId channel : sources) knows[t] = knows[t] || talk_[t].waits.contains(channel);
      for (const StepId step : talk_[t].steps) counts[t] = counts[t] || watch_.at[step];
    }
    for (bool grown = true; grown;) {
      grown = false;
      for (const ThreadId a : talk_.ids()) {
        for (const ThreadId b : talk_.ids()) {
          if (!tells_new(a, b, samples)) continue;
          grown = grown || (knows[a] && !knows[b]) || (counts[b] && !counts[a]);
          knows[b] = knows[b] || knows[a];
          counts[a] = counts[a] || counts[b];
        }
      }
    }
    for (const ThreadId a : talk_.ids()) {
      if (!knows[a]) continue;
      for (const ThreadId b : talk_.ids()) {
        if (counts[b] && tells_new(a, b, samples)) keep_way(talk_[a], b);
      }
    }
  }

  /// For each thread with blocks, the threads that only know what it has known before. They get no sample,
  /// and messages only from one another and from it.
  void find_echoes() {
    for (const ThreadId p : talk_.ids()) {
      if (talk_[p].blocks.empty()) continue;
      Table<ThreadId, bool> echo(talk_.size(), true);
      echo[p] = false;
      for (bool changed = true; changed;) {
        changed = false;
        for (const ThreadId t : talk_.ids()) {
          if (!echo[t] || is_echo(t, p, echo)) continue;
          echo[t] = false;
          changed = true;
        }
      }
      echoes_.emplace_back(p, std::move(echo));
    }
  }

  bool is_echo(ThreadId thread, ThreadId of, const Table<ThreadId, bool>& echo) const {
    for (const ChannelId channel : requirement_.samples) {
      if (talk_[thread].waits.contains(channel)) return false;
    }
    for (const ThreadId a : talk_.ids()) {
      const bool known = echo[a] || a == of;
      if (!known && tells(talk_[a], thread, true)) return false;
    }
    return true;
  }

  bool is_within(ThreadId thread, ThreadId parent) const {
    for (; thread.valid(); thread = problem_.threads[thread].parent) {
      if (thread == parent) return true;
    }
    return false;
  }

  /// Whether `b` may learn from `a` what it does not know yet. What a thread knows its blocks know as they
  /// begin, and it goes on knowing it.
  bool tells_new(ThreadId a, ThreadId b, bool samples) const {
    if (!tells(talk_[a], ThreadId(b), samples)) return false;
    return std::none_of(echoes_.begin(), echoes_.end(),
                        [&](const auto& of) { return of.second[a] && is_within(ThreadId(b), of.first); });
  }

  /// The channel over which the answer to `channel` comes, if a device gives it; else `channel`.
  ChannelId arrival(ChannelId channel) const {
    const Channel& of = problem_.channels[channel];
    return of.served ? of.answer : channel;
  }

  bool tells(const ThreadTalk& from, ThreadId thread, bool samples) const {
    const ThreadTalk& to = talk_[thread];
    if (from.blocks.contains(thread)) return true;
    for (const ChannelId channel : from.sends) {
      if (to.waits.contains(arrival(channel))) return true;
    }
    const bool keeps = std::any_of(from.keeps.begin(), from.keeps.end(), [&](KeptId kept) {
      return to.uses.contains(kept) && !is_known(&ThreadTalk::keeps, kept, thread);
    });
    if (samples && keeps) return true;
    return samples && std::any_of(from.sets.begin(), from.sets.end(), [&](ConditionId condition) {
             return to.reads.contains(condition) && !is_known(&ThreadTalk::sets, condition, thread);
           });
  }

  /// Whether the reader of a condition, or of a message that its module keeps, knows all that can be learned
  /// from it. `written`: what threads set, or keep.
  template <class What>
  bool is_known(std::set<What> ThreadTalk::*written, What what, ThreadId reader) const {
    return std::any_of(echoes_.begin(), echoes_.end(), [&](const auto& of) {
      if (!is_within(reader, of.first)) return false;
      for (const ThreadId t : talk_.ids()) {
        const bool old = of.second[t] || t == of.first;
        if (!old && (talk_[t].*written).contains(what)) return false;
      }
      return true;
    });
  }

  void keep_way(const ThreadTalk& from, ThreadId thread) {
    const ThreadTalk& to = talk_[thread];
    keep(thread, Hold::strong);
    for (const ChannelId channel : from.sends) {
      if (!to.waits.contains(arrival(channel))) continue;
      keep_channel(channel);
      keep_channel(arrival(channel));
    }
    if (from.blocks.contains(thread))
      keep_if(Hold::strong, [&from](const ThreadTalk& of) { return &of == &from; });
    if (watch_.kind != Watch::Kind::sample) return;
    for (const KeptId kept : from.keeps) {
      if (!to.uses.contains(kept) || is_known(&ThreadTalk::keeps, kept, thread)) continue;
      keep_if(Hold::strong, [kept](const ThreadTalk& of) { return of.keeps.contains(kept); });
    }
    for (const ConditionId condition : from.sets) {
      if (!to.reads.contains(condition) || is_known(&ThreadTalk::sets, condition, thread)) continue;
      // Also setters that know nothing: a set makes forgotten what an earlier one said.
      keep_if(Hold::strong, [condition](const ThreadTalk& of) { return of.sets.contains(condition); });
    }
  }

  // What has an influence on that.

  void around(ThreadId thread) {
    const ThreadTalk& talk = talk_[thread];
    if (problem_.threads[thread].parent.valid()) keep(problem_.threads[thread].parent, Hold::strong);
    if (reach_ == Reach::least) return;
    if (hold_[thread] == Hold::loose && !is_paced(talk)) keep(thread, Hold::strong);
    const bool strong = hold_[thread] == Hold::strong;
    for (const ChannelId channel : talk.waits_again) {
      if (strong || !waits_long(thread, channel)) keep_device(problem_.channels[channel].sender_device);
    }
    if (!strong) return;
    for (const ChannelId channel : talk.waits_again) {
      keep_if(Hold::strong, [channel](const ThreadTalk& of) { return of.sends.contains(channel); });
    }
    for (const ChannelId channel : talk.sends_again) {
      keep_if(Hold::strong, [channel](const ThreadTalk& of) { return of.waits.contains(channel); });
      if (problem_.channels[channel].served) keep_device(problem_.channels[channel].receiver_device);
    }
    for (const ThreadId block : talk.blocks_again) {
      if (problem_.threads[block].can_end) keep(block, Hold::strong);
    }
  }

  /// Whether a thread that asks the device over and over again does so seldom without it, too.
  bool waits_long(ThreadId thread, ChannelId channel) const {
    const std::vector<StepId>& steps = talk_[thread].steps;
    return std::any_of(steps.begin(), steps.end(), [&](StepId s) {
      const Step& step = problem_.steps[s];
      return step.kind == Step::Kind::wait && step.channels.front() == channel &&
             least_wait(problem_, talk_, thread, s) > 0;
    });
  }

  /// Whether a device says how often a thread goes round.
  bool is_paced(const ThreadTalk& talk) const {
    return std::any_of(talk.waits_again.begin(), talk.waits_again.end(), [this](ChannelId channel) {
      return problem_.channels[channel].sender_device.valid();
    });
  }

  /// Keeps the threads that may go before one that is kept, or cannot be interrupted by it.
  void share_processors() {
    for (const ProcessorId p : problem_.processors.ids()) {
      int least = INT32_MAX;
      for (const ThreadId t : hold_.ids()) {
        const Thread& thread = problem_.threads[t];
        if (hold_[t] != Hold::none && thread.processor == p) least = std::min(least, thread.priority);
      }
      if (least == INT32_MAX) continue;
      for (const ThreadId t : hold_.ids()) {
        const Thread& thread = problem_.threads[t];
        const bool before = !problem_.processors[p].preemptive || thread.priority >= least;
        if (thread.processor == p && before) keep(t, Hold::loose);
      }
    }
  }

  /// Nothing that is measured goes through them, and only threads that just take time wait for them.
  Table<DeviceId, bool> pacers() const {
    Table<DeviceId, bool> found = devices_;
    if (requirement_.device.valid()) found[requirement_.device] = false;
    for (const ThreadId t : talk_.ids()) {
      if (hold_[t] != Hold::strong) continue;
      for (const ChannelId channel : talk_[t].waits) {
        const DeviceId device = problem_.channels[channel].sender_device;
        if (device.valid()) found[device] = false;
      }
    }
    return found;
  }

  void around_device(DeviceId device) {
    for (const ChannelId c : problem_.channels.ids()) {
      const Channel& of = problem_.channels[c];
      const bool its = of.sender_device == device || (of.receiver_device == device && of.served);
      if (!its) continue;
      keep_if(Hold::loose,
              [c](const ThreadTalk& talk) { return talk.sends.contains(c) || talk.waits.contains(c); });
    }
  }

  const Problem& problem_;
  const Requirement& requirement_;
  Reach reach_;
  Watch watch_;
  Table<ThreadId, ThreadTalk> talk_;
  Table<ThreadId, Hold> hold_;
  Table<DeviceId, bool> devices_;
  std::vector<std::pair<ThreadId, Table<ThreadId, bool>>> echoes_;
  bool changed_ = false;
};

}  // namespace

bool Cone::whole() const {
  const auto all = [](const auto& of) { return std::find(of.begin(), of.end(), false) == of.end(); };
  return all(threads) && all(devices);
}

Cone cone_of(const Problem& problem, const Requirement& requirement, ProcessorId processor, Reach reach) {
  if (requirement.measure == Measure::load)
    return {Table<ThreadId, bool>(problem.threads.size(), true),
            Table<DeviceId, bool>(problem.devices.size(), true),
            Table<DeviceId, bool>(problem.devices.size(), false)};
  return Finder(problem, requirement, processor, reach).find();
}

}  // namespace pal::analyzer
