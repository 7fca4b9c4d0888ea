// A plan as text, for golden tests.
#include <ostream>

#include "codegen/plan.hpp"
#include "codegen/writer.hpp"
#include "pal/pan/dump.hpp"

namespace pal::codegen {

namespace {

const char* name_of(PlannedMethod::Kind kind) {
  switch (kind) {
    case PlannedMethod::Kind::activity:
      return "activity";
    case PlannedMethod::Kind::decide:
      return "decide";
    case PlannedMethod::Kind::compose:
      return "compose";
  }
  return "";
}

class Dumper {
 public:
  Dumper(const Plan& plan, std::ostream& out) : plan_(plan), out_(out) {}

  void dump() {
    out_ << "plan " << plan_.name << " of skill " << plan_.skill.name << " in " << plan_.environment.name
         << '\n';
    for (const PlannedMessage& message : plan_.messages) {
      out_ << "message " << message.pal_name << " as " << message.type << ", " << message.variable << ':';
      for (const PlannedField& field : message.fields) {
        out_ << ' ' << cpp_type(field.type, field.size) << ' ' << field.name
             << (field.unit.empty() ? "" : " " + field.unit) << ';';
      }
      out_ << '\n';
    }
    for (const PlannedParameter& parameter : plan_.parameters) {
      out_ << "parameter " << parameter.pal.name << " as " << parameter.name << '\n';
    }
    for (const PlannedThread& thread : plan_.threads) {
      out_ << "thread " << thread.pal_name << " as " << thread.constant << " on "
           << plan_.environment.processors[thread.processor].name << " priority " << thread.priority
           << (thread.parent ? ", block of " + plan_.threads[*thread.parent].pal_name : "")
           << (thread.can_end ? ", can end" : "") << '\n';
    }
    for (const PlannedChannel& channel : plan_.channels) {
      out_ << "channel " << channel.message << " from " << channel.sender << " to " << channel.receiver
           << " as " << channel.constant << '\n';
    }
    for (const PlannedCondition& condition : plan_.conditions) {
      out_ << "condition " << condition.pal_name << " as " << condition.constant << '\n';
    }
    for (const PlannedDevice& device : plan_.device_classes) {
      out_ << "device " << device.pal_name << " as " << device.type << ':';
      for (const PlannedDevice::Port& port : device.ports)
        out_ << (port.to_device ? " takes " : " sends ") << port.name << ';';
      out_ << '\n';
    }
    for (const PlannedModule& module : plan_.modules) dump(module);
  }

 private:
  void dump(const PlannedModule& module) {
    out_ << "module " << module.pal_name << " as " << module.type;
    if (!module.interface.empty()) out_ << " with " << module.interface;
    out_ << (module.executed ? ", executed" : "") << '\n';
    for (const PlannedMethod& method : module.methods) {
      out_ << "  method " << method.name << ", " << name_of(method.kind) << ':';
      for (const std::size_t message : method.reads) out_ << " reads " << plan_.messages[message].type;
      for (const std::size_t message : method.writes) out_ << " writes " << plan_.messages[message].type;
      out_ << '\n';
    }
    dump(module.body, "  ");
  }

  void dump(const PlannedBody& body, const std::string& margin) {
    for (const PlannedStatement& statement : body) {
      out_ << margin << statement.pal;
      if (statement.row) {
        const PlannedRow& row = plan_.statements[*statement.row];
        out_ << "  [" << row.constant << ' ' << interval(row.cost) << ']';
      }
      out_ << '\n';
      for (std::size_t i = 0; i < statement.branches.size(); ++i) {
        if (i < statement.arms.size()) out_ << margin << ' ' << statement.arms[i] << '\n';
        if (i < statement.threads.size()) {
          out_ << margin << " block";
          for (const std::size_t thread : statement.threads[i]) out_ << ' ' << plan_.threads[thread].pal_name;
          out_ << '\n';
        }
        dump(statement.branches[i], margin + "  ");
      }
      if (!statement.until.empty()) out_ << margin << statement.until << '\n';
    }
  }

  const Plan& plan_;
  std::ostream& out_;
};

}  // namespace

void dump(const Plan& plan, std::ostream& out) {
  Dumper(plan, out).dump();
}

}  // namespace pal::codegen
