#include "server/json_call.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pal::server {

void Call::later(std::function<void(const Call&)> use) const {
  context().in_turn([call = *this, alive = home_->alive(), use = std::move(use)] {
    const auto still = alive.lock();
    if (still && *still) use(call);
  });
}

void Call::ask(Command command, std::function<Json(const Done&)> describe) const {
  context().desk.ask(client(), std::move(command),
                     [call = *this, describe = std::move(describe), alive = home_->alive(),
                      turn = context().in_turn](const Reply& reply) {
                       turn([call, describe, alive, reply] {
                         const auto still = alive.lock();
                         if (!still || !*still) return;
                         if (const auto* refusal = std::get_if<Refusal>(&reply)) {
                           call.refuse(problem_of(*refusal));
                         } else {
                           call.result(describe(std::get<Done>(reply)));
                         }
                       });
                     });
}

void Call::ask(Command command) const {
  ask(std::move(command), [](const Done&) { return Json::object(); });
}

namespace {

/// What came of the work: a result, or why there is none.
using Outcome = std::variant<Json, Problem>;

Outcome outcome_of(const std::function<Json(const Workshop::Stop&)>& work, const Workshop::Stop& stop) {
  try {
    if (stop()) return problem_of(Refusal{Refusal::Why::cancelled, "it was cancelled"});
    return work(stop);
  } catch (const Problem& problem) {
    return problem;
  } catch (const std::exception& problem) {
    return problem_of(Refusal{Refusal::Why::failed, problem.what()});
  }
}

constexpr const char* too_many = "too many requests of this client wait";

}  // namespace

void Call::beside(Workshop& workshop, std::function<Json(const Workshop::Stop&)> work) const {
  const auto ticket =
      workshop.submit(client(), [call = *this, alive = home_->alive(), turn = context().in_turn,
                                 work = std::move(work)](const Workshop::Stop& stop) {
        turn([call, alive, outcome = outcome_of(work, stop)] {
          const auto still = alive.lock();
          if (!still || !*still) return;
          call.home_->note_ticket(call.id_, nullptr);
          if (const auto* problem = std::get_if<Problem>(&outcome)) {
            call.refuse(*problem);
          } else {
            call.result(std::get<Json>(outcome));
          }
        });
      });
  if (!ticket) fail(Refusal::Why::too_much, too_many, "wait for their answers, or cancel some");
  home_->note_ticket(id_, ticket);
}

void Call::load(LoadOperation command, std::function<void(LoadOperation&)> find) const {
  home_->hold_commands(true);
  const auto ticket = context().checks.submit(
      client(), [call = *this, alive = home_->alive(), turn = context().in_turn, &desk = context().desk,
                 client = client(), command = std::move(command),
                 find = std::move(find)](const Workshop::Stop& stop) mutable {
        const auto answer = [call, alive, turn](const Outcome& outcome) {
          turn([call, alive, outcome] {
            const auto still = alive.lock();
            if (!still || !*still) return;
            call.home_->note_ticket(call.id_, nullptr);
            if (const auto* problem = std::get_if<Problem>(&outcome)) {
              call.refuse(*problem);
            } else {
              call.result(std::get<Json>(outcome));
            }
            call.home_->hold_commands(false);
          });
        };
        try {
          find(command);
        } catch (const Problem& problem) {
          return answer(problem);
        }
        desk.ask(
            client, std::move(command),
            [answer](const Reply& reply) {
              if (const auto* refusal = std::get_if<Refusal>(&reply)) return answer(problem_of(*refusal));
              answer(Json{{"operation", std::get<Done>(reply).operation}});
            },
            stop);
      });
  if (!ticket) {
    home_->hold_commands(false);
    fail(Refusal::Why::too_much, too_many, "wait for their answers, or cancel some");
  }
  home_->note_ticket(id_, ticket);
}

const Method* find_method(std::string_view name) {
  for (const auto& group : {methods_of_the_cell(), methods_of_controls(), methods_of_operations(),
                            methods_of_texts(), methods_of_the_store()})
    for (const Method& method : group)
      if (method.name == name) return &method;
  return nullptr;
}

}  // namespace pal::server
