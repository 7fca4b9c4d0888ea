#include "blink.hpp"

#include "blink_skill.hpp"

namespace {

class Switch final : public pal::skills::blink::BlinkActivities {
 public:
  void start(const pal::skills::blink::Parameters& parameters) override {
    left_ = parameters.times;
    light_.on = false;
  }
  pal::skills::blink::Light toggle() override {
    light_.on = !light_.on;
    --left_;
    return light_;
  }
  bool decide_enough() override { return left_ == 0; }

 private:
  pal::skills::blink::Light light_;
  std::int64_t left_ = 0;
};

}  // namespace

std::unique_ptr<pal::runtime::Skill> blink() {
  return pal::skills::blink::make_blink(std::make_unique<Switch>());
}
