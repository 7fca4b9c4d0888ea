#include "tests/benchmark/runtime/rows.hpp"

#ifdef PAL_BOOST_FIBER
#include <boost/fiber/buffered_channel.hpp>
#include <boost/fiber/fiber.hpp>

namespace pal::benchmark {

bool fiber_round_trips(std::size_t count) {
  boost::fibers::buffered_channel<int> requests(2), answers(2);
  boost::fibers::fiber server([&] {
    int value = 0;
    while (requests.pop(value) == boost::fibers::channel_op_status::success) answers.push(value);
  });
  boost::fibers::fiber client([&] {
    for (std::size_t i = 0; i < count; ++i) {
      requests.push(1);
      answers.value_pop();
    }
    requests.close();
  });
  client.join();
  server.join();
  return true;
}

}  // namespace pal::benchmark
#else
namespace pal::benchmark {

bool fiber_round_trips(std::size_t) {
  return false;
}

}  // namespace pal::benchmark
#endif
