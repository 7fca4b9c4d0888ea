// The tables of channels, conditions, devices and requirements that the runtime reads.
#include <algorithm>

#include "codegen/emit.hpp"
#include "codegen/names.hpp"

namespace pal::codegen {

namespace {

template <class Rows>
void write_constants(Writer& out, const char* space, const char* comment, const Rows& rows) {
  out.line(std::string("/// ") + comment);
  out.line(std::string("namespace ") + space + " {");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out.line("constexpr int " + rows[i].constant + " = " + std::to_string(i) + ";");
  }
  out.line(std::string("}  // namespace ") + space).line();
}

std::string wiring_header(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "Where each thread runs, which threads talk, and how long it takes.");
  out.line("#pragma once").line();
  out.line("#include \"pal/runtime/wiring.hpp\"");
  open_namespace(out, plan);
  write_constants(out, "thread_of", "Threads: modules and blocks of CONCURRENT.", plan.threads);
  write_constants(out, "statement", "Statements, by module and line.", plan.statements);
  write_constants(out, "channel", "Channels.", plan.channels);
  write_constants(out, "condition", "Process conditions.", plan.conditions);
  out.line("const runtime::Wiring& wiring();");
  close_namespace(out, plan);
  return out.take();
}

std::string truth(bool value) {
  return value ? "true" : "false";
}

/// Opens the table `name` of `count` rows of type `type`.
void open_table(Writer& out, const std::string& type, const std::string& name, std::size_t count) {
  out.open("constexpr std::array<" + type + ", " + std::to_string(count) + "> " + name + "{{");
}

std::string fields_of(const Plan& plan, const PlannedChannel& channel) {
  return channel.fields ? plan.messages[*channel.fields].variable + "_fields" : "{}";
}

/// Of what is no single number, the default.
std::string kind_and_count(const PlannedField& field) {
  if (field.type == pan::ScalarType::text) return ", runtime::FieldKind::text";
  return field.size == 0 ? "" : ", runtime::FieldKind::number, " + std::to_string(field.size);
}

void write_fields(Writer& out, const Plan& plan) {
  for (std::size_t m = 0; m < plan.messages.size(); ++m) {
    const bool used = std::any_of(plan.channels.begin(), plan.channels.end(),
                                  [m](const PlannedChannel& channel) { return channel.fields == m; });
    if (!used) continue;
    const PlannedMessage& message = plan.messages[m];
    std::vector<std::string> rows;
    for (const PlannedField& field : message.fields) {
      rows.push_back("{" + literal(field.pal_name) + ", " + literal(field.unit) + kind_and_count(field) +
                     "}");
    }
    out.list("constexpr std::array<runtime::Field, " + std::to_string(message.fields.size()) + "> " +
                 message.variable + "_fields{{",
             rows, "}};");
  }
}

void write_tables(Writer& out, const Plan& plan) {
  out.line("// Name, preemptive.");
  open_table(out, "runtime::ProcessorSpec", "processors", plan.environment.processors.size());
  for (const pan::Processor& processor : plan.environment.processors) {
    out.line("{" + literal(processor.name) + ", " + truth(processor.preemptive) + "},");
  }
  out.close("}};").line();

  out.line("// Name, processor, priority, thread of the CONCURRENT, can end.");
  open_table(out, "runtime::ThreadSpec", "threads", plan.threads.size());
  for (const PlannedThread& thread : plan.threads) {
    out.line("{" + literal(thread.pal_name) + ", " + std::to_string(thread.processor) + ", " +
             std::to_string(thread.priority) + ", " +
             (thread.parent ? "thread_of::" + plan.threads[*thread.parent].constant : std::string("-1")) +
             ", " + truth(thread.can_end) + "},");
  }
  out.close("}};").line();

  out.line("// Module, PAL, file, line, {best, worst} time.");
  open_table(out, "runtime::StatementSpec", "statements", plan.statements.size());
  for (const PlannedRow& row : plan.statements) {
    out.line("{" + literal(row.module) + ", " + literal(row.text) + ", " + literal(row.file) + ", " +
             std::to_string(row.line) + ", " + interval(row.cost) + "},");
  }
  out.close("}};").line();

  const bool plain = std::all_of(plan.messages.begin(), plan.messages.end(), is_plain);
  out.line(plain ? "// Fields of messages: name, unit."
                 : "// Fields of messages: name, unit; of texts and arrays also kind, values.");
  write_fields(out, plan);
  out.line();
  out.line("// Sender, message, receiver, fields, answer, request, from a device, to a device.");
  open_table(out, "runtime::ChannelSpec", "channels", plan.channels.size());
  for (const PlannedChannel& channel : plan.channels) {
    const std::string answer = channel.answer ? "channel::" + plan.channels[*channel.answer].constant : "-1";
    out.line("{" + literal(channel.sender) + ", " + literal(channel.message) + ", " +
             literal(channel.receiver) + ", " + fields_of(plan, channel) + ", " + answer + ", " +
             truth(channel.request) + ", " + truth(channel.from_device) + ", " + truth(channel.to_device) +
             "},");
  }
  out.close("}};").line();

  open_table(out, "std::string_view", "conditions", plan.conditions.size());
  for (const PlannedCondition& condition : plan.conditions) out.line(literal(condition.pal_name) + ",");
  out.close("}};").line();

  open_table(out, "std::string_view", "devices", plan.devices.size());
  for (const std::string& device : plan.devices) out.line(literal(device) + ",");
  out.close("}};").line();
}

std::string wiring_source(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "Where each thread runs, which threads talk, and how long it takes.");
  out.line("#include \"" + plan.file + "_wiring.hpp\"").line();
  out.line("#include <array>").line("#include <string_view>");
  open_namespace(out, plan);
  out.line("namespace {").line();
  out.line("using namespace std::chrono_literals;").line();
  write_tables(out, plan);
  write_promises(out, plan);
  out.open("constexpr runtime::Wiring tables{");
  out.line(literal(plan.skill.name) + ", " + literal(plan.environment.name) + ",");
  out.line("processors, threads, statements, channels, conditions, devices,");
  out.line(interval(plan.environment.costs.test) + ",  // a wait that gives up");
  const pan::Latency& latency = plan.environment.latency;
  out.line("{" + interval(latency.within_processor) + ", " + interval(latency.between_processors) +
           "},  // latency within a processor, between two");
  out.line(plan.kept.empty() ? "times, requirements," : "times, requirements, kept,");
  out.close("};").line();
  out.line("}  // namespace").line();
  out.line("const runtime::Wiring& wiring() { return tables; }");
  close_namespace(out, plan);
  return out.take();
}

}  // namespace

std::vector<GeneratedFile> emit_wiring(const Plan& plan) {
  return {{plan.file + "_wiring.hpp", wiring_header(plan)}, {plan.file + "_wiring.cpp", wiring_source(plan)}};
}

}  // namespace pal::codegen
