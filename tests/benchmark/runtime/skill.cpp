#include <stdexcept>

#include "pal/runtime/dispatcher.hpp"
#include "tests/benchmark/runtime/rows.hpp"
#include "tests/run/support/written_skill.hpp"

namespace pal::benchmark {
namespace {

using namespace std::chrono_literals;
using runtime::from;
using runtime::Task;
using runtime::Thread;

class Still final : public runtime::World {
 public:
  void advance_to(runtime::Time) override {}
};

}  // namespace

void skill_round_trips(std::size_t count, std::size_t threads, runtime::TraceMode trace) {
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
  Still world;
  runtime::RunOptions options;
  options.trace = trace;
  if (trace == runtime::TraceMode::last) options.trace_capacity = 4096;
  const runtime::Outcome outcome = runtime::Dispatcher({}, world).run(skill, {}, options);
  if (outcome.code != 0) throw std::runtime_error(outcome.reason);
}

}  // namespace pal::benchmark
