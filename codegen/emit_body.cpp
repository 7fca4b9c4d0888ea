// The body of a module, statement by statement, each under the PAL that it stands for.
#include "codegen/emit.hpp"

namespace pal::codegen {

namespace {

using Kind = PlannedStatement::Kind;

class BodyWriter {
 public:
  BodyWriter(Writer& out, const Plan& plan, const PlannedModule& module, const EmitOptions& options)
      : out_(out), plan_(plan), module_(module), debug_lines_(options.debug_lines) {}

  void write(const PlannedBody& body) {
    for (const PlannedStatement& statement : body) write(statement);
  }

 private:
  void comment(int line, const std::string& pal) {
    out_.line("// " + (line > 0 ? std::to_string(line) + ": " : std::string()) + pal);
    stand_for(line);
  }

  /// What follows is the code of that line of PAL, if it is known (a module that was drawn has none).
  void stand_for(int line) {
    if (debug_lines_ && line > 0) out_.stands_for(module_.file, line);
  }

  void write(const PlannedStatement& statement) {
    comment(statement.line, statement.pal);
    switch (statement.kind) {
      case Kind::take_start:
        out_.line("co_await thread.take_start(" + row(statement) + ");");
        break;
      case Kind::wait:
        write_wait(statement);
        break;
      case Kind::send:
        write_send(statement);
        break;
      case Kind::complete:
        out_.line("co_await thread.complete(" + row(statement) + ", " + std::to_string(statement.code) +
                  ");");
        break;
      case Kind::set:
        write_set(statement);
        break;
      case Kind::read:
        out_.line("co_await thread.read(" + row(statement) + ", " + condition(*statement.condition) + ");");
        break;
      case Kind::perform:
        write_perform(statement);
        break;
      case Kind::execute:
        out_.line("co_await " + plan_.modules[*statement.module].variable + "_.body(thread);");
        break;
      case Kind::nothing:
        break;
      case Kind::choose:
        write_choose(statement);
        break;
      case Kind::loop:
        write_loop(statement);
        break;
      case Kind::concurrent:
        write_concurrent(statement);
        break;
    }
  }

  std::string row(const PlannedStatement& statement) const {
    return "statement::" + plan_.statements[*statement.row].constant;
  }
  std::string channel(const PlannedEnd& end) const {
    return "channel::" + plan_.channels[end.channel].constant;
  }
  std::string condition(std::size_t index) const { return "condition::" + plan_.conditions[index].constant; }
  std::string member(std::size_t message) const {
    const std::string& name = plan_.messages[message].variable;
    return store_of(plan_, module_) != nullptr ? "messages_." + name : name + "_";
  }

  std::string call(const PlannedMethod& method) const {
    std::string arguments;
    for (const std::size_t message : method.reads)
      arguments += (arguments.empty() ? "" : ", ") + member(message);
    return "activities_." + method.name + "(" + arguments + ")";
  }

  std::string work(std::size_t index) const {
    const PlannedMethod& method = module_.methods[index];
    if (method.writes.empty()) return call(method) + ";";
    return member(method.writes.front()) + " = " + call(method) + ";";
  }

  void write_perform(const PlannedStatement& statement) {
    const PlannedMethod& method = module_.methods[*statement.method];
    if (method.writes.size() < 2) {
      out_.list("co_await thread.perform(", {row(statement), "[this] { " + work(*statement.method) + " }"},
                ");");
      return;
    }
    out_.open("co_await thread.perform(" + row(statement) + ", [this] {");
    out_.line("const " + method.result_type + " result = " + call(method) + ";");
    for (const std::size_t message : method.writes) {
      out_.line(member(message) + " = result." + plan_.messages[message].variable + ";");
    }
    out_.close("});");
  }

  void write_send(const PlannedStatement& statement) {
    const PlannedEnd& end = statement.ends.front();
    std::vector<std::string> given{row(statement), channel(end)};
    if (end.message) given.push_back(member(*end.message));
    if (statement.method) given.push_back("[this] { " + work(*statement.method) + " }");
    out_.list("co_await thread.send(", given, ");");
  }

  void write_set(const PlannedStatement& statement) {
    std::vector<std::string> given{row(statement), condition(*statement.condition)};
    if (statement.value) {
      given.emplace_back(*statement.value ? "true" : "false");
    } else {
      given.push_back("[this] { return " + call(module_.methods[*statement.method]) + "; }");
    }
    out_.list("co_await thread.set(", given, ");");
  }

  void write_wait(const PlannedStatement& statement) {
    std::vector<std::string> given{row(statement)};
    if (statement.within) given.push_back(duration(*statement.within));
    for (const PlannedEnd& end : statement.ends) {
      given.push_back("runtime::from(" + channel(end) + (end.message ? ", " + member(*end.message) : "") +
                      ")");
    }
    const std::string waits = std::string("co_await thread.") + (statement.within ? "wait_within(" : "wait(");
    if (statement.branches.empty()) {
      out_.list(waits, given, ");");
      return;
    }
    const std::string taken = "taken_" + plan_.statements[*statement.row].constant;
    out_.list("const int " + taken + " = " + waits, given, ");");
    for (std::size_t i = 0; i < statement.branches.size(); ++i) {
      const bool gave_up = i == statement.ends.size();
      const std::string head = (i == 0 ? "if (" : "} else if (") + taken + " == " + std::to_string(i) + ") {";
      out_.open(gave_up ? "} else {" : head);
      out_.line("// " + statement.arms[i]);
      write(statement.branches[i]);
      stand_for(statement.line);
      out_.outdent();
    }
    out_.line("}");
  }

  void write_choose(const PlannedStatement& statement) {
    write_test(statement);
    for (std::size_t i = 0; i < statement.branches.size(); ++i) {
      out_.condition(i == 0 ? "if (" : "} else if (", expression(statement.guards[i]), ") {").indent();
      out_.line("// " + statement.arms[i]);
      write(statement.branches[i]);
      stand_for(statement.line);
      out_.outdent();
    }
    out_.open("} else {");
    out_.line("co_await thread.no_arm_holds(" + row(statement) + ");");
    out_.close();
  }

  void write_loop(const PlannedStatement& statement) {
    if (!statement.loop) return write_turns(statement);
    out_.open("{");
    out_.line("const runtime::Thread::Within within = thread.within(" + std::to_string(*statement.loop) +
              ");");
    write_turns(statement);
    out_.close();
  }

  void write_turns(const PlannedStatement& statement) {
    out_.open("for (;;) {");
    write(statement.branches.front());
    comment(statement.until_line, statement.until);
    if (!statement.guards.empty()) {
      write_test(statement);
      out_.condition("if (", expression(statement.guards.front()), ") break;");
    }
    out_.close();
  }

  void write_concurrent(const PlannedStatement& statement) {
    std::vector<std::string> given{row(statement)};
    for (const std::vector<std::size_t>& threads : statement.threads) given.push_back(block(threads));
    out_.list("co_await thread.concurrent(", given, ");");
  }

  /// The thread of a block; of several the one that this thread begins.
  std::string block(const std::vector<std::size_t>& threads) const {
    for (const PlannedModule::Block& known : module_.blocks) {
      if (known.threads == threads && !known.chooser.empty()) return known.chooser + "(thread)";
    }
    return "thread_of::" + plan_.threads[threads.front()].constant;
  }

  // Guards.

  static void conditions(const pan::Guard& guard, std::vector<std::size_t>& found) {
    if (guard.kind == pan::Guard::Kind::equals) {
      for (const std::size_t known : found) {
        if (known == guard.condition.index()) return;
      }
      found.push_back(guard.condition.index());
    }
    for (const pan::Guard& term : guard.terms) conditions(term, found);
  }

  void write_test(const PlannedStatement& statement) {
    std::vector<std::size_t> tested;
    for (const pan::Guard& guard : statement.guards) conditions(guard, tested);
    std::vector<std::string> given{row(statement)};
    for (const std::size_t index : tested) given.push_back(condition(index));
    out_.list("co_await thread.test(", given, ");");
  }

  std::string expression(const pan::Guard& guard) const {
    switch (guard.kind) {
      case pan::Guard::Kind::equals:
        return (guard.value ? "" : "!") + ("thread.tested(" + condition(guard.condition.index()) + ")");
      case pan::Guard::Kind::negation:
        return "!(" + expression(guard.terms.front()) + ")";
      case pan::Guard::Kind::all_of:
        return joined(guard, " && ");
      case pan::Guard::Kind::any_of:
        return joined(guard, " || ");
    }
    return {};
  }

  std::string joined(const pan::Guard& guard, const char* between) const {
    std::string text;
    for (const pan::Guard& term : guard.terms) {
      const bool nested = term.kind == pan::Guard::Kind::all_of || term.kind == pan::Guard::Kind::any_of;
      text += (text.empty() ? "" : between) + (nested ? "(" + expression(term) + ")" : expression(term));
    }
    return text;
  }

  Writer& out_;
  const Plan& plan_;
  const PlannedModule& module_;
  bool debug_lines_;
};

}  // namespace

void write_body(Writer& out, const Plan& plan, const PlannedModule& module, const PlannedBody& body,
                const EmitOptions& options) {
  BodyWriter(out, plan, module, options).write(body);
}

}  // namespace pal::codegen
