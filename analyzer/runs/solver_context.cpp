#include "analyzer/runs/solver_context.hpp"

#include <memory>

namespace pal::analyzer {
namespace {

thread_local std::unique_ptr<z3::context> kept_context;

}  // namespace

z3::context& solver_context() {
  if (!kept_context) kept_context = std::make_unique<z3::context>();
  return *kept_context;
}

void renew_solver_context() {
  kept_context.reset();
}

}  // namespace pal::analyzer
