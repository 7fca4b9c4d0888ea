// The methods of the JSON protocol that run, halt and change the operation that is loaded, and skills.
#include <array>

#include "server/json_call.hpp"
#include "server/services.hpp"

namespace pal::server {
namespace {

void load_operation(const Call& call) {
  const Members& members = call.members();
  if (members.find("name") == nullptr) {
    LoadOperation command;
    command.main = members.text("main");
    // Long texts are copied there, not by the thread of the sockets.
    return call.load(std::move(command), [members, &context = call.context()](LoadOperation& each) {
      each.files = members.files();
      if (each.files.empty())
        fail(bad_parameters, "'files' must be an object: the text of each file by its name");
      add_stored_files(context, each);
    });
  }
  const std::string name = members.text("name");
  const auto version = members.may_be_whole("version", 1, std::int64_t{1} << 53);
  call.load({}, [&context = call.context(), name, version](LoadOperation& command) {
    command = load_stored(context, name, version ? std::optional<std::uint64_t>(*version) : std::nullopt);
    add_stored_files(context, command);
  });
}

void run(const Call& call, RunOperation::How how) {
  call.ask(RunOperation{how});
}

constexpr std::array operation_methods{
    Method{"skill.run", Role::programmer, true,
           [](const Call& call) {
             call.ask(run_skill(call.members()), [](const Done& done) { return describe(done, true); });
           }},
    Method{"stop", Role::viewer, false, [](const Call& call) { call.ask(Stop{}); }},
    Method{"operation.load", Role::operating, true, load_operation},
    Method{"operation.run", Role::operating, true,
           [](const Call& call) { run(call, RunOperation::How::run); }},
    Method{"operation.step", Role::operating, true,
           [](const Call& call) { run(call, RunOperation::How::step); }},
    Method{"operation.resume", Role::operating, true,
           [](const Call& call) { run(call, RunOperation::How::resume); }},
    Method{"operation.pause", Role::viewer, false, [](const Call& call) { call.ask(Pause{}); }},
    Method{"operation.stop", Role::viewer, false, [](const Call& call) { call.ask(Stop{}); }},
    Method{"operation.from", Role::operating, true,
           [](const Call& call) { call.ask(PutToken{call.members().text("icon")}); }},
    Method{"operation.outlook", Role::viewer, true,
           [](const Call& call) {
             const auto outlook = call.context().desk.outlook(call.members().text("icon", ""));
             if (const auto* refusal = std::get_if<Refusal>(&outlook)) throw problem_of(*refusal);
             call.result(describe(std::get<Outlook>(outlook)));
           }},
    Method{"operation.set", Role::operating, true,
           [](const Call& call) {
             const SetParameter command = set_parameter(call.members());
             call.ask(command, [value = command.value](const Done& done) {
               return Json{{"value", describe(value)}, {"before", value_or_null(done.before)}};
             });
           }},
    Method{"operation.values", Role::viewer, true,
           [](const Call& call) {
             const auto values = call.context().desk.values(call.members().text("icon"));
             if (const auto* refusal = std::get_if<Refusal>(&values)) throw problem_of(*refusal);
             call.result(describe(std::get<IconValues>(values)));
           }},
    Method{"operation.break", Role::operating, true,
           [](const Call& call) {
             call.ask(set_breakpoint(call.members()), [](const Done& done) {
               return done.breakpoint ? describe(*done.breakpoint) : Json::object();
             });
           }},
    Method{"operation.unbreak", Role::operating, true,
           [](const Call& call) {
             call.ask(RemoveBreakpoint{
                 static_cast<std::size_t>(call.members().whole("breakpoint", 1, 1'000'000))});
           }},
    Method{"operation.clear", Role::operating, true, [](const Call& call) { call.ask(ClearBreakpoints{}); }},
    Method{"operation.breakpoints", Role::viewer, true,
           [](const Call& call) { call.result(describe(call.context().desk.breakpoints())); }},
    Method{"operation.answer", Role::operating, false,
           [](const Call& call) { call.ask(answer_question(call.members())); }},
};

}  // namespace

std::span<const Method> methods_of_operations() {
  return operation_methods;
}

}  // namespace pal::server
