#include "skills_pal/jog/jog.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>

#include "jog_skill.hpp"
#include "runtime/drivers/val/protocol.hpp"
#include "skills_pal/jog/advance.hpp"
#include "skills_pal/modules/alter.hpp"
#include "skills_pal/modules/approach.hpp"
#include "skills_pal/modules/overload.hpp"
#include "skills_pal/modules/z_force.hpp"

namespace pal::skills {

namespace {

using namespace jog;

enum Frame : int { joints = 0, world = 1, tool = 2 };

// A tool that presses already may be taken away. It must not press harder by more than this.
constexpr double harder = 5;  // N

class Method final : public SM1Activities {
 public:
  void start(const Parameters& parameters) override {
    parameters_ = parameters;
    const bool turns_only = parameters.frame == joints;
    Axes most{}, step{};
    for (std::size_t i = 0; i < most.size(); ++i) {
      const bool turns = turns_only || i >= 3;
      most[i] = (turns ? parameters.turn : parameters.speed) * alter_period;
      step[i] = turns ? parameters.angle : parameters.way;
    }
    advance_.start(most, step);
    force_ = 0;
    limit_ = parameters.contact_force;
    contact_ = false;
  }

  Command choose_frame() override {
    Command command;
    command.verb = static_cast<std::int64_t>(runtime::drivers::val::Verb::open_alter);
    // The sum: 1, motions add up; 2, in the world; 4, of the joints.
    command.a = 1 + (parameters_.frame == world ? 2 : 0) + (parameters_.frame == joints ? 4 : 0);
    return command;
  }
  bool decide_pc_ok(const Answer& answer) override { return answer.ok; }
  void complain(const Answer& answer) override {
    throw std::runtime_error("VAL: " + std::string(answer.error.view()));
  }

  void note_force(const Zforce& force) override {
    limit_ = std::min(std::max(parameters_.contact_force, force.greatest + harder), greatest_force);
  }
  // By another processor than follow(), which reads it.
  void watch_force(const Zforce& force) override { force_ = force.greatest; }

  Motion follow(const Order& order) override {
    contact_ = force_ >= limit_;
    if (contact_) return {};
    const Axes way = advance_.next({order.a, order.b, order.c, order.d, order.e, order.f});
    Motion motion;
    motion.dx = way[0];
    motion.dy = way[1];
    motion.dz = way[2];
    motion.rx = way[3];
    motion.ry = way[4];
    motion.rz = way[5];
    return motion;
  }
  Motion stand_still() override { return {}; }

  bool decide_pc_held(const Order& order) override { return order.held; }
  bool decide_pc_there() override { return advance_.there(); }
  bool decide_pc_contact() override { return contact_; }

 private:
  Parameters parameters_;
  JogAdvance advance_;
  std::atomic<double> force_ = 0;  // N, the newest
  double limit_ = 0;               // N
  bool contact_ = false;
};

}  // namespace

std::unique_ptr<runtime::Skill> jog_skill() {
  return make_jog(std::make_unique<Method>(), std::make_unique<ZForceSensor<LS1Activities>>(),
                  std::make_unique<AlterController<MC1Activities>>(Late::hold));
}

}  // namespace pal::skills
