#include "runtime/drivers/val/alter_opener.hpp"

#include <utility>

namespace pal::runtime::drivers::val {

void AlterOpener::open(const alter::Mode& mode, Done done) {
  // The sum that DO ALTER( … ) takes: 1 cumulative, 2 world, 4 joints.
  const double sum = (mode.cumulative ? 1 : 0) + (mode.world ? 2 : 0) + (mode.joints ? 4 : 0);
  submit({.verb = Verb::open_alter, .location = {}, .second = {}, .figures = {sum}}, std::move(done));
}

void AlterOpener::close(Done done) {
  submit({.verb = Verb::close_alter, .location = {}, .second = {}, .figures = {}}, std::move(done));
}

void AlterOpener::submit(Command command, Done done) {
  terminal_.submit(std::move(command), [done = std::move(done)](const Answer& answer) {
    done(answer.ok ? std::string() : answer.text);
  });
}

}  // namespace pal::runtime::drivers::val
