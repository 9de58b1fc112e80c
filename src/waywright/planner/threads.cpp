#include "waywright/planner/threads.hpp"

#include <algorithm>
#include <system_error>
#include <thread>
#include <vector>

namespace waywright {

void on_threads(unsigned wanted, std::size_t jobs, const std::function<void()>& work) {
  const std::size_t count = std::min<std::size_t>(wanted > 0 ? wanted : std::max(1U, std::thread::hardware_concurrency()), jobs);
  std::vector<std::thread> threads;
  threads.reserve(count);
  try {
    while (threads.size() + 1 < count) threads.emplace_back(work);
  } catch (const std::system_error&) {
    // Those that there are do all of it.
  }
  work();
  for (std::thread& thread : threads) thread.join();
}

}  // namespace waywright
