// The parameters of a skill with their ranges and units.
#include <algorithm>

#include "codegen/emit.hpp"
#include "codegen/names.hpp"

namespace pal::codegen {

namespace {

std::string type_name(pan::ScalarType type) {
  switch (type) {
    case pan::ScalarType::real:
      return "real";
    case pan::ScalarType::integer:
      return "integer";
    case pan::ScalarType::boolean:
      return "boolean";
    case pan::ScalarType::text:
      return "text";
  }
  return {};
}

std::string in_range(const pan::Parameter& parameter) {
  if (parameter.type == pan::ScalarType::boolean) return "";
  if (parameter.type == pan::ScalarType::text)
    return "up to " + std::to_string(pan::longest_text) + " characters";
  return number(parameter.low, parameter.type) + " to " + number(parameter.high, parameter.type) +
         (parameter.unit.empty() ? "" : " " + parameter.unit);
}

bool is_text(const PlannedParameter& parameter) {
  return parameter.pal.type == pan::ScalarType::text;
}

bool has_texts(const Plan& plan) {
  return std::any_of(plan.parameters.begin(), plan.parameters.end(), is_text);
}

std::string start_of(const pan::Parameter& parameter) {
  if (parameter.type == pan::ScalarType::text) return "{" + literal(parameter.default_text) + "}";
  return " = " + number(parameter.default_value, parameter.type);
}

/// set_text_parameter: the name of the parameter gives its place in the table.
void write_text_setter(Writer& out, const Plan& plan) {
  out.line().open(
      "bool set_text_parameter(Parameters& parameters, std::string_view name, std::string_view text) {");
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    const PlannedParameter& parameter = plan.parameters[i];
    if (!is_text(parameter)) continue;
    out.open("if (name == " + literal(parameter.pal.name) + ") {");
    out.line("runtime::check_parameter(parameter_specs[" + std::to_string(i) + "], text);");
    out.line("parameters." + parameter.name + " = runtime::Text(text);");
    out.line("return true;");
    out.close();
  }
  out.line("return false;");
  out.close();
}

std::string parameters_header(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "The parameters of skill " + plan.skill.name + ".");
  out.line("#pragma once").line();
  out.line("#include <array>").line("#include <cstdint>").line("#include <string_view>").line();
  out.line("#include \"pal/runtime/skill.hpp\"");
  open_namespace(out, plan);
  out.open("struct Parameters {");
  for (const PlannedParameter& parameter : plan.parameters) {
    const pan::Parameter& pal = parameter.pal;
    out.line("/// " + pal.description + (pal.description.empty() ? "" : ": ") + in_range(pal));
    out.line(cpp_type(pal.type) + " " + parameter.name + start_of(pal) + ";");
  }
  out.close("};").line();
  out.line("extern const std::array<runtime::ParameterSpec, " + std::to_string(plan.parameters.size()) +
           "> parameter_specs;");
  out.line();
  out.line(
      "/// Sets the parameter that PAL calls `name`. False: there is none. Throws runtime::ParameterError if "
      "`value` is");
  out.line("/// out of its range; `parameters` is unchanged then.");
  out.line("bool set_parameter(Parameters& parameters, std::string_view name, double value);");
  if (has_texts(plan)) {
    out.line("/// Likewise the parameter that is a TEXT. False: there is none of that name.");
    out.line(
        "bool set_text_parameter(Parameters& parameters, std::string_view name, std::string_view text);");
  }
  close_namespace(out, plan);
  return out.take();
}

std::string parameters_source(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "The parameters of skill " + plan.skill.name + ".");
  out.line("#include \"" + plan.file + "_parameters.hpp\"");
  open_namespace(out, plan);
  out.line(std::string("// Name, type, unit, least, greatest, default, description") +
           (has_texts(plan) ? "; default of a text." : "."));
  const std::string count = std::to_string(plan.parameters.size());
  out.open("const std::array<runtime::ParameterSpec, " + count + "> parameter_specs{{");
  for (const PlannedParameter& parameter : plan.parameters) {
    const pan::Parameter& pal = parameter.pal;
    const auto value = [&](double v) { return number(v, pan::ScalarType::real); };
    out.line("{" + literal(pal.name) + ", runtime::ParameterType::" + type_name(pal.type) + ", " +
             literal(pal.unit) + ", " + value(pal.low) + ", " + value(pal.high) + ", " +
             value(pal.default_value) + ",");
    out.line(" " + literal(pal.description) + (is_text(parameter) ? ", " + literal(pal.default_text) : "") +
             (pal.location ? ", true" : "") + "},");
  }
  out.close("}};").line();
  if (plan.parameters.empty()) {
    out.line("bool set_parameter(Parameters&, std::string_view, double) { return false; }");
  } else {
    out.open("bool set_parameter(Parameters& parameters, std::string_view name, double value) {");
    for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
      const PlannedParameter& parameter = plan.parameters[i];
      out.open("if (name == " + literal(parameter.pal.name) + ") {");
      out.line("runtime::check_parameter(parameter_specs[" + std::to_string(i) + "], value);");
      if (is_text(parameter)) {  // refused already
        out.line("return true;");
        out.close();
        continue;
      }
      std::string converted = "value";
      if (parameter.pal.type == pan::ScalarType::integer) converted = "static_cast<std::int64_t>(value)";
      if (parameter.pal.type == pan::ScalarType::boolean) converted = "value != 0";
      out.line("parameters." + parameter.name + " = " + converted + ";");
      out.line("return true;");
      out.close();
    }
    out.line("return false;");
    out.close();
  }
  if (has_texts(plan)) write_text_setter(out, plan);
  close_namespace(out, plan);
  return out.take();
}

}  // namespace

std::vector<GeneratedFile> emit_parameters(const Plan& plan) {
  return {{plan.file + "_parameters.hpp", parameters_header(plan)},
          {plan.file + "_parameters.cpp", parameters_source(plan)}};
}

}  // namespace pal::codegen
