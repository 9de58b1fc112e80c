#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <set>

#include "commands.hpp"

namespace waywright::app {

namespace fs = std::filesystem;

namespace {

/// Names come from files: what a terminal would take for a command (C0 and C1 control characters) becomes
/// '?'.
std::string printable(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool c1 = c == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) >= 0x80 &&
                    static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (c1) ++i;
    out += c1 || c == 0x7F || (c < 0x20 && c != '\n' && c != '\t') ? '?' : static_cast<char>(c);
  }
  return out;
}

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
  std::fprintf(stderr, "waywright: %s\n", printable(error.message()).c_str());
  return bad_input;
}

void note(const std::string& sentence) {
  // Maps that several scenarios share, or overlays of one file, have the same to say each time.
  static std::set<std::string> told;
  if (!told.insert(sentence).second) return;
  std::fprintf(stderr, "waywright: %s\n", printable(sentence).c_str());
}

void note_all(const std::vector<std::string>& repairs, const std::vector<std::string>& warnings) {
  for (const std::string& repair : repairs) note("note: " + repair);
  for (const std::string& warning : warnings) note("warning: " + warning);
}

bool print(const std::string& text) { return print_raw(printable(text)); }

bool print_raw(const std::string& text) {
  errno = 0;
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) == 0 && whole) return true;
  if (errno != EPIPE) note(std::string{"standard output cannot be written to: "} + std::strerror(errno));
  return false;
}

fs::path examples_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "waywright" / "examples";
  if (!error && fs::exists(installed, error)) return installed;
  return WAYWRIGHT_EXAMPLES_DIR;
}

}  // namespace waywright::app
