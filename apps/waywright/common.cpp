#include <unistd.h>

#include <cstdio>

#include "commands.hpp"

namespace waywright::app {

namespace fs = std::filesystem;

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
