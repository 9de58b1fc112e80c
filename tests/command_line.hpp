// A folder of its own for each test, and the program run in it.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace waywright::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Outcome {
  int status = -1;
  std::string out, err;
};

inline std::string slurp(const fs::path& path) {
  std::ifstream in{path, std::ios::binary};
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

class CommandLine : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "waywright-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments) const {
    const std::string command = "cd '" + folder_.string() + "' && '" WAYWRIGHT_BINARY "' " + arguments + " >out.txt 2>err.txt </dev/null";
    const int raw = std::system(command.c_str());
    return {WIFEXITED(raw) ? WEXITSTATUS(raw) : 128, slurp(folder_ / "out.txt"), slurp(folder_ / "err.txt")};
  }
  static std::string example(const std::string& name) { return std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name; }

  Json scenario() const { return Json::parse(slurp(example("dock_middle.json"))); }
  std::string write(const Json& json, const std::string& name = "s.json") const {
    Json whole = json;
    if (whole.contains("vehicle") && whole["vehicle"] == "vehicles/forklift.json") whole["vehicle"] = example("vehicles/forklift.json");
    std::ofstream{folder_ / name} << whole.dump();
    return name;
  }

  /// Status 2 and one sentence on standard error that holds these words; nothing on standard output, nothing written.
  void refused(const Outcome& o, const std::vector<std::string>& words) const {
    EXPECT_EQ(o.status, 2) << o.out << o.err;
    EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
    for (const std::string& word : words) EXPECT_NE(o.err.find(word), std::string::npos) << "«" << word << "» is not in: " << o.err;
    EXPECT_TRUE(o.out.empty()) << o.out;
    EXPECT_FALSE(fs::exists(folder_ / "waywright-out"));
  }

  fs::path folder_;
};

}  // namespace waywright::test
