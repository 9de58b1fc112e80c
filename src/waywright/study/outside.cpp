#include "waywright/study/outside.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>

#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/import.hpp"

namespace waywright {
namespace {

constexpr double default_seconds = 60.0;
constexpr std::size_t most_output = 64U << 20;

struct Output {
  std::string text;
  bool timed_out = false;
  bool canceled = false;
  int status = 0;
};

/// The pipes to and from a running child, and the end of its time.
class Conversation {
 public:
  Conversation(pid_t child, int in, int out, double seconds, const std::atomic<bool>* cancel)
      : child_{child}, in_{in}, out_{out}, deadline_{Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))}, cancel_{cancel} {}

  /// Feeds and drains the child at once, so that neither waits for the other; then waits for its end, no longer than its time.
  Output hold(const std::string& input) {
    exchange(input);
    if (in_ >= 0) ::close(in_);
    ::close(out_);
    // Closing its output does not end a program.
    siginfo_t ended{};
    while (!is_over() && ::waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0) {
      ::poll(nullptr, 0, 5);
    }
    // Before the child is waited for its group cannot be another's; nothing it started outlives it.
    ::kill(-child_, SIGKILL);
    while (::waitpid(child_, &output_.status, 0) < 0 && errno == EINTR) {
    }
    return std::move(output_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool is_over() {
    if (Clock::now() > deadline_) output_.timed_out = true;
    if (cancel_ != nullptr && cancel_->load()) output_.canceled = true;
    return output_.timed_out || output_.canceled;
  }

  void exchange(const std::string& input) {
    std::size_t written = 0;
    ::fcntl(in_, F_SETFL, O_NONBLOCK);
    std::array<char, 1 << 16> block;
    while (!is_over()) {
      std::array<pollfd, 2> fds{pollfd{out_, POLLIN, 0}, pollfd{in_, POLLOUT, 0}};
      ::poll(fds.data(), fds.size(), 50);
      if (in_ >= 0 && (fds[1].revents & (POLLOUT | POLLERR | POLLHUP)) != 0) {
        const ssize_t n = ::write(in_, input.data() + written, input.size() - written);
        if (n > 0) written += static_cast<std::size_t>(n);
        if (written == input.size() || (n < 0 && errno != EAGAIN)) {
          ::close(in_);
          in_ = -1;
        }
      }
      if ((fds[0].revents & (POLLIN | POLLHUP)) != 0) {
        const ssize_t n = ::read(out_, block.data(), block.size());
        if (n <= 0) return;
        output_.text.append(block.data(), static_cast<std::size_t>(n));
        if (output_.text.size() > most_output) {
          ::kill(-child_, SIGKILL);
          return;
        }
      }
    }
  }

  pid_t child_;
  int in_, out_;
  Clock::time_point deadline_;
  const std::atomic<bool>* cancel_;
  Output output_;
};

}  // namespace

Plan run_outside(const Problem& problem, const std::string& command, const std::atomic<bool>* cancel) {
  const auto fail = [&](Status status, std::string reason) { return failed_plan(problem, {status, std::move(reason), {}, {}}); };
  const std::string input = scenario_json(problem.scenario());
  std::array<int, 2> to_child{}, from_child{};
  if (::pipe2(to_child.data(), O_CLOEXEC) != 0) return fail(Status::no_path, "no pipe for the outside planner");
  if (::pipe2(from_child.data(), O_CLOEXEC) != 0) {
    ::close(to_child[0]);
    ::close(to_child[1]);
    return fail(Status::no_path, "no pipe for the outside planner");
  }
  const pid_t child = ::fork();
  if (child == 0) {
    ::setpgid(0, 0);
    ::dup2(to_child[0], STDIN_FILENO);
    ::dup2(from_child[1], STDOUT_FILENO);
    ::signal(SIGPIPE, SIG_DFL);
    ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(to_child[0]);
  ::close(from_child[1]);
  if (child < 0) {
    ::close(to_child[1]);
    ::close(from_child[0]);
    return fail(Status::no_path, "the outside planner could not be started");
  }
  ::setpgid(child, child);
  const double seconds = problem.scenario().budget.seconds.value_or(default_seconds);
  const auto begin = std::chrono::steady_clock::now();
  const Output output = Conversation{child, to_child[1], from_child[0], seconds, cancel}.hold(input);
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  Plan plan;
  std::vector<PoseSpeed> speeds;
  if (output.canceled) {
    plan = fail(Status::canceled, "canceled");
  } else if (output.timed_out) {
    plan = fail(Status::timed_out, fmt::format("the outside planner did not end within {} s", seconds));
  } else if (!WIFEXITED(output.status) || WEXITSTATUS(output.status) != 0) {
    plan = fail(Status::no_path, fmt::format("the outside planner ended with status {}", WIFEXITED(output.status) ? WEXITSTATUS(output.status) : -1));
  } else if (auto path = parse_poses_csv(output.text, "output of the outside planner", nullptr, &speeds)) {
    plan = judge_imported(problem, std::move(*path), std::move(speeds));
  } else {
    plan = fail(Status::no_path, path.error().message());
  }
  plan.planner = "exec";
  plan.timing.plan = took;
  plan.reproducible = false;
  return plan;
}

}  // namespace waywright
