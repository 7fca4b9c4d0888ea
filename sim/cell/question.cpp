#include "sim/cell/question.hpp"

#include <algorithm>
#include <cassert>

namespace pal::sim {
namespace {

constexpr runtime::Time ready_within = std::chrono::seconds(10);
constexpr runtime::Time answer_within = std::chrono::seconds(2);
constexpr runtime::Time grain = std::chrono::milliseconds(1);

/// A session of a driver with one message in it.
class Session final : public runtime::DeviceHost {
 public:
  Session(runtime::drivers::Station& station, std::size_t wanted)
      : station_(station), begun_(station.now()), wanted_(wanted) {}

  runtime::Time now() const override { return station_.now() - begun_; }
  Appointment at(runtime::Time when, std::function<void()> action) override {
    const auto token = station_.timeline().at(begun_ + when, std::move(action));
    return {token.slot, token.generation};
  }
  void cancel(Appointment appointment) override {
    station_.timeline().cancel({appointment.slot, static_cast<std::uint32_t>(appointment.order)});
  }
  bool deliver(std::size_t port, std::span<const double> fields) override {
    if (port == wanted_ && !answer.fields) answer.fields.emplace(fields.begin(), fields.end());
    return true;
  }
  void mark_busy(bool) override {}
  void fault(std::string reason) override { answer.problem = std::move(reason); }

  Answer answer;

 private:
  runtime::drivers::Station& station_;
  runtime::Time begun_;
  std::size_t wanted_;
};

std::size_t port_of(const runtime::drivers::Driver& driver, const std::string& message) {
  const auto& ports = driver.ports();
  const auto port = std::find_if(ports.begin(), ports.end(),
                                 [&](const runtime::PortSpec& each) { return each.message == message; });
  assert(port != ports.end());
  return static_cast<std::size_t>(port - ports.begin());
}

}  // namespace

Answer ask(runtime::drivers::Station& station, runtime::drivers::Driver& driver, const std::string& message,
           bool prepare, const runtime::RunControl* control) {
  // False: it was stopped, or it takes too long.
  const auto pass_until = [&](runtime::Time limit, const auto& done) {
    const runtime::Time end = station.now() + limit;
    while (!done() && station.now() < end && (control == nullptr || !control->stopping()))
      station.idle(grain);
    return done();
  };
  const auto failed = [&](const std::string& problem) {
    const bool stopped = control != nullptr && control->stopping();
    return Answer{{}, driver.name() + ": " + (stopped ? "stopped on request" : problem), stopped};
  };
  if (prepare) {
    driver.prepare();
    if (!pass_until(ready_within, [&] { return driver.ready(); })) return failed("is not ready in time");
  }
  if (!driver.trouble().empty()) return failed(driver.trouble());
  Session session(station, port_of(driver, message));
  driver.attach(session);
  driver.open();
  driver.receive(port_of(driver, "request " + message), {});
  const bool answered =
      pass_until(answer_within, [&] { return session.answer.fields || !session.answer.problem.empty(); });
  driver.close();
  if (!answered) return failed("does not answer");
  if (!session.answer.problem.empty()) return failed(session.answer.problem);
  return session.answer;
}

}  // namespace pal::sim
