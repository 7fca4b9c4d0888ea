#include "runtime/kernel/journal.hpp"

#include <utility>

#include "runtime/kernel/thrown.hpp"

namespace pal::runtime {

using trace::Kind;

Journal::Journal(const Clock& clock, const Skill& skill, const RunOptions& options)
    : clock_(clock),
      skill_(skill),
      recorder_(skill.wiring(), options.trace, options.trace_capacity, options.spool),
      live_(options.live),
      kept_(options.trace != TraceMode::none ? EventRoutes::all_kinds : 0) {
  routes_changed();
}

void Journal::overrun(int device, int channel) {
  ++outcome_.overruns;
  record_device(Kind::overrun, device, channel);
}

int Journal::error_code() const {
  for (const CompletionSpec& completion : skill_.description().completions) {
    if (completion.kind == CompletionSpec::Kind::error) return completion.code;
  }
  return -1;
}

void Journal::complete(const Thread& thread, int code) {
  if (over_) return;
  record(Kind::complete, thread, -1, code);
  if (over_) return;  // it breaks a promise, and that stops the skill
  record(Kind::done, thread);
  end();
  outcome_.code = code;
}

void Journal::fail_at(int actor, int statement, const std::string& reason) {
  if (over_) return;
  end();
  outcome_.fault = true;
  outcome_.code = error_code();
  outcome_.reason = reason;
  write(Kind::fault, actor, statement, -1, recorder_.add_fault(reason));
  write(Kind::complete, actor, statement, -1, outcome_.code);
}

void Journal::fail(const Thread& thread, const std::string& reason) {
  const Operation* operation = thread.control.operation;
  fail_at(thread.control.index, operation == nullptr ? -1 : operation->statement(),
          place_of(thread) + ": " + reason);
}

void Journal::fail_device(int device, const std::string& reason) {
  fail_at(actor_of_device(device), -1, reason);
}

void Journal::fail_by_exception(const Thread& thread) {
  fail(thread, what_was_thrown());
}

void Journal::fail_to_close(const std::string& device, const std::string& reason) {
  outcome_.fault = true;
  outcome_.code = error_code();
  outcome_.reason += (outcome_.reason.empty() ? "closing " : "; closing ") + device + ": " + reason;
}

std::string Journal::place_of(const Thread& thread) const {
  const Operation* operation = thread.control.operation;
  if (operation == nullptr) return std::string(thread.control.spec->name);
  const StatementSpec& statement =
      skill_.wiring().statements[static_cast<std::size_t>(operation->statement())];
  return std::string(thread.control.spec->name) + " at " + std::string(statement.text) + " (" +
         std::string(statement.file) + ":" + std::to_string(statement.line) + ")";
}

Outcome Journal::take() {
  for (const CompletionSpec& completion : skill_.description().completions) {
    if (!outcome_.fault && completion.code == outcome_.code) outcome_.reason = completion.description;
  }
  outcome_.duration = clock_.now;
  outcome_.trace = recorder_.take();
  return std::move(outcome_);
}

}  // namespace pal::runtime
