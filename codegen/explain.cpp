#include "codegen/explain.hpp"

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

namespace pal::codegen {

namespace {

using Row = std::vector<std::string>;
using Kind = PlannedStatement::Kind;

/// Rows in columns, each as wide as its widest cell; nothing behind the last.
void write(const std::vector<Row>& rows, std::ostream& out) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  for (const Row& row : rows) {
    std::string line = " ";
    for (std::size_t c = 0; c < row.size(); ++c)
      line += ' ' + row[c] + std::string(widths[c] - row[c].size() + 1, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

void section(const char* heading, const std::vector<Row>& rows, const char* none, std::ostream& out) {
  out << '\n' << heading << '\n';
  if (rows.empty()) out << "  " << none << '\n';
  write(rows, out);
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

/// A request whose answer the next statement does not wait for.
struct Courier {
  std::size_t channel = 0;
  std::string sender;     // of the module
  std::string meanwhile;  // the statement that comes first
  int line = 0;           // of the request
};

bool waits_for(const PlannedStatement& statement, std::size_t channel) {
  return statement.kind == Kind::wait &&
         std::any_of(statement.ends.begin(), statement.ends.end(),
                     [channel](const PlannedEnd& end) { return end.channel == channel; });
}

/// What a thread does first that comes to `statement`: REPEAT itself does nothing.
const PlannedStatement* first_of(const PlannedStatement* statement) {
  while (statement != nullptr && statement->kind == Kind::loop)
    statement = statement->branches.front().empty() ? nullptr : &statement->branches.front().front();
  return statement;
}

class CourierSearch {
 public:
  explicit CourierSearch(const Plan& plan) : plan_(plan) {}

  std::vector<Courier> find() {
    for (const PlannedModule& module : plan_.modules) look(module, module.body, nullptr);
    return std::move(found_);
  }

 private:
  /// `after`: what comes behind the body.
  void look(const PlannedModule& module, const PlannedBody& body, const PlannedStatement* after) {
    for (std::size_t s = 0; s < body.size(); ++s) {
      const PlannedStatement& statement = body[s];
      const PlannedStatement* next = first_of(s + 1 < body.size() ? &body[s + 1] : after);
      for (const PlannedBody& branch : statement.branches) {
        const bool again = statement.kind == Kind::loop && !branch.empty();
        const bool ends = statement.kind == Kind::concurrent;
        look(module, branch, again ? &branch.front() : ends ? nullptr : next);
      }
      if (statement.kind != Kind::send) continue;
      const std::size_t channel = statement.ends.front().channel;
      const std::optional<std::size_t> answer = plan_.channels[channel].answer;
      if (!answer || (next != nullptr && waits_for(*next, *answer))) continue;
      found_.push_back(
          {channel, module.pal_name, next == nullptr ? std::string("the end") : next->pal, statement.line});
    }
  }

  const Plan& plan_;
  std::vector<Courier> found_;
};

std::string processor_of(const Plan& plan, const PlannedThread& thread) {
  return plan.environment.processors[thread.processor].name;
}

std::vector<Row> thread_rows(const Plan& plan, std::size_t processor) {
  std::vector<const PlannedThread*> threads;
  for (const PlannedThread& thread : plan.threads) {
    if (thread.processor == processor) threads.push_back(&thread);
  }
  std::stable_sort(threads.begin(), threads.end(),
                   [](const auto* a, const auto* b) { return a->priority > b->priority; });
  std::vector<Row> rows;
  for (const PlannedThread* thread : threads) {
    rows.push_back({"  " + thread->pal_name, "priority " + std::to_string(thread->priority),
                    thread->parent ? "block, begun by " + plan.threads[*thread->parent].pal_name
                                   : plan.modules[thread->module].kind});
  }
  return rows;
}

void write_processors(const Plan& plan, std::ostream& out) {
  out << "\nprocessors, and their threads by priority\n";
  for (std::size_t p = 0; p < plan.environment.processors.size(); ++p) {
    const pan::Processor& processor = plan.environment.processors[p];
    const std::vector<Row> rows = thread_rows(plan, p);
    out << "  " << processor.name << (processor.preemptive ? "" : ", not preemptive")
        << (rows.empty() ? ": no thread of this skill" : "") << '\n';
    write(rows, out);
  }
}

std::vector<Row> executed_rows(const Plan& plan) {
  std::vector<Row> rows;
  for (const PlannedModule& module : plan.modules) {
    if (!module.executed) continue;
    std::string threads;
    for (const std::size_t runner : module.runners)
      threads += (threads.empty() ? "" : ", ") + plan.threads[runner].pal_name;
    rows.push_back({module.pal_name, module.kind, "in " + (threads.empty() ? "no thread" : threads)});
  }
  return rows;
}

std::string place(const Plan& plan, const std::string& party) {
  for (const PlannedThread& thread : plan.threads) {
    if (thread.pal_name == party) return "on " + processor_of(plan, thread);
  }
  return "device";
}

std::vector<Row> server_rows(const Plan& plan) {
  std::vector<Row> rows;
  for (const PlannedChannel& channel : plan.channels) {
    if (!channel.request || !channel.answer) continue;
    rows.push_back({channel.receiver, place(plan, channel.receiver),
                    "gives " + plan.channels[*channel.answer].message, "to " + channel.sender});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a[0] < b[0]; });
  return rows;
}

std::vector<Row> courier_rows(const Plan& plan) {
  std::vector<Row> rows;
  for (const Courier& courier : CourierSearch(plan).find()) {
    const PlannedChannel& channel = plan.channels[courier.channel];
    const std::string line = courier.line > 0 ? ", line " + std::to_string(courier.line) : "";
    rows.push_back({channel.message, "from " + courier.sender + line, "to " + channel.receiver,
                    "meanwhile " + courier.meanwhile});
  }
  return rows;
}

std::vector<Row> channel_rows(const Plan& plan) {
  std::vector<Row> rows;
  for (const PlannedChannel& channel : plan.channels) {
    rows.push_back({channel.message, "from " + channel.sender, "to " + channel.receiver,
                    channel.fields ? plan.messages[*channel.fields].type : std::string("no fields"),
                    channel.request ? "request" : ""});
  }
  return rows;
}

std::vector<Row> device_rows(const Plan& plan) {
  std::vector<Row> rows;
  for (const PlannedDevice& device : plan.device_classes) {
    std::string takes, sends;
    for (const PlannedDevice::Port& port : device.ports) {
      std::string& list = port.to_device ? takes : sends;
      list += (list.empty() ? "" : ", ") + port.message;
    }
    rows.push_back({device.pal_name, device.type, takes.empty() ? "takes nothing" : "takes " + takes,
                    sends.empty() ? "sends nothing" : "sends " + sends});
  }
  return rows;
}

}  // namespace

void explain(const Plan& plan, std::ostream& out) {
  out << "skill " << plan.skill.name << " in environment " << plan.environment.name << ": "
      << counted(plan.threads.size(), "thread") << ", " << counted(plan.channels.size(), "channel") << ", "
      << counted(plan.statements.size(), "statement") << '\n';
  write_processors(plan, out);
  const std::vector<Row> executed = executed_rows(plan);
  if (!executed.empty()) section("modules without a thread of their own, by Execute", executed, "", out);
  section("servers", server_rows(plan), "none: no module answers a request", out);
  section("couriers: requests under way while their sender goes on", courier_rows(plan),
          "none: each answer is waited for right after its request", out);
  section("channels, each a slot for one message", channel_rows(plan), "none", out);
  section("devices, and the classes to derive from", device_rows(plan), "none", out);
}

}  // namespace pal::codegen
