// Work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace waywright {

/// Calls `work` on so many threads (0: one a core), at most one a job, this one among them, and waits for all; on fewer where the system gives no
/// more. `work` takes jobs until there are none left, and throws nothing.
void on_threads(unsigned wanted, std::size_t jobs, const std::function<void()>& work);

}  // namespace waywright
