// The generated code of odd_names.pal, compiled and run.
#include <catch2/catch.hpp>
#include <cmath>

#include "namespace_skill.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
namespace odd = pal::skills::pal_namespace;

namespace {

class Delete final : public odd::DeleteActivities {
 public:
  void start(const odd::Parameters& parameters) override { rounds_ = parameters.pal_register; }
  odd::DeletePalSwitchResult pal_switch() override {
    odd::DeletePalSwitchResult result;
    result.pal_class.pal_int = --rounds_;
    result.pal_class.fields2 = 0.5;
    result.pal_class.ok = true;
    result.pal_class2.value = 7;
    return result;
  }
  void start2(const odd::Class& made, const odd::Class2& force) override {
    CHECK(made.pal_int == rounds_);
    CHECK(force.value == 7);
  }

 private:
  std::int64_t rounds_ = 0;
};

class This final : public odd::ThisActivities {
 public:
  bool decide_new(const odd::Class& made, const odd::Class2& force) override {
    CHECK(made.fields2 == 0.5);
    CHECK(made.ok);
    CHECK(force.value == 7);
    ++decided;
    return made.pal_int == 0;
  }
  odd::Report compose_report() override { return {++reports_}; }

  int decided = 0;

 private:
  double reports_ = 0;
};

class CatchByHand final : public odd::CatchActivities {
 public:
  bool decide_caught() override { return true; }
};

}  // namespace

TEST_CASE("generated code with odd names and every statement runs") {
  auto author = std::make_unique<This>();
  const This& seen = *author;
  const auto skill =
      odd::make_pal_namespace(std::move(author), std::make_unique<Delete>(), std::make_unique<CatchByHand>());
  std::vector<double> reports;
  ScriptedDevice bell("bell", {{"report", true, {{"value", ""}}}, {"ring", false, {}}});
  bell.on_receive = [&](runtime::DeviceHost&, std::size_t, std::span<const double> fields) {
    reports.push_back(fields[0]);
  };
  runtime::Device* devices[] = {&bell};
  NoWorld world;
  const runtime::ParameterValue parameters[] = {{"register", 3}, {"volatile", 0}};
  const auto outcome = runtime::Dispatcher(devices, world).run(*skill, parameters, {.horizon = 1s});
  CHECK(outcome.reason == "Made.");
  CHECK(outcome.code == 0);
  CHECK(seen.decided == 3);
  REQUIRE(reports.size() > 3);
  // Each report once, in order.
  for (std::size_t i = 0; i < reports.size(); ++i) CHECK(reports[i] == static_cast<double>(i + 1));
}

TEST_CASE("parameters are checked against their range and type") {
  odd::Parameters parameters;
  CHECK(odd::set_parameter(parameters, "auto", -1.5));
  CHECK(parameters.pal_auto == -1.5);
  CHECK_THROWS_WITH(odd::set_parameter(parameters, "auto", 1001),
                    "parameter auto is 1001 N*m; it may be from -1.5 to 1000 N*m");
  CHECK_THROWS_WITH(odd::set_parameter(parameters, "register", 2.5),
                    "parameter register is 2.5; it must be a whole number");
  CHECK_THROWS_AS(odd::set_parameter(parameters, "volatile", 2), runtime::ParameterError);
  CHECK_THROWS_AS(odd::set_parameter(parameters, "auto", std::nan("")), runtime::ParameterError);
  CHECK_FALSE(odd::set_parameter(parameters, "pal_auto", 0));
  CHECK(parameters.pal_auto == -1.5);
  CHECK(parameters.pal_register == 2);
}
