#include "server/json_call.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pal::server {

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

/// What came of the work: the whole message that answers, or why there is none. It may be long, so the thread
/// of the sockets neither makes nor copies it.
using Outcome = std::shared_ptr<std::variant<std::string, Problem>>;

Outcome outcome(std::variant<std::string, Problem> result) {
  return std::make_shared<std::variant<std::string, Problem>>(std::move(result));
}

Outcome outcome_of(const std::function<Json(const Workshop::Stop&)>& work, const Json& id,
                   const Workshop::Stop& stop) {
  try {
    if (stop()) return outcome(problem_of(Refusal{Refusal::Why::cancelled, "it was cancelled"}));
    return outcome(answer_text(id, work(stop)));
  } catch (const Problem& problem) {
    return outcome(problem);
  } catch (const std::exception& problem) {
    return outcome(problem_of(Refusal{Refusal::Why::failed, problem.what()}));
  }
}

constexpr const char* too_many = "too many requests of this client wait";

}  // namespace

std::string answer_text(const Json& id, const Json& result) {
  return fmt::format(R"({{"jsonrpc":"2.0","id":{},"result":{}}})", dump(id), dump(result));
}

void Call::answer_with(std::variant<std::string, Problem>& outcome) const {
  if (const auto* problem = std::get_if<Problem>(&outcome)) {
    refuse(*problem);
  } else if (answered_) {
    home_->send_message(std::move(std::get<std::string>(outcome)));
  }
}

void Call::beside(Workshop& workshop, std::function<Json(const Workshop::Stop&)> work) const {
  const auto ticket =
      workshop.submit(client(), [call = *this, alive = home_->alive(), turn = context().in_turn,
                                 work = std::move(work)](const Workshop::Stop& stop) {
        turn([call, alive, outcome = outcome_of(work, call.id_, stop)] {
          const auto still = alive.lock();
          if (!still || !*still) return;
          call.home_->note_ticket(call.id_, nullptr);
          call.answer_with(*outcome);
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
            call.answer_with(*outcome);
            call.home_->hold_commands(false);
          });
        };
        try {
          find(command);
        } catch (const Problem& problem) {
          return answer(outcome(problem));
        }
        desk.ask(
            client, std::move(command),
            [answer, call](const Reply& reply) {
              if (const auto* refusal = std::get_if<Refusal>(&reply))
                return answer(outcome(problem_of(*refusal)));
              answer(outcome(answer_text(call.id_, Json{{"operation", std::get<Done>(reply).operation}})));
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
  for (const auto& group :
       {methods_of_the_cell(), methods_of_controls(), methods_of_operations(), methods_of_texts(),
        methods_of_the_store(), methods_of_the_robot(), methods_of_jogs(), methods_of_the_history(),
        methods_of_studies(), methods_of_the_scene()})
    for (const Method& method : group)
      if (method.name == name) return &method;
  return nullptr;
}

}  // namespace pal::server
