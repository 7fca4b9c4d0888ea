// Runs that can be looked at again: what is kept of each channel, pages of it, limits, and what a damaged
// file does.
#include "server/run_recording.hpp"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "server/access.hpp"
#include "server/disk_file.hpp"
#include "tests/unit/server/session_support.hpp"

using namespace pal;
using namespace pal::server;
using namespace std::chrono_literals;
using Json = nlohmann::json;

namespace {

Channels recorded_channels() {
  Channels result;
  result.push_back({"force", "", {{"fx", "N"}}, 1000, Channel::Form::numbers, [](auto raw, auto shown) {
                      shown[0] = raw[0];
                    }});
  result.push_back({"profile", "", {{"y", "mm"}, {"z", "mm"}}, 0, Channel::Form::profile});
  result.push_back({"poses", "", {{"x", "m"}, {"y", "m"}}, 29, Channel::Form::rows});
  return result;
}

/// Samples of a channel, each a millisecond after the other.
std::shared_ptr<const SampleBlock> samples(Duration begin, std::size_t count, double value) {
  auto block = std::make_shared<SampleBlock>();
  block->width = 1;
  block->raw.assign(count, value);
  for (std::size_t i = 0; i < count; ++i)
    block->times.push_back(begin + static_cast<std::int64_t>(i) * Duration(1ms));
  return block;
}

std::vector<std::shared_ptr<const Rows>> rows(Duration time, std::vector<float> numbers) {
  return {std::make_shared<const Rows>(Rows{"poses", time, std::move(numbers)})};
}

struct RecordingFolder {
  RecordingFolder() { std::filesystem::create_directories(path); }
  ~RecordingFolder() { std::filesystem::remove_all(path); }
  std::string file() const { return path + "/recording.sqlite"; }
  std::string path = std::filesystem::temp_directory_path() / ("pal-recording-" + make_token());
};

}  // namespace

TEST_CASE("recording: each channel of a run comes back, page by page") {
  const Channels channels = recorded_channels();
  RunRecording recording("", channels);
  CHECK_FALSE(recording.records());
  recording.take(rows(0s, {9, 9}));
  recording.begin(7, 1s);
  CHECK(recording.records());
  for (int i = 0; i < 10; ++i) recording.take(rows(1s + i * 34ms, {static_cast<float>(i), 0, 1, 2}));
  for (int i = 0; i < 5; ++i) recording.take(samples(1s + i * 40ms, 40, i == 2 ? 12.5 : 1));
  Profile profile;
  profile.y = {-1, 1};
  profile.z = {200, 201};
  recording.take(1100ms, profile);
  recording.end(1500ms);

  const auto list = recording.list();
  REQUIRE(list.size() == 1);
  CHECK(list[0].run == 7);
  CHECK(list[0].channels == std::vector<std::string>{"force", "poses", "profile"});
  CHECK(list[0].begin == 1s);

  const RecordedPage first = recording.read(7, "poses", Duration::min(), 6);
  CHECK(first.more);
  REQUIRE(first.times.size() == 6);
  CHECK(first.rows == std::vector<std::uint32_t>(6, 2));
  CHECK(first.numbers.at(4) == 1);
  const RecordedPage rest = recording.read(7, "poses", first.times.back(), 100);
  CHECK_FALSE(rest.more);
  REQUIRE(rest.times.size() == 4);
  CHECK(rest.times.back() == 1306ms);
  CHECK(rest.numbers.at(12) == 9);

  // Of numbers the least, the greatest and the last of each span: the peak is there.
  const RecordedPage force = recording.read(7, "force", Duration::min(), 100);
  CHECK(force.rows.front() == 3);
  CHECK(*std::max_element(force.numbers.begin(), force.numbers.end()) == 12.5F);
  CHECK(recording.read(7, "profile", Duration::min(), 100).numbers == std::vector<float>{-1, 200, 1, 201});
  CHECK(recording.read(7, "nothing", Duration::min(), 100).times.empty());
  CHECK(recording.read(8, "poses", Duration::min(), 100).times.empty());
}

TEST_CASE("recording: what is seen after the end is of no run, but for a block that came late") {
  const Channels channels = recorded_channels();
  RunRecording recording("", channels);
  recording.begin(1, 0s);
  recording.take(rows(100ms, {1, 1}));
  recording.end(200ms);
  recording.take(samples(160ms, 80, 3));  // it lasts over the end
  CHECK_FALSE(recording.records());
  recording.take(rows(300ms, {2, 2}));
  CHECK(recording.read(1, "poses", Duration::min(), 100).times == std::vector<Duration>{100ms});
  const RecordedPage force = recording.read(1, "force", Duration::min(), 100);
  REQUIRE_FALSE(force.times.empty());
  CHECK(force.times.back() <= 200ms);
}

TEST_CASE("recording: a run that goes on after a pause is one, without what was seen between") {
  const Channels channels = recorded_channels();
  RunRecording recording("", channels);
  recording.begin(4, 0s);
  recording.take(rows(100ms, {1, 1}));
  recording.end(200ms);
  recording.take(rows(5s, {7, 7}));
  recording.begin(4, 10s);
  recording.take(rows(10s, {2, 2}));
  recording.end(11s);
  REQUIRE(recording.list().size() == 1);
  CHECK(recording.list()[0].end == 10s);
  CHECK(recording.read(4, "poses", Duration::min(), 100).times == std::vector<Duration>{100ms, 10s});
}

TEST_CASE("recording: the oldest runs go when there are too many, or they take too much") {
  const Channels channels = recorded_channels();
  RunRecording few("", channels, {3, std::uint64_t{1} << 30});
  for (std::uint64_t run = 1; run <= 6; ++run) {
    few.begin(run, run * 1s);
    few.take(rows(run * 1s, {1, 1}));
    few.end(run * 1s + 500ms);
  }
  const auto list = few.list();
  REQUIRE(list.size() == 3);
  CHECK(list.front().run == 6);
  CHECK(list.back().run == 4);

  RecordingFolder folder;
  constexpr std::uint64_t most = 400'000;
  {
    RunRecording small(folder.file(), channels, {1000, most});
    std::uint32_t drawn = 1;
    for (std::uint64_t run = 1; run <= 20; ++run) {
      small.begin(run, run * 1s);
      for (int i = 0; i < 10; ++i) {
        std::vector<float> numbers(2000);
        for (float& each : numbers) each = static_cast<float>((drawn = drawn * 1664525 + 1013904223) >> 8);
        small.take(rows(run * 1s + i * 34ms, numbers));
        small.list();  // it has been taken in
      }
      small.end(run * 1s + 500ms);
    }
    const auto kept = small.list();
    REQUIRE(kept.size() >= 2);
    CHECK(kept.front().run == 20);
    CHECK(kept.size() < 20);
  }
  CHECK(std::filesystem::file_size(folder.file()) < 2 * most);
}

TEST_CASE("recording: another start of the server reads it, and a file that is none is refused") {
  const Channels channels = recorded_channels();
  RecordingFolder folder;
  {
    RunRecording recording(folder.file(), channels);
    recording.begin(3, 0s);
    recording.take(rows(1s, {5, 6}));
  }
  {
    const RunRecording again(folder.file(), channels);
    CHECK(again.read(3, "poses", Duration::min(), 10).numbers == std::vector<float>{5, 6});
  }
  std::ofstream(folder.file(), std::ios::binary | std::ios::trunc) << std::string(8192, 'x');
  std::filesystem::remove(folder.file() + "-wal");
  CHECK_THROWS_AS(RunRecording(folder.file(), channels), StoreProblem);
}

TEST_CASE("recording: clients read it as text of 64 letters") {
  const Channels channels = recorded_channels();
  RunRecording recording("", channels);
  recording.begin(2, 0s);
  recording.take(rows(1s, {1.5F, -2}));
  recording.end(2s);
  test::SessionFixture fixture(json_session);
  fixture.say(R"({"jsonrpc": "2.0", "id": 1, "method": "hello", "params": {"token": "viewers"}})");
  const auto ask = [&](const std::string& method, const Json& params) {
    return Json::parse(
        fixture.say(Json{{"jsonrpc", "2.0"}, {"id", 2}, {"method", method}, {"params", params}}.dump())
            .front());
  };
  CHECK(ask("replay.list", Json::object())["error"]["data"]["why"] == "absent");
  fixture.context.recording = &recording;
  CHECK(ask("replay.list", Json::object())["result"] ==
        Json::parse(R"([{"run": 2, "begin_s": 1.0, "end_s": 1.0, "channels": ["poses"]}])"));
  const Json page = ask("replay.read", {{"run", 2}, {"channel", "poses"}})["result"];
  // 1.5 and -2 as four bytes each.
  CHECK(page["numbers"] == "AADAPwAAAMA=");
  CHECK(page["rows"] == Json({1}));
  CHECK(page["times_s"] == Json({1.0}));
  CHECK(page["more"] == false);
  CHECK(
      ask("replay.read", {{"run", 2}, {"channel", "poses"}, {"after_s", 1.0}})["result"]["times_s"].empty());
  CHECK(ask("replay.read", {{"run", 0}, {"channel", "poses"}})["error"]["code"] == -32602);
  CHECK(ask("replay.read", {{"run", 2}, {"channel", "poses"}, {"after_s", "now"}})["error"]["code"] ==
        -32602);
}
