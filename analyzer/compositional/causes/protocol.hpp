// Who asks whom, and when: the protocol of requests and answers.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// Where a request is not in turn: in words for the reader, or nothing. Else each is sent only when the
/// answer to the one before has been taken, or given up, by the same thread, and is answered once, before its
/// server takes the next. So an answer that is taken is that to the last request, and neither finds its slot
/// full. Once `stop` says so, it is not looked for any more; what has not been looked at is in turn then.
std::string out_of_turn(const Problem& problem, const Segments& segments, const std::function<bool()>& stop);

/// By channel of requests: whether one may be withdrawn before it is taken, by who gives up waiting for the
/// answer or is cancelled.
std::vector<bool> withdrawn_requests(const Problem& problem);

/// The waits that may take the answer to what `send` asks for.
std::set<int> takers_of_answer(const Problem& problem, int send);

}  // namespace pal::analyzer::compositional
