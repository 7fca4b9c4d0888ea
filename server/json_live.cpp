#include "server/json_live.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace pal::server {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of binary frames are little endian");

// The most live data for one client of a cell that runs quicker than the wall, in a second of the wall. At
// the pace of the wall all channels at their full rate are a quarter of it.
constexpr double most_bytes_a_second = 4e6;
constexpr double quick = 2;  // times as quick as the wall
// A number takes four times as long as text as in a binary frame.
constexpr double text_costs = 4;
// Rows of a channel come to a client at most so often, however quick the cell is; some may be a little early.
constexpr std::chrono::nanoseconds rows_period = std::chrono::nanoseconds(1'000'000'000 / 30);
constexpr std::chrono::milliseconds early(20);
// No rows have come for so long: the cell stands.
constexpr std::chrono::milliseconds stands(100);

std::string notification(const char* method, Json params) {
  return dump({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

void add_numbers(std::string& bytes, const std::vector<double>& numbers) {
  const std::size_t begin = bytes.size();
  bytes.resize(begin + numbers.size() * sizeof(double));
  std::memcpy(bytes.data() + begin, numbers.data(), numbers.size() * sizeof(double));
}

/// The head's length in four bytes, the head as JSON with spaces up to a multiple of 8, then numbers.
std::string frame_head(const Json& head) {
  std::string text = dump(head);
  constexpr std::size_t length_size = sizeof(std::uint32_t), unit = sizeof(double);
  while ((length_size + text.size()) % unit != 0) text += ' ';
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string bytes(length_size, '\0');
  std::memcpy(bytes.data(), &length, length_size);
  return bytes + text;
}

Json span_json(const SampleSpan& span) {
  return {{"begin_s", seconds(span.begin)},
          {"end_s", seconds(span.end)},
          {"count", span.count},
          {"low", span.low},
          {"high", span.high},
          {"last", span.last}};
}

std::string spans_as_text(const std::string& channel, const std::vector<SampleSpan>& spans,
                          std::uint64_t dropped) {
  Json params{{"channel", channel}, {"spans", Json::array()}, {"dropped", dropped}};
  for (const SampleSpan& span : spans) params["spans"].push_back(span_json(span));
  return notification("samples", std::move(params));
}

std::string spans_as_bytes(const std::string& channel, const std::vector<SampleSpan>& spans,
                           std::uint64_t dropped) {
  std::string bytes = frame_head({{"channel", channel},
                                  {"spans", spans.size()},
                                  {"fields", spans.front().last.size()},
                                  {"dropped", dropped}});
  for (const SampleSpan& span : spans) {
    add_numbers(bytes, {seconds(span.begin), seconds(span.end), static_cast<double>(span.count)});
    add_numbers(bytes, span.low);
    add_numbers(bytes, span.high);
    add_numbers(bytes, span.last);
  }
  return bytes;
}

Json scan_json(const Profile& profile) {
  Json json{{"scanned", profile.scanned}, {"missing", Json::array()}, {"marks", Json::array()}};
  for (const auto& [from, to] : profile.missing) json["missing"].push_back({from, to});
  for (const ProfileMark& mark : profile.marks) {
    Json one{{"name", mark.name}, {"points", mark.points}};
    if (mark.value) {
      one["value"] = *mark.value;
      one["unit"] = mark.unit;
    }
    json["marks"].push_back(std::move(one));
  }
  return json;
}

Json limit_json(const ShownLimit& limit) {
  static constexpr std::array kinds{"band", "target", "stop", "error"};
  Json json{{"skill", limit.skill},   {"parameter", limit.parameter},
            {"fields", limit.fields}, {"factor", limit.factor},
            {"both", limit.both},     {"kind", kinds[static_cast<std::size_t>(limit.kind)]}};
  if (limit.around)
    json["around"] = {{"parameter", limit.around->parameter}, {"factor", limit.around->factor}};
  return json;
}

std::string profile_as_text(Duration time, const Profile& profile, std::uint64_t dropped) {
  Json params{{"time_s", seconds(time)}, {"y_mm", profile.y}, {"z_mm", profile.z}, {"dropped", dropped}};
  params.update(scan_json(profile));
  return notification("profile", std::move(params));
}

std::string profile_as_bytes(const std::string& channel, Duration time, const Profile& profile,
                             std::uint64_t dropped) {
  Json head{
      {"channel", channel}, {"time_s", seconds(time)}, {"points", profile.y.size()}, {"dropped", dropped}};
  head.update(scan_json(profile));
  std::string bytes = frame_head(head);
  add_numbers(bytes, profile.y);
  add_numbers(bytes, profile.z);
  return bytes;
}

std::string rows_as_text(const Rows& rows, std::size_t fields, std::uint64_t dropped) {
  Json params{{"channel", rows.channel},
              {"time_s", seconds(rows.time)},
              {"rows", Json::array()},
              {"dropped", dropped}};
  for (std::size_t at = 0; at + fields <= rows.numbers.size(); at += fields)
    params["rows"].push_back(
        std::vector<float>(rows.numbers.begin() + static_cast<std::ptrdiff_t>(at),
                           rows.numbers.begin() + static_cast<std::ptrdiff_t>(at + fields)));
  return notification("rows", std::move(params));
}

std::string rows_as_bytes(const Rows& rows, std::size_t fields, std::uint64_t dropped) {
  std::string bytes = frame_head({{"channel", rows.channel},
                                  {"time_s", seconds(rows.time)},
                                  {"rows", rows.numbers.size() / fields},
                                  {"fields", fields},
                                  {"dropped", dropped}});
  const std::size_t begin = bytes.size();
  bytes.resize(begin + rows.numbers.size() * sizeof(float));
  std::memcpy(bytes.data() + begin, rows.numbers.data(), rows.numbers.size() * sizeof(float));
  return bytes;
}

}  // namespace

void LiveView::watch_telemetry(Duration period) {
  period_ = period;
  due_ = {};
}

void LiveView::watch_channels(const Members& members) {
  const Json* list = members.find("channels");
  if (list == nullptr || !list->is_array()) fail(bad_parameters, "'channels' is a list of objects");
  static const Channels none;
  const Channels& all = channels_ != nullptr ? *channels_ : none;
  std::vector<Watched> watched;
  for (const Json& each : *list) {
    if (!each.is_object() || !each.contains("channel") || !each["channel"].is_string())
      fail(bad_parameters, "each of 'channels' has the name of a channel: \"channel\"");
    const std::string name = each["channel"];
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Channel& one) { return one.name == name; });
    if (found == all.end())
      fail(Refusal::Why::absent, fmt::format("there is no channel '{}'", name.substr(0, 60)),
           "channels.list names those that there are");
    const auto at = static_cast<std::size_t>(found - all.begin());
    if (std::any_of(watched.begin(), watched.end(), [&](const Watched& one) { return one.channel == at; }))
      fail(bad_parameters, fmt::format("the channel '{}' is there twice", name));
    double period = 0.05;
    if (const auto given = each.find("period_s"); given != each.end()) {
      if (!given->is_number() || !(given->get<double>() >= 0.001 && given->get<double>() <= 3600))
        fail(bad_parameters, "'period_s' is a number from 0.001 to 3600");
      period = given->get<double>();
    }
    bool binary = false;
    if (const auto given = each.find("binary"); given != each.end()) {
      if (!given->is_boolean()) fail(bad_parameters, "'binary' must be true or false");
      binary = given->get<bool>();
    }
    const Duration time(std::llround(period * 1e9));
    watched.push_back({at, binary, time, Decimator(found->fields.size(), time)});
  }
  watched_ = std::move(watched);
}

void LiveView::show(const std::shared_ptr<const Telemetry>& telemetry) {
  if (!looks() || telemetry->time < due_) return;
  due_ = telemetry->time + period_;
  output_.send_sample({[telemetry](std::uint64_t dropped) {
    return notification("telemetry", {{"time_s", seconds(telemetry->time)},
                                      {"force", telemetry->force},
                                      {"pose", telemetry->pose},
                                      {"joints", telemetry->joints},
                                      {"dropped", dropped}});
  }});
}

void LiveView::show(Duration time, const std::shared_ptr<const Profile>& profile) {
  bool sent = false;
  for (Watched& each : watched_) {
    const Channel& channel = (*channels_)[each.channel];
    if (channel.form != Channel::Form::profile) continue;
    if (time < each.due) continue;
    each.due = time + each.period;
    sent = !each.binary;
    if (each.binary)
      output_.send_sample({[name = channel.name, time, profile](std::uint64_t dropped) {
                             return profile_as_bytes(name, time, *profile, dropped);
                           },
                           true});
  }
  if (sent || looks())
    output_.send_sample(
        {[time, profile](std::uint64_t dropped) { return profile_as_text(time, *profile, dropped); }});
}

Duration LiveView::least_span(double pace) const {
  const auto bytes_a_second = [&](Duration least) {
    double sum = 0;
    for (const Watched& each : watched_) {
      const Channel& channel = (*channels_)[each.channel];
      if (channel.form != Channel::Form::numbers) continue;
      const double bytes = static_cast<double>((3 + 3 * channel.fields.size()) * sizeof(double));
      sum += (each.binary ? bytes : text_costs * bytes) / seconds(std::max(each.period, least));
    }
    return pace * sum;
  };
  Duration least = std::chrono::milliseconds(1);
  if (pace < quick) return least;
  // Powers of two: the places of longer spans on the clock are places of shorter ones, too.
  while (bytes_a_second(least) > most_bytes_a_second) least *= 2;
  return least;
}

void LiveView::show(const ShownBlock& block) {
  const Duration least = least_span(block.block().pace);
  for (Watched& each : watched_) {
    const Channel& channel = (*channels_)[each.channel];
    if (channel.form != Channel::Form::numbers) continue;
    std::vector<SampleSpan> spans;
    each.decimator.take(block.block().times, block.of(each.channel), spans, least);
    if (spans.empty()) continue;
    std::uint64_t samples = 0;
    for (const SampleSpan& span : spans) samples += span.count;
    output_.send_sample(
        {[name = channel.name, spans = std::move(spans), binary = each.binary](std::uint64_t dropped) {
           return binary ? spans_as_bytes(name, spans, dropped) : spans_as_text(name, spans, dropped);
         },
         each.binary, samples});
  }
}

void LiveView::show(const std::shared_ptr<const Rows>& rows) {
  for (Watched& each : watched_) {
    const Channel& channel = (*channels_)[each.channel];
    if (channel.form != Channel::Form::rows || channel.name != rows->channel) continue;
    each.came = clock_();
    each.late = rows;
    if (rows->time >= each.due && each.came + early >= each.due_on_the_wall) send(each, rows);
  }
}

void LiveView::begin() {
  if (latest_ == nullptr) return;
  for (Watched& each : watched_) {
    const auto found = latest_->find((*channels_)[each.channel].name);
    if (found != latest_->end()) send(each, found->second);
  }
}

void LiveView::catch_up() {
  for (Watched& each : watched_)
    if (each.late && clock_() - each.came >= stands) send(each, std::exchange(each.late, nullptr));
}

void LiveView::send(Watched& watched, const std::shared_ptr<const Rows>& rows) {
  const Channel& channel = (*channels_)[watched.channel];
  watched.late = nullptr;
  // As spans: the places on the clock are those of all clients.
  watched.due = (rows->time / watched.period + 1) * watched.period;
  watched.due_on_the_wall = std::max(watched.due_on_the_wall, clock_()) + rows_period;
  output_.send_sample(
      {[rows, fields = channel.fields.size(), binary = watched.binary](std::uint64_t dropped) {
         return binary ? rows_as_bytes(*rows, fields, dropped) : rows_as_text(*rows, fields, dropped);
       },
       watched.binary});
}

Json describe(const Channel& channel) {
  Json json{{"channel", channel.name}, {"description", channel.description}, {"fields", Json::array()}};
  for (const ChannelField& field : channel.fields)
    json["fields"].push_back({{"name", field.name}, {"unit", field.unit}});
  json["rate_hz"] = channel.rate_hz;
  static constexpr std::array forms{"numbers", "profile", "rows"};
  json["form"] = forms[static_cast<std::size_t>(channel.form)];
  json["limits"] = Json::array();
  for (const ShownLimit& limit : channel.limits) json["limits"].push_back(limit_json(limit));
  return json;
}

}  // namespace pal::server
