// The messages of a skill as C++ structures.
#include <algorithm>

#include "codegen/emit.hpp"

namespace pal::codegen {

namespace {

std::string from_number(const PlannedField& field, std::size_t index) {
  const std::string number = "numbers[" + std::to_string(index) + "]";
  switch (field.type) {
    case pan::ScalarType::real:
      return "runtime::finite(" + number + ")";
    case pan::ScalarType::integer:
      return "runtime::whole(" + number + ")";
    case pan::ScalarType::boolean:
      return "runtime::truth(" + number + ")";
    case pan::ScalarType::text:
      break;  // in no plain message
  }
  return {};
}

std::string to_number(const PlannedField& field) {
  switch (field.type) {
    case pan::ScalarType::real:
      return "runtime::finite(" + field.name + ")";
    case pan::ScalarType::integer:
      return "runtime::from_whole(" + field.name + ")";
    case pan::ScalarType::boolean:
      return field.name + " ? 1.0 : 0.0";
    case pan::ScalarType::text:
      break;  // in no plain message
  }
  return {};
}

/// Where the field's numbers end that begin at `at`; a text takes runtime::Text::slots of them, six
/// characters in each.
std::size_t end_of(const PlannedField& field, std::size_t at) {
  constexpr std::size_t of_a_text = (pan::longest_text + 5) / 6;
  if (field.type == pan::ScalarType::text) return at + of_a_text;
  return at + (field.size == 0 ? 1 : static_cast<std::size_t>(field.size));
}

/// The conversions of a message with arrays or texts.
void write_long_conversions(Writer& out, const PlannedMessage& message) {
  std::size_t count = 0;
  for (const PlannedField& field : message.fields) count = end_of(field, count);
  out.line("static constexpr std::size_t field_count = " + std::to_string(count) + ";");
  out.open("std::array<double, field_count> fields() const {");
  out.line("std::array<double, field_count> numbers{};");
  std::size_t at = 0;
  for (const PlannedField& field : message.fields) {
    out.line("runtime::put(" + field.name + ", numbers, " + std::to_string(at) + ");");
    at = end_of(field, at);
  }
  out.line("return numbers;");
  out.close();
  out.open("static " + message.type + " from_fields(std::span<const double> numbers) {");
  out.line(message.type + " message;");
  at = 0;
  for (const PlannedField& field : message.fields) {
    out.line("runtime::get(message." + field.name + ", numbers, " + std::to_string(at) + ");");
    at = end_of(field, at);
  }
  out.line("return message;");
  out.close();
}

/// Of a field when nothing has come yet.
std::string start_of(const PlannedField& field) {
  if (field.type == pan::ScalarType::text) return "";
  if (field.size != 0) return "{}";
  return field.type == pan::ScalarType::boolean ? " = false" : " = 0";
}

void write_message(Writer& out, const PlannedMessage& message) {
  out.line("/// MESSAGE " + message.pal_name);
  out.open("struct " + message.type + " {");
  for (const PlannedField& field : message.fields) {
    const std::string unit = field.unit.empty() ? "" : "  // " + field.unit;
    out.line(cpp_type(field.type, field.size) + " " + field.name + start_of(field) + ";" + unit);
  }
  if (!is_plain(message)) {
    out.line();
    write_long_conversions(out, message);
    out.close("};");
    return;
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
  const auto has_fields = [](const PlannedMessage& message) { return !message.fields.empty(); };
  if (std::any_of(plan.messages.begin(), plan.messages.end(), has_fields))
    out.line().line("#include \"pal/runtime/payload.hpp\"");
  open_namespace(out, plan);
  for (const PlannedMessage& message : plan.messages) {
    if (&message != &plan.messages.front()) out.line();
    write_message(out, message);
  }
  close_namespace(out, plan);
  return {plan.file + "_messages.hpp", out.take()};
}

}  // namespace pal::codegen
