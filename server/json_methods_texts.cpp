// The methods of the JSON protocol on texts of operations that need not be loaded.
#include <array>

#include "server/json_call.hpp"
#include "server/program_check.hpp"
#include "server/services.hpp"
#include "server/text_check.hpp"

namespace pal::server {
namespace {

constexpr std::size_t usual_ways = 16;
constexpr std::int64_t greatest_number_of_ways = 64;

void check(const Call& call) {
  const Members& members = call.members();
  const auto ways =
      static_cast<std::size_t>(members.may_be_whole("ways", 0, greatest_number_of_ways).value_or(usual_ways));
  call.beside(call.context().checks, [members, main = members.text("main"), ways,
                                      &context = call.context()](const Workshop::Stop& stop) {
    // Long texts are copied here, not by the thread of the sockets.
    std::map<std::string, std::string> files = members.files();
    const RequestFiles all(files, context.store);
    Json json = checked(all, main, *context.desk.cell(), *context.facts(), ways, stop);
    if (stop()) fail(Refusal::Why::cancelled, "it was cancelled");
    return json;
  });
}

/// The skill as the only icon of an operation, so that the same rules hold for it.
std::string operation_of(const std::string& skill, const Json& parameters) {
  const Json start{{"id", "start"}, {"kind", "start"}, {"next", "skill"}};
  const Json icon{{"id", "skill"}, {"kind", "skill"}, {"skill", skill}, {"parameters", parameters},
                  {"next", "end"}, {"error", "end"}};
  const Json end{{"id", "end"}, {"kind", "exit"}};
  return dump({{"operation-format", 1}, {"name", skill}, {"icons", {start, icon, end}}});
}

void check_skill(const Call& call) {
  const std::string skill = call.members().text("skill");
  const Json* given = call.members().find("parameters");
  if (given != nullptr && !given->is_object()) fail(bad_parameters, "'parameters' must be an object");
  call.beside(call.context().checks,
              [text = operation_of(skill, given != nullptr ? *given : Json::object()),
               &context = call.context()](const Workshop::Stop& stop) -> Json {
                const std::string main = "skill.op.json";
                const std::map<std::string, std::string> files{{main, text}};
                Json told = checked(SentFiles(files), main, *context.desk.cell(), *context.facts(), 0, stop);
                Json result{{"findings", Json::array()}, {"runs", told["runs"]}, {"times", nullptr}};
                // Places in the text that was made here mean nothing to the client.
                for (Json& finding : told["findings"]) {
                  for (const char* place : {"file", "operation", "icon", "begin", "end", "notes", "edits"})
                    finding.erase(place);
                  result["findings"].push_back(std::move(finding));
                }
                for (Json& icon : told["icons"])
                  if (icon["icon"] == "skill") {
                    icon.erase("operation");
                    icon.erase("icon");
                    result["times"] = std::move(icon);
                  }
                return result;
              });
}

void format(const Call& call) {
  call.beside(call.context().checks,
              [members = call.members(),
               name = call.members().text("file", "operation.op.json")](const Workshop::Stop&) {
                return Json{{"text", formatted(name, members.text("text"))}};
              });
}

/// Two numbers above 0.
std::pair<double, double> pair_of(const Json& json, const char* name) {
  const auto number = [&](std::size_t i) {
    const double value =
        json.is_array() && json.size() == 2 && json[i].is_number() ? json[i].get<double>() : 0;
    if (!(value > 0 && value <= 1e4))
      fail(bad_parameters, std::string("'") + name + "' is two numbers, 0 to 10000");
    return value;
  };
  return {number(0), number(1)};
}

void tidy(const Call& call) {
  const Members& members = call.members();
  TidyOptions options;
  options.operation = members.text("operation", "");
  if (const Json* sizes = members.find("sizes")) {
    if (!sizes->is_object()) fail(bad_parameters, "'sizes' must be an object");
    for (const auto& [kind, size] : sizes->items()) options.sizes[kind] = pair_of(size, "sizes");
  }
  if (const Json* apart = members.find("apart"))
    std::tie(options.ranks_apart, options.apart) = pair_of(*apart, "apart");
  call.beside(call.context().checks, [members, main = members.text("main"), options,
                                      &context = call.context()](const Workshop::Stop& stop) {
    std::map<std::string, std::string> files = members.files();
    return tidied(RequestFiles(files, context.store), main, options, stop);
  });
}

void tell_story(const Call& call) {
  call.beside(call.context().checks, [members = call.members(), main = call.members().text("main"),
                                      &context = call.context()](const Workshop::Stop& stop) {
    static const operations::Skills none;
    const auto cell = context.desk.cell();
    std::map<std::string, std::string> files = members.files();
    return told_as_story(RequestFiles(files, context.store), main, cell->skills ? *cell->skills : none, stop);
  });
}

void compare(const Call& call) {
  call.beside(call.context().checks, [members = call.members()](const Workshop::Stop&) {
    return difference(members.text("before"), members.text("after"));
  });
}

constexpr std::array text_methods{
    Method{"operation.check", Role::viewer, false, check},
    Method{"skill.check", Role::viewer, false, check_skill},
    Method{"operation.format", Role::viewer, false, format},
    Method{"operation.tidy", Role::viewer, false, tidy},
    Method{"operation.storyboard", Role::viewer, false, tell_story},
    Method{"operation.difference", Role::viewer, false, compare},
};

}  // namespace

std::span<const Method> methods_of_texts() {
  return text_methods;
}

}  // namespace pal::server
