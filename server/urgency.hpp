// Which of the server's threads come first at a processor. Linux; what the system does not permit is left out.
#pragma once

namespace pal::server {

/// The calling thread answers clients. It asks for short turns, so that it gets the next one soon when it wakes
/// (Linux 6.12 and later).
void answer_soon() noexcept;

/// The calling thread does long work beside those that answer: it gives way to them, and does not take the
/// processor from the thread that wakes it.
void work_beside() noexcept;

}  // namespace pal::server
