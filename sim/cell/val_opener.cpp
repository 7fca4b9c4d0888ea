#include "sim/cell/val_opener.hpp"

#include <utility>

namespace pal::sim {

using runtime::drivers::val::Verb;

void ValOpener::open(const runtime::drivers::alter::Mode& mode, Done done) {
  // The sum that DO ALTER( … ) takes: 1 cumulative, 2 world.
  const double sum = (mode.cumulative ? 1 : 0) + (mode.world ? 2 : 0);
  submit({.verb = Verb::open_alter, .location = {}, .second = {}, .figures = {sum}}, std::move(done));
}

void ValOpener::close(Done done) {
  submit({.verb = Verb::close_alter, .location = {}, .second = {}, .figures = {}}, std::move(done));
}

void ValOpener::submit(runtime::drivers::val::Command command, Done done) {
  terminal_.submit(std::move(command), [done = std::move(done)](const runtime::drivers::val::Answer& answer) {
    done(answer.ok ? std::string() : answer.text);
  });
}

}  // namespace pal::sim
