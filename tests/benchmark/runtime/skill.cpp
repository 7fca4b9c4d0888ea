#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "pal/runtime/dispatcher.hpp"
#include "pal/runtime/still_world.hpp"
#include "tests/benchmark/runtime/rows.hpp"
#include "tests/run/support/written_skill.hpp"

namespace pal::benchmark {
namespace {

using namespace std::chrono_literals;
using runtime::from;
using runtime::Task;
using runtime::Thread;

void run_to_end(test::WrittenSkill& skill, runtime::TraceMode trace) {
  runtime::StillWorld world;
  runtime::RunOptions options;
  options.trace = trace;
  if (trace == runtime::TraceMode::last) options.trace_capacity = 4096;
  const runtime::Outcome outcome = runtime::Dispatcher({}, world).run(skill, {}, options);
  if (outcome.code != 0) throw std::runtime_error(outcome.reason);
}

}  // namespace

void skill_round_trips(std::size_t count, std::size_t threads, runtime::TraceMode trace,
                       std::size_t requirements) {
  test::WrittenSkill skill;
  const int processor = skill.processor("P");
  const int others = skill.processor("Q");
  const int request = skill.channel("CLIENT", "request x", "SERVER");
  const int answer = skill.channel("SERVER", "x", "CLIENT");
  const int never = skill.channel("CLIENT", "never", "IDLE");
  skill.channels[static_cast<std::size_t>(request)].answer = answer;
  const int send = skill.statement("TXM( request x from SERVER )", 1us);
  const int receive = skill.statement("WTM( x from SERVER )", 1us);
  const int accept = skill.statement("WTM( request x from CLIENT )", 1us);
  const int reply = skill.statement("TXM( x to CLIENT )", 1us);
  const int wait = skill.statement("WTM( never from CLIENT )", 1us);
  const int end = skill.statement("TXM( Completion Protocol 0 )", 1us);
  skill.thread("CLIENT", processor, 1, [&](Thread& thread) -> Task {
    for (std::size_t i = 0; i < count; ++i) {
      co_await thread.send(send, request);
      co_await thread.wait(receive, from(answer));
    }
    co_await thread.complete(end, 0);
  });
  skill.thread("SERVER", processor, 2, [&](Thread& thread) -> Task {
    for (;;) {
      co_await thread.wait(accept, from(request));
      co_await thread.send(reply, answer);
    }
  });
  for (std::size_t i = 2; i < threads; ++i)
    skill.thread("IDLE", i % 2 == 0 ? processor : others, 3,
                 [&](Thread& thread) -> Task { co_await thread.wait(wait, from(never)); });
  const int requests[] = {request}, answers[] = {answer}, sends[] = {send}, receives[] = {receive},
            accepts[] = {accept}, replies[] = {reply}, both[] = {receive, reply}, of_all[] = {0, 1};
  using Measure = runtime::RequirementSpec::Measure;
  const auto require = [&](Measure measure, std::span<const int> channels, std::span<const int> at) {
    runtime::RequirementSpec& spec = skill.requirements.emplace_back();
    spec.name = "watched";
    spec.measure = measure;
    spec.most = 1s;
    spec.channels = channels;
    spec.at = at;
    spec.threads = of_all;
  };
  const auto response = [&](std::span<const int> channels, std::span<const int> at) {
    require(Measure::response, channels, at);
  };
  const auto interval = [&](std::span<const int> at) { require(Measure::interval, {}, at); };
  response(requests, receives);
  interval(sends);
  response(requests, replies);
  interval(receives);
  response(answers, receives);
  interval(accepts);
  response(requests, accepts);
  interval(both);
  skill.requirements.resize(requirements);
  run_to_end(skill, trace);
}

void skill_starts(std::size_t count, std::size_t threads, bool blocks) {
  test::WrittenSkill skill;
  const int processor = skill.processor("P");
  const int act = skill.statement("act", 1us);
  const int fork = skill.statement("CONCURRENT");
  const int end = skill.statement("TXM( Completion Protocol 0 )", 1us);
  std::vector<std::string> names(threads);
  for (std::size_t i = 0; i < threads; ++i) names[i] = "T" + std::to_string(i);
  const auto once = [&](Thread& thread) -> Task { co_await thread.perform(act, [] {}); };
  const auto ends = [&](Thread& thread) -> Task { co_await thread.complete(end, 0); };
  if (blocks) {
    std::vector<int> all(threads);
    struct All final : runtime::ConcurrentOperation {
      All(Thread& thread, int statement, const std::vector<int>& of)
          : ConcurrentOperation(thread, statement), all(of) {}
      std::span<const int> blocks() const override { return all; }
      const std::vector<int>& all;
    };
    const int parent = skill.thread("A", processor, 1, [&](Thread& thread) -> Task {
      co_await All(thread, fork, all);
      co_await thread.complete(end, 0);
    });
    for (std::size_t i = 0; i < threads; ++i)
      all[i] = skill.block(names[i], parent, processor, static_cast<int>(i % 7), true, once);
    for (std::size_t done = 0; done < count; done += threads) run_to_end(skill, runtime::TraceMode::none);
    return;
  }
  for (std::size_t i = 0; i < threads; ++i)
    skill.thread(names[i], processor, static_cast<int>(i % 7) + 1, once);
  skill.thread("Z", processor, 0, ends);
  for (std::size_t done = 0; done < count; done += threads) run_to_end(skill, runtime::TraceMode::none);
}

}  // namespace pal::benchmark
