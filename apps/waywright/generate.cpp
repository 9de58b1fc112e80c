#include "waywright/study/generate.hpp"

#include <fmt/format.h>

#include "outputs.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/scenario_io.hpp"

namespace waywright::app {
namespace {

int generate_warehouse_map(const GenerateArguments& arguments) {
  if (arguments.boxes)
    return complain({"", "--boxes", "it does not go with generate warehouse", "generate station"});
  const GreyImage image = generate_warehouse(arguments.seed);
  if (auto ready = prepare_folder_of(arguments.out); !ready) return complain(ready.error());
  std::filesystem::path picture = arguments.out;
  picture.replace_extension(".png");
  const std::string yaml = fmt::format(
      "image: {}\nmode: trinary\nresolution: {}\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: "
      "0.65\nfree_thresh: 0.196\n",
      picture.filename().string(), warehouse_cell);
  if (auto written = write_files({{picture, encode_png(image)}, {arguments.out, yaml}}); !written) return complain(written.error());
  return print(fmt::format("written: {}, {}\n", arguments.out.string(), picture.string())) ? solved : not_solved;
}

}  // namespace

int generate(const GenerateArguments& arguments) {
  if (arguments.name == "warehouse") return generate_warehouse_map(arguments);
  if (arguments.name != "station") {
    return complain(
        {"", "generate", fmt::format("\"{}\" is not known", arguments.name), "station, warehouse"});
  }
  auto scenario = generate_station(arguments.seed, {arguments.boxes});
  if (!scenario) return complain(scenario.error());
  if (auto ready = prepare_folder_of(arguments.out); !ready) return complain(ready.error());
  if (auto written = write_file(arguments.out, scenario_json(*scenario)); !written)
    return complain(written.error());
  return print(fmt::format("written: {}\n", arguments.out.string())) ? solved : not_solved;
}

}  // namespace waywright::app
