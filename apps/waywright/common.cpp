#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "commands.hpp"

namespace waywright::app {

namespace fs = std::filesystem;

namespace {

constexpr unsigned patience = 3;  // s
constexpr int ended_by_interrupt = 128 + SIGINT;

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_signal(int) {
  if (interrupted.exchange(true)) ::_exit(ended_by_interrupt);
  ::alarm(patience);
}
extern "C" void on_alarm(int) { ::_exit(ended_by_interrupt); }

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

Interruptible::Interruptible() {
  handle(SIGALRM, on_alarm);
  handle(SIGINT, on_signal);
  handle(SIGTERM, on_signal);
}

Interruptible::~Interruptible() {
  ::alarm(0);
  for (const int signal : {SIGINT, SIGTERM, SIGALRM}) handle(signal, SIG_DFL);
}

const std::atomic<bool>* Interruptible::flag() const { return &interrupted; }

int complain(const InputError& error) {
  std::fprintf(stderr, "waywright: %s\n", error.message().c_str());
  return bad_input;
}

bool print(const std::string& text) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  return std::fflush(stdout) == 0 && whole;
}

fs::path examples_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "waywright" / "examples";
  if (!error && fs::exists(installed, error)) return installed;
  return WAYWRIGHT_EXAMPLES_DIR;
}

}  // namespace waywright::app
