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
  }
  return {};
}

std::string in_range(const pan::Parameter& parameter) {
  if (parameter.type == pan::ScalarType::boolean) return "";
  return number(parameter.low, parameter.type) + " to " + number(parameter.high, parameter.type) +
         (parameter.unit.empty() ? "" : " " + parameter.unit);
}

std::string header(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "The parameters of skill " + plan.skill.name + ".");
  out.line("#pragma once").line();
  out.line("#include <array>").line("#include <cstdint>").line("#include <string_view>").line();
  out.line("#include \"runtime/skill.hpp\"");
  open_namespace(out, plan);
  out.open("struct Parameters {");
  for (const PlannedParameter& parameter : plan.parameters) {
    const pan::Parameter& pal = parameter.pal;
    out.line("/// " + pal.description + (pal.description.empty() ? "" : ": ") + in_range(pal));
    out.line(std::string(cpp_type(pal.type)) + " " + parameter.name + " = " +
             number(pal.default_value, pal.type) + ";");
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
  close_namespace(out, plan);
  return out.take();
}

std::string source(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "The parameters of skill " + plan.skill.name + ".");
  out.line("#include \"" + plan.file + "_parameters.hpp\"");
  open_namespace(out, plan);
  out.line("// Name, type, unit, least, greatest, default, description.");
  const std::string count = std::to_string(plan.parameters.size());
  out.open("const std::array<runtime::ParameterSpec, " + count + "> parameter_specs{{");
  for (const PlannedParameter& parameter : plan.parameters) {
    const pan::Parameter& pal = parameter.pal;
    const auto value = [&](double v) { return number(v, pan::ScalarType::real); };
    out.line("{" + literal(pal.name) + ", runtime::ParameterType::" + type_name(pal.type) + ", " +
             literal(pal.unit) + ", " + value(pal.low) + ", " + value(pal.high) + ", " +
             value(pal.default_value) + ",");
    out.line(" " + literal(pal.description) + "},");
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
  close_namespace(out, plan);
  return out.take();
}

}  // namespace

std::vector<GeneratedFile> emit_parameters(const Plan& plan) {
  return {{plan.file + "_parameters.hpp", header(plan)}, {plan.file + "_parameters.cpp", source(plan)}};
}

}  // namespace pal::codegen
