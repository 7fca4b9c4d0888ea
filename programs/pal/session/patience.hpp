// Work that Ctrl-C leaves alone: the program goes on without it, whatever it is at.
#pragma once

#include <functional>

namespace pal::program {

/// Does `work` in a thread of its own, and waits for it; after Ctrl-C (as long as an Interruption lives) only
/// for a moment. False: it is still at work. Then all that it uses must live as long as the program, and the
/// program must end without clearing up (is_work_left). Throws what `work` throws.
bool done_in_patience(const std::function<void()>& work);

/// Notes that some work was left alone.
void leave_work();

/// Whether some work was left alone. Asked at the end of the program, by the thread that left it.
bool is_work_left();

}  // namespace pal::program
