// A class for each device: its ports as functions with the skill's own messages.
#include <algorithm>

#include "codegen/emit.hpp"
#include "codegen/names.hpp"

namespace pal::codegen {

namespace {

/// "std::chrono::microseconds(1500)": a header has no literals of its own.
std::string time(Duration value) {
  struct Unit {
    std::int64_t nanoseconds;
    const char* name;
  };
  for (const Unit& unit : {Unit{1'000'000'000, "seconds"}, Unit{1'000'000, "milliseconds"},
                           Unit{1'000, "microseconds"}, Unit{1, "nanoseconds"}}) {
    if (value.count() % unit.nanoseconds == 0 && (value.count() != 0 || unit.nanoseconds == 1))
      return std::string("std::chrono::") + unit.name + "(" +
             std::to_string(value.count() / unit.nanoseconds) + ")";
  }
  return {};
}

/// The times that the environment promises of the device, as constants.
class PromiseWriter {
 public:
  explicit PromiseWriter(Writer& out) : out_(out) {}

  void operator()(const pan::EventDevice& device) const {
    constant(
        device.sporadic ? "least_separation" : "period", device.period,
        (device.sporadic ? "least time from one message to the next: " : "from one message to the next: ") +
            device.message);
    constant("jitter", device.jitter, "the most by which it is late");
    if (device.phase) constant("phase", *device.phase, "the first one, from open() on");
    if (device.answer_within)
      constant("answer_within", *device.answer_within, "the skill then sends " + device.answer);
  }
  void operator()(const pan::RequestDevice& device) const {
    out_.line("static constexpr runtime::Interval answers_after{" + time(device.answer.best) + ", " +
              time(device.answer.worst) + "};  // one request at a time");
  }
  void operator()(const pan::FrameDevice& device) const {
    constant("period", device.period, "from frame to frame");
    constant("collecting", device.collecting, "from the beginning of a frame to its end");
    if (device.phase) constant("phase", *device.phase, "the first frame, from attach() on");
  }

 private:
  void constant(const char* name, Duration value, const std::string& what) const {
    out_.line(std::string("static constexpr runtime::Time ") + name + "{" + time(value) + "};  // " + what);
  }
  Writer& out_;
};

void write_promise(Writer& out, const Plan& plan, const PlannedDevice& device) {
  for (const pan::DeviceTiming& timing : plan.environment.devices) {
    if (timing.device != device.pal_name) continue;
    out.line("// What environment " + plan.environment.name + " promises of it.");
    std::visit(PromiseWriter(out), timing.behaviour);
    out.line();
  }
}

/// Whether it answers each request, one after the other: then its class knows when it works.
bool serves(const Plan& plan, const PlannedDevice& device) {
  return std::any_of(plan.environment.devices.begin(), plan.environment.devices.end(),
                     [&device](const pan::DeviceTiming& timing) {
                       const auto* request = std::get_if<pan::RequestDevice>(&timing.behaviour);
                       return timing.device == device.pal_name && request != nullptr && !request->may_fail;
                     });
}

/// Whether a port's message answers a request of another port.
bool is_answer(const PlannedDevice& device, const PlannedDevice::Port& port) {
  return !port.to_device &&
         std::any_of(device.ports.begin(), device.ports.end(), [&port](const PlannedDevice::Port& other) {
           return other.to_device && other.message == "request " + port.message;
         });
}

bool is_request(const PlannedDevice& device, const PlannedDevice::Port& port) {
  return port.to_device &&
         std::any_of(device.ports.begin(), device.ports.end(), [&port](const PlannedDevice::Port& other) {
           return !other.to_device && port.message == "request " + other.message;
         });
}

std::string specification(const Plan& plan, const PlannedDevice::Port& port) {
  std::string fields;
  if (port.fields) {
    for (const PlannedField& field : plan.messages[*port.fields].fields) {
      fields += (fields.empty() ? "{" : ", {") + literal(field.pal_name) + ", " + literal(field.unit);
      if (field.type == pan::ScalarType::text) {
        fields += ", runtime::FieldKind::text";
      } else if (field.size != 0) {
        fields += ", runtime::FieldKind::number, " + std::to_string(field.size);
      }
      fields += "}";
    }
  }
  return "{" + literal(port.message) + ", " + (port.to_device ? "true" : "false") + ", {" + fields + "}}";
}

void write_ports(Writer& out, const Plan& plan, const PlannedDevice& device) {
  out.line("// Its ports, as Device::receive and DeviceHost::deliver number them.");
  std::vector<std::string> rows;
  for (std::size_t p = 0; p < device.ports.size(); ++p) {
    out.line("static constexpr std::size_t " + device.ports[p].name + "_port = " + std::to_string(p) + ";");
    rows.push_back(specification(plan, device.ports[p]));
  }
  out.open("static std::vector<runtime::PortSpec> port_specs() {");
  out.list("return {", rows, "};");
  out.close().line();
}

/// Receive() by port, and a function for each.
void write_receiving(Writer& out, const Plan& plan, const PlannedDevice& device) {
  const auto typed = [](const PlannedDevice::Port& port) { return port.to_device && port.fields; };
  const bool any = std::any_of(device.ports.begin(), device.ports.end(), typed);
  const bool takes = std::any_of(device.ports.begin(), device.ports.end(),
                                 [](const PlannedDevice::Port& port) { return port.to_device; });
  if (!takes) {
    out.line("void receive(std::size_t, std::span<const double>) final {}");
    return;
  }
  out.open(std::string("void receive(std::size_t port, std::span<const double>") + (any ? " fields" : "") +
           ") final {");
  out.line("switch (port) {").indent();
  for (const PlannedDevice::Port& port : device.ports) {
    if (!port.to_device) continue;
    const std::string given = port.fields ? plan.messages[*port.fields].type + "::from_fields(fields)" : "";
    out.line("case " + port.name + "_port:").indent();
    if (serves(plan, device) && is_request(device, port)) out.line("asked();");
    out.line("return on_" + port.name + "(" + given + ");").outdent();
  }
  out.line("default:").indent().line("return;  // the skill sends nothing else").outdent();
  out.close("}");
  out.close();
}

void write_functions(Writer& out, const Plan& plan, const PlannedDevice& device) {
  bool first = true;
  for (const PlannedDevice::Port& port : device.ports) {
    if (!first) out.line();
    first = false;
    const std::string type = port.fields ? plan.messages[*port.fields].type : std::string();
    if (port.to_device) {
      out.line("/// " + port.message + " has arrived.");
      out.line("virtual void on_" + port.name + "(" + (type.empty() ? "" : "const " + type + "& message") +
               ") = 0;");
      continue;
    }
    out.line("/// False: the skill has not taken the last one; this one is lost, which is an overrun.");
    out.line("bool send_" + port.name + "(" + (type.empty() ? "" : "const " + type + "& message") + ") {")
        .indent();
    const bool answers = serves(plan, device) && is_answer(device, port);
    out.line(std::string("return ") + (answers ? "answer(" : "host().deliver(") + port.name + "_port, " +
             (type.empty() ? "{}" : "message.fields()") + ");");
    out.close();
  }
}

void write_class(Writer& out, const Plan& plan, const PlannedDevice& device) {
  out.line("/// DEVICE " + device.pal_name + (device.description.empty() ? "" : ": " + device.description));
  const std::string base = serves(plan, device) ? "ServingDevice" : "PortDevice";
  out.line("class " + device.type + " : public runtime::" + base + " {");
  out.line(" public:").indent();
  write_promise(out, plan, device);
  write_ports(out, plan, device);
  out.line(device.type + "() : " + base + "(" + literal(device.pal_name) + ", port_specs()) {}");
  write_receiving(out, plan, device);
  out.outdent().line().line(" protected:").indent();
  write_functions(out, plan, device);
  out.close("};");
}

}  // namespace

GeneratedFile emit_devices(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "The devices of skill " + plan.skill.name + ", to be written by hand.");
  out.line("//");
  out.line("// Derive from a class, and write its on_… functions; they call the send_… functions.");
  out.line("#pragma once").line();
  out.line("#include <chrono>")
      .line("#include <cstddef>")
      .line("#include <span>")
      .line("#include <vector>")
      .line();
  out.line("#include \"" + plan.file + "_messages.hpp\"");
  const bool any_serves = std::any_of(plan.device_classes.begin(), plan.device_classes.end(),
                                      [&plan](const PlannedDevice& device) { return serves(plan, device); });
  const bool any_other = std::any_of(plan.device_classes.begin(), plan.device_classes.end(),
                                     [&plan](const PlannedDevice& device) { return !serves(plan, device); });
  if (any_other) out.line("#include \"pal/runtime/port_device.hpp\"");
  if (any_serves) out.line("#include \"pal/runtime/serving_device.hpp\"");
  out.line("#include \"pal/runtime/wiring.hpp\"");
  open_namespace(out, plan);
  for (const PlannedDevice& device : plan.device_classes) {
    if (&device != &plan.device_classes.front()) out.line();
    write_class(out, plan, device);
  }
  close_namespace(out, plan);
  return {plan.file + "_devices.hpp", out.take()};
}

}  // namespace pal::codegen
