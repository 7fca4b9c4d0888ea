// The cell at work on one operation or one skill, and what clients see of it meanwhile.
#include "runtime_system/private/desk_parts.hpp"

namespace pal::runtime_system {

void Desk::Parts::change_between() {
  for (auto& [change, answer] : std::exchange(between, {})) {
    Reply reply = Done{};
    try {
      change();
    } catch (const operations::ExecutionError& problem) {
      reply = wrong(problem.what());
    }
    answer(reply);
  }
}

void Desk::Parts::arrives(const std::string& icon) {
  sink.make_room();
  const std::lock_guard lock(mutex);
  change_between();
  status.token = icon;
  status.time = runner.now();
  publish(IconReached{icon});
}

void Desk::Parts::begins(const operations::Step& step) {
  const std::lock_guard lock(mutex);
  status.time = step.begin;
  status.steps = step.number;
  publish(StepBegins{step});
}

void Desk::Parts::done(const operations::Step& step) {
  if (options.log != nullptr) options.log->done(step);
  const std::lock_guard lock(mutex);
  status.time = step.end;
  if (step.has_code()) status.last_code = step.result.code;
  publish(StepEnds{step});
}

void Desk::Parts::work_on(const OperationJob& job) {
  executor->allow();
  // What was asked for after the command had been accepted holds; allow() may just have forgotten it.
  {
    const std::lock_guard lock(mutex);
    if (stops != accepted_stops) executor->stop();
    if (pauses != accepted_pauses) executor->pause();
  }
  if (job.steps > 0) {
    executor->run(job.steps);
  } else {
    executor->run();
  }
  const std::lock_guard lock(mutex);
  change_between();
  status.activity = Activity::idle;
  status.time = runner.now();
  look_at_executor();
  publish_state();
}

void Desk::Parts::work_on(const SkillJob& job) {
  runner.allow();
  operations::Step step{++alone, {}, job.command.skill, job.command.parameters, {}, runner.now(), {}};
  {
    const std::lock_guard lock(mutex);
    if (stops != accepted_stops) runner.stop();
    status.time = step.begin;
    publish(StepBegins{step});
  }
  step.result = runner.run(job.command.skill, job.command.parameters);
  step.end = runner.now();
  if (options.log != nullptr) options.log->done(step);
  {
    const std::lock_guard lock(mutex);
    status.activity = Activity::idle;
    status.time = step.end;
    publish(StepEnds{step});
  }
  job.answer(Done{step.result, step.begin, step.end});
}

}  // namespace pal::runtime_system
