// Live data: decimation that loses no peak, blocks, and what a client of the protocol gets of them.
#include "server/channels.hpp"

#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/unit/server/session_support.hpp"

using namespace pal;
using namespace pal::server;
using namespace std::chrono_literals;
using Json = nlohmann::json;

namespace {

/// A block of a channel that shows its raw number, and its double; each a millisecond after the other.
std::shared_ptr<SampleBlock> block_of(Duration begin, const std::vector<double>& values) {
  auto block = std::make_shared<SampleBlock>();
  block->width = 1;
  block->raw = values;
  for (std::size_t i = 0; i < values.size(); ++i)
    block->times.push_back(begin + static_cast<std::int64_t>(i) * Duration(1ms));
  return block;
}

Channels two_channels() {
  Channels result;
  result.push_back(
      {"plain", "as it is", {{"value", "N"}}, 1000, Channel::Form::numbers, [](auto raw, auto shown) {
         shown[0] = raw[0];
       }});
  result.push_back({"both",
                    "as it is, and twice",
                    {{"value", "N"}, {"double", "N"}},
                    1000,
                    Channel::Form::numbers,
                    [](auto raw, auto shown) {
                      shown[0] = raw[0];
                      shown[1] = 2 * raw[0];
                    }});
  result.push_back({"profile", "of the range finder", {}, 0, Channel::Form::profile});
  return result;
}

struct Viewer : test::SessionFixture {
  Viewer() : SessionFixture(json_session) {
    context.channels = &channels;
    open();
    say(R"({"jsonrpc": "2.0", "id": 1, "method": "hello", "params": {"token": "viewers"}})");
  }
  Json ask(const std::string& method, const Json& params) {
    return Json::parse(
        say(Json{{"jsonrpc", "2.0"}, {"id", 2}, {"method", method}, {"params", params}}.dump()).front());
  }
  Json watch(const Json& list) { return ask("channels.watch", {{"channels", list}}); }
  std::vector<std::string> show(Duration begin, const std::vector<double>& values) {
    said.clear();
    session->show(ShownBlock(channels, block_of(begin, values)));
    return said;
  }

  Channels channels = two_channels();
};

}  // namespace

TEST_CASE("a peak of one sample is in the span that has it, however long that is") {
  Decimator decimator(1, 50ms);
  std::vector<SampleSpan> spans;
  for (int block = 0; block < 10; ++block) {
    std::vector<double> values(20, 1.0);
    if (block == 3) values[7] = 40;
    if (block == 6) values[0] = -3;
    const auto made = block_of(block * Duration(20ms), values);
    decimator.take(made->times, made->raw, spans);
  }
  REQUIRE(spans.size() == 4);
  std::size_t count = 0;
  for (const SampleSpan& span : spans) count += span.count;
  CHECK(count == 200);
  CHECK(spans[1].high[0] == 40);
  CHECK(spans[1].low[0] == 1);
  CHECK(spans[1].last[0] == 1);
  CHECK(spans[2].low[0] == -3);
  CHECK(spans[1].begin == 50ms);
  CHECK(spans[1].end == 99ms);
}

TEST_CASE("spans of all clients have the same places on the clock") {
  Decimator early(1, 10ms), late(1, 10ms);
  std::vector<SampleSpan> first, second;
  const auto whole = block_of(3ms, std::vector<double>(40, 0.0));
  early.take(whole->times, whole->raw, first);
  const auto rest = block_of(17ms, std::vector<double>(26, 0.0));
  late.take(rest->times, rest->raw, second);
  REQUIRE(first.size() == 4);
  REQUIRE(second.size() == 3);
  CHECK(first[1].begin == 10ms);
  CHECK(second[0].begin == 17ms);
  CHECK(second[1].begin == first[2].begin);
}

TEST_CASE("a gap in the samples ends a span") {
  Decimator decimator(1, 10ms);
  std::vector<SampleSpan> spans;
  const auto before = block_of(0ms, {1, 2, 3});
  const auto after = block_of(500ms, {4, 5});
  decimator.take(before->times, before->raw, spans);
  decimator.take(after->times, after->raw, spans);
  REQUIRE(spans.size() == 1);
  CHECK(spans[0].count == 3);
  CHECK(spans[0].end == 2ms);
}

TEST_CASE("blocks have what was recorded, and the rest when they are flushed") {
  std::vector<std::shared_ptr<const SampleBlock>> blocks;
  BlockWriter writer(2, {3, 3}, [&](auto block) { blocks.push_back(std::move(block)); });
  for (int i = 0; i < 4; ++i) {
    const auto room = writer.record(i * Duration(1ms));
    room[0] = i, room[1] = -i;
  }
  REQUIRE(blocks.size() == 1);
  CHECK(blocks[0]->size() == 3);
  CHECK(blocks[0]->record(2)[1] == -2);
  writer.flush();
  writer.flush();
  REQUIRE(blocks.size() == 2);
  CHECK(blocks[1]->size() == 1);
  CHECK(blocks[1]->record(0)[0] == 3);
}

TEST_CASE("a quick cell hands on few blocks, and says how quick it is") {
  std::vector<std::shared_ptr<const SampleBlock>> blocks;
  std::chrono::steady_clock::time_point wall;
  BlockWriter writer(
      1, {20, 1000, 15ms}, [&](auto block) { blocks.push_back(std::move(block)); }, [&] { return wall; });
  Duration time = 0ms;
  const auto go = [&](std::size_t records, std::chrono::microseconds each) {
    for (std::size_t i = 0; i < records; ++i) {
      writer.record(time)[0] = 0;
      time += 1ms;
      wall += each;
    }
  };
  go(200, 1000us);
  REQUIRE(blocks.size() == 9);
  CHECK(blocks.back()->size() == 20);
  CHECK(blocks.back()->pace == Approx(0.95));
  writer.flush();
  blocks.clear();
  go(20'001, 10us);
  REQUIRE(blocks.size() == 20);
  CHECK(blocks.back()->size() == 1000);
  CHECK(blocks.back()->pace > 60);
  CHECK(blocks.front()->pace < 60);
}

TEST_CASE("a cell that catches up after a delay is not taken for a quick one") {
  std::vector<std::shared_ptr<const SampleBlock>> blocks;
  std::chrono::steady_clock::time_point wall;
  BlockWriter writer(
      1, {20, 1000, 15ms}, [&](auto block) { blocks.push_back(std::move(block)); }, [&] { return wall; });
  for (int i = 0; i < 1000; ++i) {
    writer.record(i * Duration(1ms));
    // It stands for 300 ms, and goes on when that is made up for.
    wall += i == 500 ? 300ms : i > 500 && i < 800 ? 0ms : 1ms;
  }
  for (const auto& block : blocks) CHECK(block->pace < 2);
}

TEST_CASE("a block that nobody holds any more is filled again, one that is held is not") {
  std::vector<std::shared_ptr<const SampleBlock>> blocks;
  BlockWriter writer(1, {1, 1}, [&](auto block) { blocks.push_back(std::move(block)); });
  const auto write = [&](double value) {
    writer.record(0ms)[0] = value;
    writer.flush();
    return blocks.back().get();
  };
  const SampleBlock* first = write(1);
  CHECK(write(2) != first);
  CHECK(blocks[0]->record(0)[0] == 1);
  blocks.erase(blocks.begin());
  CHECK(write(3) == first);
  CHECK(blocks.back()->size() == 1);
}

TEST_CASE("of a quick cell a client gets as many bytes as it is given, in longer spans that lose no peak") {
  Viewer viewer;
  const auto spans_of = [&](double pace, const Json& period, bool binary) {
    viewer.watch({{{"channel", "plain"}, {"period_s", period}, {"binary", binary}}});
    viewer.said.clear();
    std::vector<double> values(1000, 1.0);
    values[333] = 40;
    auto block = block_of(0ms, values);
    block->pace = pace;
    viewer.session->show(ShownBlock(viewer.channels, block));
    REQUIRE(viewer.said.size() == 1);
    if (binary) {
      const std::string& bytes = viewer.said[0];
      std::uint32_t length = 0;
      std::memcpy(&length, bytes.data(), 4);
      return Json::parse(bytes.substr(4, length))["spans"].get<std::size_t>();
    }
    const Json spans = Json::parse(viewer.said[0])["params"]["spans"];
    std::size_t count = 0;
    double high = 0;
    for (const Json& span : spans) {
      count += span["count"].get<std::size_t>();
      high = std::max(high, span["high"][0].get<double>());
    }
    CHECK(count + spans.back()["count"].get<std::size_t>() >= 1000);
    CHECK(high == 40);
    return spans.size();
  };
  // A span of one field has six numbers: 48 bytes a millisecond, 192 as text, and 4 MB a second are given.
  CHECK(spans_of(0, 0.001, true) == 1000);
  CHECK(spans_of(1, 0.001, false) == 1000);
  CHECK(spans_of(50, 0.001, true) == 1000);
  CHECK(spans_of(100, 0.001, true) == 500);
  CHECK(spans_of(100, 0.001, false) == 125);
  CHECK(spans_of(200, 0.05, false) == 20);
}

TEST_CASE("a client gets the channels that it watches, as text or as bytes") {
  Viewer viewer;
  const Json list = viewer.ask("channels.list", Json::object())["result"];
  REQUIRE(list.size() == 3);
  CHECK(list[1]["fields"][1]["unit"] == "N");
  CHECK(viewer.show(0ms, {1, 2}).empty());
  CHECK(viewer.watch({{{"channel", "nothing"}}})["error"]["data"]["why"] == "absent");
  CHECK(viewer.watch({{{"channel", "plain"}}, {{"channel", "plain"}}})["error"]["data"]["why"] ==
        "bad-parameters");
  CHECK(viewer.watch({{{"channel", "plain"}, {"period_s", 0}}})["error"]["data"]["why"] == "bad-parameters");
  CHECK_FALSE(viewer.session->watches_channels());
  REQUIRE(viewer
              .watch({{{"channel", "plain"}, {"period_s", 0.004}},
                      {{"channel", "both"}, {"period_s", 0.008}, {"binary", true}}})
              .contains("result"));
  CHECK(viewer.session->watches_channels());
  const auto said = viewer.show(0ms, {5, 1, 9, 4, 3, 2, 8, 7});
  REQUIRE(said.size() == 2);
  const Json plain = Json::parse(said[0]);
  CHECK(plain["method"] == "samples");
  REQUIRE(plain["params"]["spans"].size() == 2);
  CHECK(plain["params"]["spans"][0]["high"][0] == 9);
  CHECK(plain["params"]["spans"][1]["last"][0] == 7);
  // Four bytes of length, the head, then numbers at a multiple of eight.
  std::uint32_t length = 0;
  std::memcpy(&length, said[1].data(), 4);
  REQUIRE((4 + length) % 8 == 0);
  const Json head = Json::parse(said[1].substr(4, length));
  CHECK(head["channel"] == "both");
  CHECK(head["spans"] == 1);
  std::vector<double> numbers((said[1].size() - 4 - length) / 8);
  std::memcpy(numbers.data(), said[1].data() + 4 + length, numbers.size() * 8);
  REQUIRE(numbers.size() == 3 + 3 * 2);
  CHECK(numbers[2] == 8);
  CHECK(numbers[3] == 1);
  CHECK(numbers[6] == 18);
  REQUIRE(viewer.watch(Json::array()).contains("result"));
  CHECK_FALSE(viewer.session->watches_channels());
}

TEST_CASE("a profile comes to those who watch it") {
  Viewer viewer;
  const auto profile = std::make_shared<const Profile>(Profile{{1, 2}, {300, 301}});
  const auto show = [&](Duration time) {
    viewer.said.clear();
    viewer.session->show(time, profile);
    return viewer.said;
  };
  CHECK(show(0ms).empty());
  viewer.watch({{{"channel", "profile"}, {"period_s", 0.1}}});
  CHECK(Json::parse(show(0ms).at(0))["params"]["z_mm"][1] == 301);
  CHECK(show(50ms).empty());
  viewer.watch({{{"channel", "profile"}, {"binary", true}}});
  const auto bytes = show(100ms);
  REQUIRE(bytes.size() == 1);
  CHECK(bytes[0].find(R"("points":2)") != std::string::npos);
}

TEST_CASE("a profile says what was seen in it, and where the scan had no range") {
  Viewer viewer;
  Profile profile{{1, 2}, {300, 301}};
  profile.scanned = 4;
  profile.missing = {{1, 3}};
  profile.marks = {{"nearest", {{1, 300}}, 300.0, "mm"}};
  viewer.watch({{{"channel", "profile"}}});
  viewer.session->show(0ms, std::make_shared<const Profile>(profile));
  const Json told = Json::parse(viewer.said.back())["params"];
  CHECK(told["scanned"] == 4);
  CHECK(told["missing"] == Json::array({Json::array({1, 3})}));
  CHECK(told["marks"][0] == Json{{"name", "nearest"},
                                 {"points", Json::array({Json::array({1.0, 300.0})})},
                                 {"value", 300.0},
                                 {"unit", "mm"}});
}
