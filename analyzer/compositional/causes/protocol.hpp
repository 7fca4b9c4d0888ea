// The protocol of requests and answers.
#pragma once

#include <functional>
#include <set>
#include <vector>

#include "analyzer/compositional/causes/segment.hpp"
#include "analyzer/compositional/causes/withheld.hpp"

namespace pal::analyzer::compositional {

/// Why requests and answers do not alternate; empty if they do. They alternate on two
/// conditions. The client sends a request only after it has received the last answer, or has timed out. And
/// the server answers each request once, before it receives the next. Then a received answer belongs to the
/// last request, and no request or answer finds its slot full. After `stop` has returned true, what is left
/// counts as alternating.
Why out_of_turn(const Problem& problem, const Segments& segments, const std::function<bool()>& stop,
                const SetAside& set_aside = {});

/// The waits that may receive the answer to the request `send`.
std::set<StepId> takers_of_answer(const Problem& problem, StepId send);

}  // namespace pal::analyzer::compositional
