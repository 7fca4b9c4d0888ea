#include "codegen/emit.hpp"

namespace pal::codegen {

namespace {

std::string from_number(const PlannedField& field, std::size_t index) {
  const std::string number = "numbers[" + std::to_string(index) + "]";
  switch (field.type) {
    case pan::ScalarType::real:
      return number;
    case pan::ScalarType::integer:
      return "static_cast<std::int64_t>(" + number + ")";
    case pan::ScalarType::boolean:
      return number + " != 0";
  }
  return {};
}

std::string to_number(const PlannedField& field) {
  switch (field.type) {
    case pan::ScalarType::real:
      return field.name;
    case pan::ScalarType::integer:
      return "static_cast<double>(" + field.name + ")";
    case pan::ScalarType::boolean:
      return field.name + " ? 1.0 : 0.0";
  }
  return {};
}

void write_message(Writer& out, const PlannedMessage& message) {
  out.line("/// MESSAGE " + message.pal_name);
  out.open("struct " + message.type + " {");
  for (const PlannedField& field : message.fields) {
    const std::string start = field.type == pan::ScalarType::boolean ? "false" : "0";
    const std::string unit = field.unit.empty() ? "" : "  // " + field.unit;
    out.line(std::string(cpp_type(field.type)) + " " + field.name + " = " + start + ";" + unit);
  }
  const std::string count = std::to_string(message.fields.size());
  std::string numbers;
  for (const PlannedField& field : message.fields)
    numbers += (numbers.empty() ? "" : ", ") + to_number(field);
  out.line();
  out.line("static constexpr std::size_t field_count = " + count + ";");
  out.line("std::array<double, field_count> fields() const { return {" + numbers + "}; }");
  out.open("static " + message.type + " from_fields(std::span<const double> numbers) {");
  out.line(message.type + " message;");
  for (std::size_t i = 0; i < message.fields.size(); ++i) {
    out.line("message." + message.fields[i].name + " = " + from_number(message.fields[i], i) + ";");
  }
  out.line("return message;");
  out.close();
  out.close("};");
}

}  // namespace

GeneratedFile emit_messages(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "The messages of skill " + plan.skill.name + ".");
  out.line("#pragma once").line();
  out.line("#include <array>").line("#include <cstddef>").line("#include <cstdint>").line("#include <span>");
  open_namespace(out, plan);
  for (const PlannedMessage& message : plan.messages) {
    if (&message != &plan.messages.front()) out.line();
    write_message(out, message);
  }
  close_namespace(out, plan);
  return {plan.file + "_messages.hpp", out.take()};
}

}  // namespace pal::codegen
