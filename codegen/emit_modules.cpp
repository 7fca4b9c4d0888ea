// The modules of a skill as coroutines.
#include <algorithm>

#include "codegen/emit.hpp"

namespace pal::codegen {

namespace {

bool uses_thread(const PlannedBody& body) {
  for (const PlannedStatement& statement : body) {
    if (statement.kind != PlannedStatement::Kind::nothing && statement.kind != PlannedStatement::Kind::loop)
      return true;
    if (!statement.guards.empty()) return true;
    for (const PlannedBody& branch : statement.branches) {
      if (uses_thread(branch)) return true;
    }
  }
  return false;
}

struct Member {
  std::string type;
  std::string name;  // without the underscore of a member
};

/// What a module is given when it is made.
std::vector<Member> given(const Plan& plan, const PlannedModule& module) {
  std::vector<Member> members;
  if (!module.interface.empty()) members.push_back({module.interface, "activities"});
  if (const PlannedStore* store = store_of(plan, module)) members.push_back({store->type, "messages"});
  for (const std::size_t other : module.executes) {
    members.push_back({plan.modules[other].type, plan.modules[other].variable});
  }
  return members;
}

void write_constructor(Writer& out, const PlannedModule& module, const std::vector<Member>& members) {
  if (members.empty()) return;
  std::vector<std::string> arguments;
  std::vector<std::string> initialisers;
  for (const Member& member : members) {
    arguments.push_back(member.type + "& " + member.name);
    initialisers.push_back(member.name + "_(" + member.name + ")");
  }
  out.list((members.size() == 1 ? "explicit " : "") + module.type + "(", arguments, ")");
  out.list("    : ", initialisers, " {}").line();
}

void write_class(Writer& out, const Plan& plan, const PlannedModule& module) {
  out.line("/// " + module.kind + " " + module.pal_name + (module.file.empty() ? "" : ", " + module.file));
  out.line("class " + module.type + " {");
  out.line(" public:").indent();
  const auto members = given(plan, module);
  write_constructor(out, module, members);
  out.line("/// Forgets all messages; the activities get the parameters.");
  out.line("void start(const Parameters& parameters);").line();
  out.line("runtime::Task body(runtime::Thread& thread);");
  for (const auto& block : module.blocks) {
    out.line("runtime::Task " + block.function + "(runtime::Thread& thread);");
  }
  const bool stored = store_of(plan, module) != nullptr;
  if (!members.empty() || !module.messages.empty()) {
    out.outdent().line().line(" private:").indent();
    for (const Member& member : members) out.line(member.type + "& " + member.name + "_;");
    for (const std::size_t message : stored ? std::vector<std::size_t>{} : module.messages) {
      out.line(plan.messages[message].type + " " + plan.messages[message].variable + "_;");
    }
  }
  out.close("};");
}

void write_store(Writer& out, const Plan& plan, const PlannedStore& store) {
  out.line("/// What " + plan.modules[store.keeper].pal_name +
           " and the modules that it executes keep: one value of each message.");
  out.line("struct " + store.type + " {").indent();
  for (const std::size_t message : store.messages) {
    out.line(plan.messages[message].type + " " + plan.messages[message].variable + ";");
  }
  out.close("};").line();
}

std::string header(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "The modules of skill " + plan.skill.name + ".");
  out.line("#pragma once").line();
  out.line("#include \"" + plan.file + "_activities.hpp\"");
  out.line("#include \"" + plan.file + "_messages.hpp\"");
  out.line("#include \"" + plan.file + "_parameters.hpp\"");
  out.line("#include \"pal/runtime/task.hpp\"");
  open_namespace(out, plan);
  bool forward = false;
  for (const PlannedModule& module : plan.modules) {
    for (const std::size_t other : module.executes) {
      out.line("class " + plan.modules[other].type + ";");
      forward = true;
    }
  }
  if (forward) out.line();
  for (const PlannedStore& store : plan.stores) write_store(out, plan, store);
  for (const PlannedModule& module : plan.modules) {
    if (&module != &plan.modules.front()) out.line();
    write_class(out, plan, module);
  }
  close_namespace(out, plan);
  return out.take();
}

/// The body of the block that `threads` run, wherever it stands in `body`.
const PlannedBody* find_block(const PlannedBody& body, const std::vector<std::size_t>& threads) {
  for (const PlannedStatement& statement : body) {
    for (std::size_t i = 0; i < statement.branches.size(); ++i) {
      if (i < statement.threads.size() && statement.threads[i] == threads) return &statement.branches[i];
      if (const PlannedBody* found = find_block(statement.branches[i], threads)) return found;
    }
  }
  return nullptr;
}

std::string source_name(const Plan& plan) {
  return plan.file + "_modules.cpp";
}

void write_function(Writer& out, const Plan& plan, const PlannedModule& module, const std::string& name,
                    const PlannedBody& body, const EmitOptions& options) {
  const std::string thread = uses_thread(body) ? "runtime::Thread& thread" : "runtime::Thread&";
  out.line();
  out.open("runtime::Task " + module.type + "::" + name + "(" + thread + ") {");
  write_body(out, plan, module, body, options);
  out.stands_for_itself(source_name(plan));
  out.line("co_return;");
  out.close();
}

/// Which of a block's threads another begins.
void write_chooser(Writer& out, const Plan& plan, const PlannedModule& module,
                   const PlannedModule::Block& block) {
  out.line();
  out.open("int " + block.chooser + "(const runtime::Thread& thread) {");
  out.line("switch (thread.index()) {").indent();
  for (const std::size_t thread : block.threads) {
    out.line("case thread_of::" + plan.threads[*plan.threads[thread].parent].constant + ":").indent();
    out.line("return thread_of::" + plan.threads[thread].constant + ";").outdent();
  }
  out.line("default:").indent().line("return -1;  // no other thread executes " + module.pal_name).outdent();
  out.close("}");
  out.close();
}

void write_choosers(Writer& out, const Plan& plan, const PlannedModule& module) {
  const auto several = [](const PlannedModule::Block& block) { return !block.chooser.empty(); };
  if (std::none_of(module.blocks.begin(), module.blocks.end(), several)) return;
  out.line("namespace {").line();
  out.line("// Several threads execute " + module.pal_name + "; each has its blocks for itself.");
  for (const PlannedModule::Block& block : module.blocks) {
    if (several(block)) write_chooser(out, plan, module, block);
  }
  out.line().line("}  // namespace").line();
}

void write_start(Writer& out, const Plan& plan, const PlannedModule& module) {
  const bool used = !module.interface.empty();
  out.open("void " + module.type + "::start(const Parameters&" + (used ? " parameters" : "") + ") {");
  if (const PlannedStore* store = store_of(plan, module)) {
    if (&plan.modules[store->keeper] == &module) out.line("messages_ = {};");
  } else {
    for (const std::size_t message : module.messages) out.line(plan.messages[message].variable + "_ = {};");
  }
  if (used) out.line("activities_.start(parameters);");
  out.close();
}

std::string source(const Plan& plan, const EmitOptions& options) {
  Writer out;
  write_heading(out, plan, "The modules of skill " + plan.skill.name + ", statement by statement.");
  out.line("#include \"" + plan.file + "_modules.hpp\"").line();
  out.line("#include \"" + plan.file + "_wiring.hpp\"");
  out.line("#include \"pal/runtime/thread.hpp\"");
  if (options.debug_lines) {
    out.line();
    out.line("// To GCC, a coroutine that stands for lines of another file is not of this one.");
    out.line("#if defined(__GNUC__) && !defined(__clang__)");
    out.line("#pragma GCC diagnostic ignored \"-Wsubobject-linkage\"");
    out.line("#endif");
  }
  open_namespace(out, plan);
  out.line("using namespace std::chrono_literals;");
  for (const PlannedModule& module : plan.modules) {
    out.line()
        .line("// " + module.kind + " " + module.pal_name + (module.file.empty() ? "" : ", " + module.file))
        .line();
    write_choosers(out, plan, module);
    write_start(out, plan, module);
    write_function(out, plan, module, "body", module.body, options);
    for (const auto& block : module.blocks) {
      write_function(out, plan, module, block.function, *find_block(module.body, block.threads), options);
    }
  }
  close_namespace(out, plan);
  return out.take();
}

}  // namespace

const PlannedStore* store_of(const Plan& plan, const PlannedModule& module) {
  if (!module.keeper) return nullptr;
  // A module that is executed and has no messages does not need it.
  if (module.executed && module.messages.empty()) return nullptr;
  for (const PlannedStore& store : plan.stores) {
    if (store.keeper == *module.keeper) return &store;
  }
  return nullptr;  // none of them has any message
}

std::vector<GeneratedFile> emit_modules(const Plan& plan, const EmitOptions& options) {
  return {{plan.file + "_modules.hpp", header(plan)}, {source_name(plan), source(plan, options)}};
}

}  // namespace pal::codegen
