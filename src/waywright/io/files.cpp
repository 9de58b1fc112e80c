#include "waywright/io/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <memory>

namespace waywright {

namespace fs = std::filesystem;

namespace {

tl::unexpected<InputError> refuse(const fs::path& path, std::string problem, std::string allowed = "") {
  return tl::unexpected{InputError{path.string(), "", std::move(problem), std::move(allowed)}};
}

/// An open stream of a file that is one.
Parsed<std::ifstream> open_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return refuse(path, "there is no such file", "a file that can be read");
  if (fs::is_directory(status)) return refuse(path, "it is a folder", "a file");
  std::ifstream in{path, std::ios::binary};
  if (!in) return refuse(path, "the file cannot be read", "a file that can be read");
  return in;
}

/// Keeps signals that would end the program away while it lives.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) sigaddset(&ending, signal);
    ::pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  ~SignalsWait() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t before_{};
};

/// Writes, brings to the disk and closes; what went wrong, or 0.
int write_whole(const fs::path& path, const std::string& content) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int wrong = 0;
  for (std::size_t written = 0; written < content.size() && wrong == 0;) {
    const ssize_t n = ::write(file, content.data() + written, content.size() - written);
    if (n >= 0) written += static_cast<std::size_t>(n);
    else if (errno != EINTR) wrong = errno;
  }
  // Some file systems have nothing to bring to a disk.
  if (wrong == 0 && ::fsync(file) != 0 && errno != EINVAL && errno != ENOTSUP) wrong = errno;
  if (::close(file) != 0 && wrong == 0 && errno != EINTR) wrong = errno;
  return wrong;
}

}  // namespace

Parsed<std::string> read_file(const fs::path& path, std::uint64_t limit) {
  auto in = open_file(path);
  if (!in) return tl::unexpected{in.error()};
  std::string content;
  std::array<char, 1 << 16> block;
  while (in->read(block.data(), block.size()) || in->gcount() > 0) {
    content.append(block.data(), static_cast<std::size_t>(in->gcount()));
    if (content.size() > limit) return refuse(path, "the file is too large", fmt::format("at most {} bytes", limit));
  }
  if (in->bad()) return refuse(path, "the file cannot be read", "a file that can be read");
  return content;
}

Parsed<std::string> read_head(const fs::path& path, std::size_t count) {
  auto in = open_file(path);
  if (!in) return tl::unexpected{in.error()};
  std::string head(count, '\0');
  in->read(head.data(), static_cast<std::streamsize>(count));
  if (in->bad()) return refuse(path, "the file cannot be read", "a file that can be read");
  head.resize(static_cast<std::size_t>(in->gcount()));
  return head;
}

Parsed<void> write_files(const std::vector<NamedContent>& files) {
  const SignalsWait waiting;
  std::vector<fs::path> beside;
  const auto give_up = [&](const fs::path& path, std::string problem, std::string allowed = "") {
    std::error_code ignored;
    for (const fs::path& part : beside) fs::remove(part, ignored);
    return refuse(path, std::move(problem), std::move(allowed));
  };
  for (const auto& [path, content] : files) {
    std::error_code error;
    if (fs::is_directory(path, error)) return give_up(path, "the file cannot be written: a folder has its name", "the name of a file");
    if (path.has_parent_path() && !fs::is_directory(path.parent_path(), error)) {
      return give_up(path, fmt::format("there is no folder {}", path.parent_path().string()), "a folder that is there");
    }
    beside.push_back(path);
    beside.back() += fmt::format(".{}.part", ::getpid());
    if (const int wrong = write_whole(beside.back(), content); wrong != 0) {
      return give_up(path, fmt::format("the file cannot be written: {}", std::strerror(wrong)));
    }
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::error_code error;
    fs::rename(beside[i], files[i].path, error);
    if (error) return give_up(files[i].path, "the file cannot be written: " + error.message());
  }
  return {};
}

Parsed<void> write_file(const fs::path& path, const std::string& content) { return write_files({{path, content}}); }

std::string sha256(const std::string& bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
  std::string text;
  for (unsigned i = 0; i < length; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace waywright
