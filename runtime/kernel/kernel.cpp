#include "runtime/kernel/kernel.hpp"

#include "runtime/kernel/thrown.hpp"

namespace pal::runtime {

using State = ThreadControl::State;

Kernel::Kernel(const Clock& clock, Executive& the_executive, Journal& the_journal, Skill& skill,
               const std::vector<Connection>& connections, const RunOptions& options)
    : executive(the_executive),
      journal(the_journal),
      promises(clock, journal, skill, options),
      flow(executive, journal, skill),
      mail(executive, journal, flow, devices, promises, skill.wiring()),
      blocks(executive, journal, flow, mail, threads_),
      conditions(journal, skill.wiring().conditions.size()),
      devices(executive, journal, mail, promises, options.observer, skill.wiring(), connections),
      wiring(skill.wiring()),
      skill_(skill),
      work_(options.work) {
  for (std::size_t d = 0; d < connections.size(); ++d) {
    const std::vector<int>& channels = connections[d].channels;
    for (std::size_t port = 0; port < channels.size(); ++port) {
      if (channels[port] >= 0) mail.connect(channels[port], static_cast<int>(d), port);
    }
  }
  for (std::size_t i = 0; i < wiring.threads.size(); ++i)
    threads_.emplace_back(*this, static_cast<int>(i), wiring.threads[i], wiring.conditions.size());
}

void Kernel::start() {
  if (!devices.attach()) return;
  try {
    skill_.start();
  } catch (const ParameterError& refused) {
    journal.fail(refused.what());
    return;
  } catch (...) {
    journal.fail("starting the skill: " + what_was_thrown());
    return;
  }
  for (Thread& thread : threads_) {
    thread.control.task = skill_.body(static_cast<std::size_t>(thread.control.index), thread);
    if (!thread.control.task) {
      journal.fail("the skill has no body for its thread " + std::string(thread.control.spec->name));
      return;
    }
  }
  if (!threads_.empty()) skill_.reserve_executed(threads_.front());
  for (Thread& thread : threads_) {
    if (thread.control.spec->parent < 0) flow.begin(thread);
  }
  settle();
}

void Kernel::happen(Due due) {
  switch (due.kind) {
    case Due::Kind::message_available:
      mail.message_available(due.subject);
      break;
    case Due::Kind::wait_expired:
      mail.wait_expired(threads_[static_cast<std::size_t>(due.subject)]);
      break;
    case Due::Kind::request_arrives:
      mail.request_arrives(due.subject);
      break;
  }
}

std::vector<std::string> Kernel::places() const {
  std::vector<std::string> result;
  for (const Thread& thread : threads_) {
    const State state = thread.control.state;
    if (state != State::idle && state != State::ended) result.push_back(journal.place_of(thread));
  }
  return result;
}

bool Kernel::awaits_device() const {
  const auto channel = [this](int index) -> const ChannelSpec& {
    return wiring.channels[static_cast<std::size_t>(index)];
  };
  for (const Thread& thread : threads_) {
    const ThreadControl& control = thread.control;
    if (control.sending != nullptr && channel(control.sending->channel()).to_device) return true;
    if (control.waiting == nullptr) continue;
    for (const Target& target : control.waiting->targets())
      if (channel(target.channel).from_device) return true;
  }
  return false;
}

std::string Kernel::who_waits() const {
  std::string text;
  for (const std::string& place : places()) text += (text.empty() ? ": " : ", ") + place;
  return text;
}

}  // namespace pal::runtime
