// The cell's thread at work: skills alone, operations, and the questions that they ask.
#include <algorithm>

#include "operations/missing_value.hpp"
#include "server/desk_parts.hpp"

namespace pal::server {

operations::Reading AskingRunner::sense(const std::string& sensor) {
  operations::Reading reading = runner_.sense(sensor);
  if (!reading.value) return reading;
  const Locked lock(desk_);
  desk_.readings[sensor] = {*reading.value, runner_.now()};
  return reading;
}

void AskingRunner::ask(const operations::Question& question) {
  const Locked lock(desk_);
  desk_.set_time(runner_.now());
  desk_.answer.reset();
  desk_.status.question = OpenQuestion{question, runner_.now(), std::chrono::system_clock::now()};
  desk_.publish(QuestionAsked{*desk_.status.question});
}

operations::Reply AskingRunner::answer() {
  // The runner itself has nobody to ask, but knows whether it was stopped.
  if (runner_.answer().stopped) return {{}, {}, true};
  std::unique_lock lock(desk_.mutex);
  desk_.set_time(runner_.now());
  if (desk_.options.answer_wait.count() > 0)
    desk_.answered.wait_for(lock, desk_.options.answer_wait, [this] {
      return desk_.answer.has_value() || desk_.ending || desk_.status.stopping || desk_.status.pausing;
    });
  return {desk_.answer, {}, false};
}

void AskingRunner::withdraw() {
  const Locked lock(desk_);
  if (!desk_.status.question) return;
  const operations::Question question = desk_.status.question->question;
  desk_.status.question.reset();
  std::optional<std::string> said;
  if (desk_.answer) said = question.answers[*desk_.answer];
  desk_.publish(QuestionClosed{question.icon, said, said ? desk_.answered_by : ""});
  desk_.answer.reset();
}

void Desk::Parts::begin(Activity activity) {
  status.activity = activity;
  status.pausing = status.stopping = false;
  accepted_stops = stops;
  accepted_pauses = pauses;
  changed.notify_all();
}

void Desk::Parts::note_begin(RunRecord::Kind kind, const std::string& name, ClientId client) {
  if (options.runs == nullptr) return;
  RunRecord record;
  record.kind = kind;
  record.name = name;
  record.begun = std::chrono::system_clock::now();
  record.begin = time_now();
  record.by = name_of(client);
  std::optional<std::string> text;
  if (kind == RunRecord::Kind::operation && loaded) {
    const auto main = loaded->files.find(loaded->main);
    if (main != loaded->files.end()) text = main->second;
  }
  status.run = options.runs->begin(std::move(record), std::move(text));
  if (options.recording != nullptr) options.recording->begin(status.run, time_now());
}

void Desk::Parts::note_step(const operations::Step& step) {
  if (options.runs == nullptr) return;
  std::vector<operations::Parameter> all = step.parameters;
  const auto skill = cell.skills->find(step.skill);
  if (skill != cell.skills->end())
    for (const pan::Parameter& each : skill->second.parameters)
      if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return one.name == each.name; }))
        all.push_back({each.name, operations::default_of(each), {}, {}});
  options.runs->step(status.run, step, std::move(all));
}

void Desk::Parts::note_end(const std::string& state, std::optional<int> code, const std::string& reason) {
  if (options.runs == nullptr) return;
  options.runs->change(status.run, state, time_now(), code, reason);
  if (options.recording != nullptr) options.recording->end(time_now());
}

void Desk::Parts::change_between() {
  for (auto& [change, reply_to] : std::exchange(between, {})) {
    Reply reply;
    try {
      reply = change();
    } catch (const operations::ExecutionError& problem) {
      reply = Refusal{Refusal::Why::wrong, problem.what()};
    }
    if (reply_to)
      answers.emplace_back([reply_to = std::move(reply_to), reply = std::move(reply)] { reply_to(reply); });
  }
}

void Desk::Parts::arrives(const std::string& icon) {
  sink.make_room();
  if (options.runs != nullptr) options.runs->make_room();
  const Locked lock(*this);
  change_between();
  status.token = icon;
  set_time(runner.now());
  here = Here{icon, time_now(), std::chrono::system_clock::now()};
  IconState& state = icons[icon];
  ++state.visits;
  state.reason.clear();
  state.took.reset();
  state.last = time_now();
  publish(IconReached{icon});
}

void Desk::Parts::begins(const operations::Step& step) {
  const Locked lock(*this);
  set_time(step.begin);
  status.steps = step.number;
  status.running = Running{step, std::chrono::system_clock::now(), false};
  publish(StepBegins{step});
}

void Desk::Parts::done(const operations::Step& step) {
  if (options.log != nullptr) options.log->done(step);
  const Locked lock(*this);
  set_time(step.end);
  status.running.reset();
  cut_off = step.result.kind == operations::SkillResult::Kind::stopped;
  if (!cut_off) step_before = step.icon;
  IconState& state = icons[step.icon];
  state.kind = step.result.kind;
  state.reason = step.result.reason;
  state.took = step.end - step.begin;
  if (step.has_code()) state.code = step.result.code;
  if (step.result.kind == operations::SkillResult::Kind::normal) ++state.ends;
  if (step.has_code()) status.last_code = step.result.code;
  note_step(step);
  publish(StepEnds{step});
}

void Desk::Parts::work_on(const OperationJob& job) {
  executor->allow();
  // What was asked for after the command had been accepted holds; allow() may just have forgotten it.
  {
    const Locked lock(*this);
    if (stops != accepted_stops) executor->stop();
    if (pauses != accepted_pauses) executor->pause();
  }
  if (job.steps > 0) {
    executor->run(job.steps);
  } else {
    executor->run();
  }
  const Locked lock(*this);
  change_between();
  status.activity = Activity::idle;
  status.pausing = status.stopping = false;
  status.running.reset();
  set_time(runner.now());
  look_at_executor();
  note_end(operations::name(status.state),
           status.state == operations::ExecutionState::ended ? std::optional(status.last_code) : std::nullopt,
           status.reason);
  publish_state();
}

void Desk::Parts::work_on(SkillJob& job) {
  runner.allow();
  operations::Step step{++alone, {}, job.command.skill, job.command.parameters, {}, runner.now(), {}};
  {
    const Locked lock(*this);
    if (stops != accepted_stops) runner.stop();
    set_time(step.begin);
    status.running = Running{step, std::chrono::system_clock::now(), true};
    publish(StepBegins{step});
  }
  step.result = runner.run(job.command.skill, job.command.parameters, std::nullopt);
  step.end = runner.now();
  if (options.log != nullptr) options.log->done(step);
  {
    const Locked lock(*this);
    status.activity = Activity::idle;
    status.pausing = status.stopping = false;
    status.running.reset();
    stops_without.reset();
    jogs.reset();
    set_time(step.end);
    note_step(step);
    using Kind = operations::SkillResult::Kind;
    note_end(step.result.kind == Kind::stopped ? "stopped"
             : step.result.kind == Kind::error ? "failed"
                                               : "ended",
             step.result.code, step.result.reason);
    publish(StepEnds{step});
  }
  Done result;
  result.result = step.result;
  result.begin = step.begin;
  result.end = step.end;
  job.answer(result);
}

}  // namespace pal::server
