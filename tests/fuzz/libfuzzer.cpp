// libFuzzer's entry for one target; with --seeds FOLDER as the only arguments its seeds are written there instead.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/fuzz/mutator.hpp"
#include "tests/fuzz/target.hpp"

using namespace waywright::fuzz;

namespace {

const Target& target() {
  for (const Target& t : targets()) {
    if (t.name == WAYWRIGHT_FUZZ_TARGET) return t;
  }
  std::abort();
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  if (*argc != 3 || std::string{(*argv)[1]} != "--seeds") return 0;
  const std::filesystem::path folder{(*argv)[2]};
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : target().seeds()) {
    std::ofstream{folder / ("seed_" + std::to_string(number++)), std::ios::binary} << seed;
  }
  std::exit(0);
}

/// Broken promises are not caught: they end the run as a crash, with the input kept.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target().run(std::string{reinterpret_cast<const char*>(data), size});
  return 0;
}

/// JSON is mutated as a tree half of the time.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned int seed) {
  if (target().is_json && seed % 2 == 0) {
    const auto json = Mutator::Json::parse(data, data + size, nullptr, false);
    if (!json.is_discarded()) {
      const std::string mutated = Mutator{seed}.tree(json);
      if (mutated.size() <= most) {
        std::copy(mutated.begin(), mutated.end(), data);
        return mutated.size();
      }
    }
  }
  return LLVMFuzzerMutate(data, size, most);
}
