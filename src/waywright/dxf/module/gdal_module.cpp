// GDAL's DXF driver behind a C interface. Linked by nothing: expand.cpp opens it.
#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_api.h>

#include <atomic>
#include <cstdio>
#include <cstring>
#include <exception>
#include <mutex>
#include <string>
#include <vector>

#include "waywright/dxf/module/dxf_module.h"

extern "C" void RegisterOGRDXF();  // of ogrsf_frmts.h, which is C++ and large

namespace {

/// Options of this thread alone, as they were before when it ends.
class Options {
 public:
  Options() {
    set("DXF_MERGE_BLOCK_GEOMETRIES", "FALSE");      // or the layers inside blocks are lost
    set("DXF_FEATURE_LIMIT_PER_BLOCK", "-1");        // or more than 10 000 would be left out silently; counted before it comes here
    set("DXF_ENCODING", "UTF-8");
    set("DXF_TRANSLATE_ESCAPE_SEQUENCES", "FALSE");
  }
  ~Options() {
    for (const auto& [name, value] : before_) CPLSetThreadLocalConfigOption(name.c_str(), value.empty() ? nullptr : value.c_str());
  }
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;

 private:
  void set(const char* name, const char* value) {
    const char* old = CPLGetThreadLocalConfigOption(name, nullptr);
    before_.emplace_back(name, old != nullptr ? old : "");
    CPLSetThreadLocalConfigOption(name, value);
  }
  std::vector<std::pair<std::string, std::string>> before_;
};

/// What GDAL complains of is kept, not printed.
class Quiet {
 public:
  Quiet() {
    CPLErrorReset();
    CPLPushErrorHandler(CPLQuietErrorHandler);
  }
  ~Quiet() { CPLPopErrorHandler(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
};

/// A drawing in memory under a name of its own.
class File {
 public:
  File(const char* text, size_t size) {
    static std::atomic<unsigned long> count{0};
    name_ = "/vsimem/waywright-" + std::to_string(count++) + ".dxf";
    // GDAL does not write to it: it is opened for reading.
    VSILFILE* file = VSIFileFromMemBuffer(name_.c_str(), reinterpret_cast<GByte*>(const_cast<char*>(text)), size, FALSE);
    if (file != nullptr) VSIFCloseL(file);
  }
  ~File() {
    if (set_ != nullptr) GDALClose(set_);
    VSIUnlink(name_.c_str());
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  GDALDatasetH open() {
    const char* const drivers[] = {"DXF", nullptr};
    return set_ = GDALOpenEx(name_.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr);
  }

 private:
  std::string name_;
  GDALDatasetH set_ = nullptr;
};

struct Receiver {
  waywright_dxf_piece piece;
  void* self;
  std::vector<double> xy{};

  bool take(OGRGeometryH geometry, const char* layer, const char* tag) {
    if (geometry == nullptr) return true;
    if (const int parts = OGR_G_GetGeometryCount(geometry); parts > 0) {
      for (int i = 0; i < parts; ++i) {
        if (!take(OGR_G_GetGeometryRef(geometry, i), layer, tag)) return false;
      }
      return true;
    }
    const int count = OGR_G_GetPointCount(geometry);
    xy.clear();
    for (int i = 0; i < count; ++i) {
      xy.push_back(OGR_G_GetX(geometry, i));
      xy.push_back(OGR_G_GetY(geometry, i));
    }
    return piece(self, layer, tag, xy.data(), static_cast<size_t>(count)) == 0;
  }
};

std::string last_of(const std::string& subclasses) {
  const std::size_t at = subclasses.rfind(':');
  return at == std::string::npos ? subclasses : subclasses.substr(at + 1);
}

void tell(const char* what, char* message, size_t size) {
  if (size > 0) std::snprintf(message, size, "%s", what != nullptr && *what != '\0' ? what : "GDAL gives no reason");
}

int read(const char* text, size_t size, Receiver receiver, char* message, size_t message_size) {
  static std::once_flag once;
  std::call_once(once, [] { RegisterOGRDXF(); });
  const Options options;
  const Quiet quiet;
  File file{text, size};
  GDALDatasetH set = file.open();
  OGRLayerH entities = set != nullptr ? GDALDatasetGetLayerByName(set, "entities") : nullptr;
  if (entities == nullptr) return tell(CPLGetLastErrorMsg(), message, message_size), 1;
  const int layer = OGR_FD_GetFieldIndex(OGR_L_GetLayerDefn(entities), "Layer");
  const int tags = OGR_FD_GetFieldIndex(OGR_L_GetLayerDefn(entities), "SubClasses");
  bool going = true;
  while (going) {
    OGRFeatureH feature = OGR_L_GetNextFeature(entities);
    if (feature == nullptr) break;
    const std::string name = OGR_F_GetFieldAsString(feature, layer);
    const std::string tag = last_of(OGR_F_GetFieldAsString(feature, tags));
    going = receiver.take(OGR_F_GetGeometryRef(feature), name.c_str(), tag.c_str());
    OGR_F_Destroy(feature);
  }
  if (going && CPLGetLastErrorType() >= CE_Failure) return tell(CPLGetLastErrorMsg(), message, message_size), 1;
  return 0;
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) int waywright_dxf_module_version(void) { return WAYWRIGHT_DXF_MODULE_VERSION; }

__attribute__((visibility("default"))) int waywright_dxf_read(const char* text, size_t size, waywright_dxf_piece piece,
                                                              void* self, char* message, size_t message_size) {
  try {
    return read(text, size, {piece, self}, message, message_size);
  } catch (const std::exception& e) {
    tell(e.what(), message, message_size);
  } catch (...) {
    tell("unknown", message, message_size);
  }
  return 1;
}

}  // extern "C"
