// The threads that have the processors, and those that begin, wait, end and are stopped.
#include "tests/support/runs/all_runs.hpp"

#include <algorithm>

namespace pal::test {

using namespace pan;
using namespace runs;

void AllRuns::reach(int thread) {
  Thread& of = s_.threads[ix(thread)];
  of.begun = false;
  of.claim = -1;
  of.gives_up = of.withdrawn = false;
  follow_loops();
  const auto& content = node(of).content;
  if (std::holds_alternative<Fork>(content)) {
    begin_blocks(thread);
    return;
  }
  const auto* wait = std::get_if<Wait>(&content);
  if (wait == nullptr) {
    ready(thread);
    return;
  }
  for (ChannelId channel : wait->channels) {
    if (sender_process_[channel.index()] >= 0) open(sender_process_[channel.index()]);
  }
  for (std::size_t i = 0; i < wait->channels.size(); ++i) {
    const int channel = wait->channels[i].value;
    if (!available(channel, thread)) continue;
    s_.slots[ix(channel)].claimed = thread;
    of.claim = static_cast<int>(i);
    ready(thread);
    return;
  }
  if (wait->within && wait->within->count() == 0) {
    say(who(thread) + " gives up at once");
    of.gives_up = true;
    ready(thread);
    return;
  }
  release(thread);
  of.status = Status::waiting;
  of.limit = wait->within ? static_cast<int>(*wait->within / unit_) : -1;
}

void AllRuns::ready(int thread) {
  Thread& of = s_.threads[ix(thread)];
  of.begun = false;
  of.limit = -1;
  if (of.status == Status::running) return;
  of.status = Status::ready;
  s_.queues[ix(of.processor)].push_back(thread);
}

void AllRuns::unqueue(int thread) {
  for (auto& queue : s_.queues) std::erase(queue, thread);
}

void AllRuns::release(int thread) {
  Thread& of = s_.threads[ix(thread)];
  if (s_.running[ix(of.processor)] == thread) s_.running[ix(of.processor)] = -1;
  unqueue(thread);
}

void AllRuns::finished(int thread) {
  say(who(thread) + " ends");
  release(thread);
  const int parent = s_.threads[ix(thread)].parent;
  s_.threads[ix(thread)] = Thread{};
  follow_loops();
  if (parent < 0) return;
  hand_over(thread, parent);
  block_over(parent, false);
}

void AllRuns::begin_blocks(int thread) {
  release(thread);
  s_.threads[ix(thread)].status = Status::joining;
  const Node& fork = node(s_.threads[ix(thread)]);
  const auto [module, at] = s_.threads[ix(thread)].at.back();
  std::vector<int> blocks;
  for (std::size_t i = 0; i < fork.out.size(); ++i) {
    Thread made;
    // The block's own path: where its CONCURRENT stands, marked by -1, so that an END leads no further.
    std::vector<std::pair<int, int>> path = s_.threads[ix(thread)].at;
    path.push_back({static_cast<int>(i), -2});
    const auto [found, fresh] =
        known_threads_.try_emplace({thread, path}, static_cast<int>(known_threads_.size()));
    const int index = found->second;
    // A block of the module that its parent executes; or, as its parent, of one that a thread above runs.
    const bool runs = s_.threads[ix(thread)].at.size() > 1 || s_.threads[ix(thread)].parent < 0;
    const int runner = runs ? thread : runners_.at(thread);
    const std::string before = s_.threads[ix(runner)].parent < 0 ? "" : names_.at(runner) + "/";
    const std::string name =
        before + network_.modules[ix(module)].threads[std::get<Fork>(fork.content).threads[i]];
    names_[index] = name;
    runners_[index] = runner;
    made.at = {{module, fork.out[i].value}};
    made.module = s_.threads[ix(thread)].module;
    made.parent = thread;
    made.carries = s_.threads[ix(thread)].carries;
    made.can_end = ahead(module, fork.out[i].value).ends;
    place(made, name, runner);
    made.status = Status::ready;
    if (s_.threads.size() <= ix(index)) s_.threads.resize(ix(index) + 1);
    s_.threads[ix(index)] = made;
    blocks.push_back(index);
  }
  s_.threads[ix(thread)].blocks = blocks;
  for (int block : blocks) {
    if (!s_.ended && s_.threads[ix(block)].status == Status::ready && !s_.threads[ix(block)].at.empty())
      walk_on(block);
  }
}

/// After one that was stopped the parent goes on before or after the other threads that go on by that.
void AllRuns::block_over(int parent, bool stopped) {
  if (s_.threads[ix(parent)].status != Status::joining) return;
  const std::vector<int> blocks = s_.threads[ix(parent)].blocks;
  bool alive = false;
  bool goes_on = false;
  for (int block : blocks) {
    const Thread& of = s_.threads[ix(block)];
    if (of.status == Status::off) continue;
    alive = true;
    goes_on = goes_on || of.can_end;
  }
  if (!alive) {
    Thread& of = s_.threads[ix(parent)];
    of.blocks.clear();  // it is there, and has none
    if (of.cancelled) {
      stop(parent);
      return;
    }
    say(who(parent) + " goes on");
    if (!stopped) return proceed(parent, 0);
    const int turn = of.turn = ++turns_;
    later([this, parent, turn] {
      if (s_.threads[ix(parent)].turn == turn) proceed(parent, 0);
    });
    return;
  }
  if (goes_on || s_.threads[ix(parent)].cancelled) return;
  // All that could end have; some block has ended, so one could.
  std::vector<int> rest;
  for (int block : blocks) {
    if (s_.threads[ix(block)].status != Status::off && !s_.threads[ix(block)].cancelled)
      rest.push_back(block);
  }
  any_order(rest, [this](int block) {
    if (s_.threads[ix(block)].status != Status::off && !s_.threads[ix(block)].cancelled) cancel(block);
  });
}

void AllRuns::cancel(int thread) {
  Thread& of = s_.threads[ix(thread)];
  of.cancelled = true;
  if (of.status == Status::joining && !of.blocks.empty()) {
    const std::vector<int> blocks = of.blocks;
    std::vector<int> rest;
    for (int block : blocks) {
      if (s_.threads[ix(block)].status != Status::off && !s_.threads[ix(block)].cancelled)
        rest.push_back(block);
    }
    any_order(rest, [this](int block) {
      if (s_.threads[ix(block)].status != Status::off && !s_.threads[ix(block)].cancelled) cancel(block);
    });
    return;
  }
  const bool finishes = of.begun && (of.status == Status::running || of.status == Status::ready);
  if (!finishes) stop(thread);
}

void AllRuns::stop(int thread) {
  say(who(thread) + " is stopped");
  release(thread);
  const Thread was = s_.threads[ix(thread)];
  s_.threads[ix(thread)].status = Status::off;
  std::vector<int> left;  // -1: the message that was its own; channels of its open requests
  const auto* wait = was.at.empty() ? nullptr : std::get_if<Wait>(&node(was).content);
  if (wait != nullptr && was.claim >= 0 && !was.withdrawn) left.push_back(-1);
  for (std::size_t c = 0; c < s_.slots.size(); ++c) {
    if (belongs_to(static_cast<int>(c), thread)) left.push_back(static_cast<int>(c));
  }
  s_.threads[ix(thread)] = Thread{};
  follow_loops();
  std::vector<int> all_freed;
  any_order(left, [&](int which) {
    if (which >= 0) {
      withdraw(which, thread, all_freed);
      return;
    }
    const int channel = wait->channels[ix(was.claim)].value;
    if (s_.slots[ix(channel)].claimed != thread) return;
    s_.slots[ix(channel)].claimed = -1;
    comes_to_its_queue(claim(channel));
  });
  for (int channel : all_freed) {
    if (somebody_sends(channel)) later([this, channel] { emptied(channel); });
  }
  if (was.parent >= 0) block_over(was.parent, true);
}

void AllRuns::dispatch() {
  for (std::size_t p = 0; p < environment_.processors.size(); ++p) {
    auto& queue = s_.queues[p];
    int best = -1;
    for (int thread : queue) {
      if (best < 0 || s_.threads[ix(thread)].priority > s_.threads[ix(best)].priority) best = thread;
    }
    int& running = s_.running[p];
    if (running >= 0 && best >= 0 && environment_.processors[p].preemptive &&
        s_.threads[ix(best)].priority > s_.threads[ix(running)].priority) {
      say(who(running) + " is preempted");
      s_.threads[ix(running)].status = Status::ready;
      queue.insert(queue.begin(), running);
      running = -1;
    }
    if (running < 0 && best >= 0) {
      std::erase(queue, best);
      running = best;
      s_.threads[ix(best)].status = Status::running;
    }
    if (running >= 0 && !s_.threads[ix(running)].begun) {
      Thread& of = s_.threads[ix(running)];
      of.begun = true;
      of.left = draw(cost_of(of));
      say(who(running) + " begins node " + std::to_string(of.at.back().second) + " for " +
          std::to_string(of.left));
    }
  }
}

}  // namespace pal::test
