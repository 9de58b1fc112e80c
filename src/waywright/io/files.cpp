#include "waywright/io/files.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cerrno>
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

/// Writes the text beside its target; returns where.
Parsed<fs::path> write_beside(const fs::path& path, const std::string& content) {
  std::error_code error;
  if (fs::is_directory(path, error)) return refuse(path, "the file cannot be written: a folder has its name", "the name of a file");
  if (path.has_parent_path() && !fs::is_directory(path.parent_path(), error)) {
    return refuse(path, fmt::format("there is no folder {}", path.parent_path().string()), "a folder that is there");
  }
  fs::path beside = path;
  beside += fmt::format(".{}.part", ::getpid());
  std::ofstream out{beside, std::ios::binary | std::ios::trunc};
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (out) return beside;
  const std::string why = std::strerror(errno);
  fs::remove(beside, error);
  return refuse(path, "the file cannot be written: " + why);
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

Parsed<void> write_file(const fs::path& path, const std::string& content) { return write_files({{path, content}}); }

Parsed<void> write_files(const std::vector<NamedText>& files) {
  std::vector<fs::path> written;
  std::error_code ignored;
  const auto give_up = [&](InputError error) {
    for (const fs::path& beside : written) fs::remove(beside, ignored);
    return tl::unexpected{std::move(error)};
  };
  for (const NamedText& file : files) {
    auto beside = write_beside(file.path, file.content);
    if (!beside) return give_up(beside.error());
    written.push_back(*beside);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::error_code error;
    fs::rename(written[i], files[i].path, error);
    if (error) return give_up(refuse(files[i].path, "the file cannot be written: " + error.message()).value());
  }
  return {};
}

std::string sha256(const std::string& bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
  std::string text;
  for (unsigned i = 0; i < length; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace waywright
