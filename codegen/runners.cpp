#include "codegen/runners.hpp"

#include <algorithm>

namespace pal::codegen {

namespace {

void add_runner(Plan& plan, const PlannedBody& body, std::size_t thread) {
  for (const PlannedStatement& statement : body) {
    for (std::size_t i = 0; i < statement.branches.size(); ++i) {
      if (statement.kind != PlannedStatement::Kind::concurrent) {
        add_runner(plan, statement.branches[i], thread);
        continue;
      }
      for (const std::size_t block : statement.threads[i]) {
        if (plan.threads[block].parent == thread) add_runner(plan, statement.branches[i], block);
      }
    }
    if (statement.kind != PlannedStatement::Kind::execute || !statement.module) continue;
    PlannedModule& executed = plan.modules[*statement.module];
    if (std::find(executed.runners.begin(), executed.runners.end(), thread) != executed.runners.end())
      continue;
    executed.runners.push_back(thread);
    add_runner(plan, executed.body, thread);
  }
}

}  // namespace

void find_runners(Plan& plan) {
  for (std::size_t t = 0; t < plan.threads.size(); ++t) {
    if (!plan.threads[t].parent) add_runner(plan, plan.modules[plan.threads[t].module].body, t);
  }
}

}  // namespace pal::codegen
