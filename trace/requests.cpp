#include "trace/requests.hpp"

#include <map>
#include <set>
#include <string_view>
#include <tuple>

namespace pal::trace {

std::vector<std::int32_t> requests_of(const Trace& tables) {
  using Name = std::tuple<std::string_view, std::string_view, std::string_view>;
  constexpr std::string_view asks = "request ";
  std::map<Name, std::int32_t> requests;  // by who asks, for what, and whom; the first of several
  for (std::size_t c = 0; c < tables.channels.size(); ++c) {
    const Channel& channel = tables.channels[c];
    const std::string_view message = channel.message;
    if (message.starts_with(asks))
      requests.emplace(Name(channel.sender, message.substr(asks.size()), channel.receiver),
                       static_cast<std::int32_t>(c));
  }
  std::set<std::string_view> by_itself;
  for (const Actor& actor : tables.actors)
    if (actor.by_itself) by_itself.insert(actor.name);
  std::vector<std::int32_t> request_of;
  for (const Channel& answer : tables.channels) {
    const auto found = requests.find(Name(answer.receiver, answer.message, answer.sender));
    const bool answers = found != requests.end() && by_itself.count(answer.sender) == 0;
    request_of.push_back(answers ? found->second : -1);
  }
  return request_of;
}

std::vector<std::int32_t> answers_of(const std::vector<std::int32_t>& request_of) {
  std::vector<std::int32_t> answers(request_of.size(), -1);
  for (std::size_t answer = 0; answer < request_of.size(); ++answer)
    if (request_of[answer] >= 0)
      answers[static_cast<std::size_t>(request_of[answer])] = static_cast<std::int32_t>(answer);
  return answers;
}

std::vector<bool> devices_of(const Trace& tables) {
  std::vector<bool> devices;
  for (const Actor& actor : tables.actors) devices.push_back(actor.device);
  return devices;
}

}  // namespace pal::trace
