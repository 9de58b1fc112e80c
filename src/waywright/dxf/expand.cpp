#include "waywright/dxf/expand.hpp"

#include <dlfcn.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <mutex>

#include "waywright/dxf/module/dxf_module.h"

namespace waywright::dxf {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "libwaywright_dxf.so";

struct Module {
  decltype(&waywright_dxf_read) read = nullptr;
  std::string problem;
};

/// Beside the program (as built), in lib/waywright beside the program's folder, or where it was installed.
std::vector<fs::path> places() {
  std::vector<fs::path> found;
  if (const char* named = std::getenv("WAYWRIGHT_DXF_MODULE")) return {fs::path{named}};
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    found.push_back(program.parent_path() / file_name);
    found.push_back(program.parent_path().parent_path() / WAYWRIGHT_LIBDIR / "waywright" / file_name);
  }
  found.push_back(fs::path{WAYWRIGHT_FULL_LIBDIR} / "waywright" / file_name);
  return found;
}

Module open_module() {
  for (const fs::path& place : places()) {
    std::error_code error;
    if (!fs::exists(place, error)) continue;
    void* library = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);  // stays open until the program ends
    if (library == nullptr) {
      const char* why = ::dlerror();
      return {nullptr, place.string() + " cannot be loaded: " + (why != nullptr ? why : "no reason is given")};
    }
    const auto version = reinterpret_cast<decltype(&waywright_dxf_module_version)>(::dlsym(library, "waywright_dxf_module_version"));
    const auto read = reinterpret_cast<decltype(&waywright_dxf_read)>(::dlsym(library, "waywright_dxf_read"));
    if (version == nullptr || read == nullptr || version() != WAYWRIGHT_DXF_MODULE_VERSION) return {nullptr, place.string() + " is of another version of waywright"};
    return {read, ""};
  }
  return {nullptr, std::string{"the part that reads drawings, "} + file_name + ", is not there"};
}

struct Receiver {
  const std::function<bool(Piece&&)>& take;
  std::exception_ptr thrown;
};

/// Called by the module: nothing is thrown through it.
int receive(void* self, const char* layer, const char* tag, const double* xy, std::size_t points) {
  auto& receiver = *static_cast<Receiver*>(self);
  try {
    Piece piece;
    const std::string token = layer;
    if (token.size() > 1) std::from_chars(token.data() + 1, token.data() + token.size(), piece.layer);
    piece.kind = tag;
    if (piece.kind.starts_with("WW ")) piece.kind.erase(0, 3);
    piece.by_fit_points = piece.kind.ends_with('?');
    if (piece.by_fit_points) piece.kind.pop_back();
    if (const std::size_t mark = piece.kind.find('~'); mark != std::string::npos) {
      std::from_chars(piece.kind.data() + mark + 1, piece.kind.data() + piece.kind.size(), piece.curve.emplace());
      piece.kind.erase(mark);
    }
    piece.points.reserve(points);
    for (std::size_t i = 0; i < points; ++i) piece.points.push_back({xy[2 * i], xy[2 * i + 1]});
    return receiver.take(std::move(piece)) ? 0 : 1;
  } catch (...) {
    receiver.thrown = std::current_exception();
    return 1;
  }
}

}  // namespace

Parsed<void> expand(const std::string& cleaned, const std::string& name, const std::function<bool(Piece&&)>& take) {
  static const Module module = open_module();
  if (module.read == nullptr) {
    return tl::unexpected{InputError{name, "", "DXF cannot be read: " + one_line(module.problem),
                                     "waywright built with GDAL (Debian: libgdal-dev), its libwaywright_dxf.so beside the program or in lib/waywright"}};
  }
  Receiver receiver{take, {}};
  std::array<char, 256> message{};
  const int wrong = module.read(cleaned.data(), cleaned.size(), receive, &receiver, message.data(), message.size());
  if (receiver.thrown) std::rethrow_exception(receiver.thrown);
  if (wrong != 0) return tl::unexpected{InputError{name, "", "GDAL cannot read the drawing: " + one_line(message.data()), "a drawing that CAD programs open"}};
  return {};
}

}  // namespace waywright::dxf
