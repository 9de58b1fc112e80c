#include "waywright/study/generate.hpp"

#include <fmt/format.h>

#include "outputs.hpp"
#include "waywright/core/spelling.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/field_worlds.hpp"
#include "waywright/map/published_maps.hpp"
#include "waywright/map/whale_maps.hpp"

namespace waywright::app {
namespace {

std::string map_yaml(const std::filesystem::path& picture) {
  return fmt::format(
      "image: {}\nmode: trinary\nresolution: {}\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: "
      "0.65\nfree_thresh: 0.196\n",
      picture.filename().string(), warehouse_cell);
}

/// The table, and its map beside it.
int generate_stations(const GenerateArguments& arguments) {
  if (arguments.boxes)
    return complain({"", "--boxes", "it does not go with generate stations", "generate station"});
  std::filesystem::path vehicle_file = arguments.vehicle.value_or(examples_folder() / "vehicles" / "forklift.json");
  const auto vehicle = read_vehicle(vehicle_file);
  if (!vehicle) return complain(vehicle.error());
  const GeneratedSite site = generate_site(arguments.seed, arguments.count.value_or(20), *vehicle);
  if (auto ready = prepare_folder_of(arguments.out); !ready) return complain(ready.error());
  std::filesystem::path picture = arguments.out, yaml = arguments.out;
  picture.replace_extension(".png");
  yaml.replace_extension(".yaml");
  if (arguments.out == picture || arguments.out == yaml)
    return complain({arguments.out.string(), "", "the map has this name", "a name that ends in .csv"});
  std::vector<NamedContent> files{{picture, encode_png(site.map)}, {yaml, map_yaml(picture)}, {arguments.out, site.stations}};
  std::string named = fmt::format("{}, {}, {}", arguments.out.string(), yaml.string(), picture.string());
  if (!arguments.vehicle) {
    // The program's own example lies where it was built or installed: a copy stands beside the table.
    const auto text = read_file(vehicle_file, largest_json);
    if (!text) return complain(text.error());
    vehicle_file = arguments.out;
    vehicle_file.replace_extension(".vehicle.json");
    files.push_back({vehicle_file, *text});
    named += ", " + vehicle_file.string();
  }
  if (auto written = write_files(files); !written) return complain(written.error());
  return print(fmt::format("written: {2}\ncheck it: waywright check {0} --map {1} --vehicle {3} --clearance 0.05\n",
                           arguments.out.string(), yaml.string(), named, vehicle_file.string()))
             ? solved
             : not_solved;
}

int generate_warehouse_map(const GenerateArguments& arguments) {
  if (arguments.boxes)
    return complain({"", "--boxes", "it does not go with generate warehouse", "generate station"});
  const GreyImage image = generate_warehouse(arguments.seed);
  if (auto ready = prepare_folder_of(arguments.out); !ready) return complain(ready.error());
  std::filesystem::path picture = arguments.out;
  picture.replace_extension(".png");
  const std::string yaml = map_yaml(picture);
  if (auto written = write_files({{picture, encode_png(image)}, {arguments.out, yaml}}); !written) return complain(written.error());
  return print(fmt::format("written: {}, {}\n", arguments.out.string(), picture.string())) ? solved : not_solved;
}

int write_scenario(const std::filesystem::path& file, const Scenario& scenario) {
  if (auto ready = prepare_folder_of(file); !ready) return complain(ready.error());
  if (auto written = write_file(file, scenario_json(scenario)); !written) return complain(written.error());
  return print(fmt::format("written: {}\n", file.string())) ? solved : not_solved;
}

}  // namespace

int generate(const GenerateArguments& arguments) {
  if (arguments.name == "stations") return generate_stations(arguments);
  if (arguments.count || arguments.vehicle)
    return complain({"", arguments.count ? "--count" : "--vehicle", "it goes with generate stations alone", "generate stations"});
  if (arguments.name == "warehouse") return generate_warehouse_map(arguments);
  if (const auto published = published_scenario(arguments.name)) {
    if (arguments.boxes) return complain({"", "--boxes", "it does not go with a publication's map", "generate station"});
    return write_scenario(arguments.out, *published);
  }
  if (arguments.name != "station") {
    std::vector<std::string> names{"station", "stations", "warehouse"};
    for (const auto* maps : {&published_map_names(), &whale_map_names(), &field_world_names()}) names.insert(names.end(), maps->begin(), maps->end());
    return complain({"", "generate", fmt::format("\"{}\" is not known{}", arguments.name, meant_instead(arguments.name, names)), "station, stations, warehouse, or a publication's map: see `waywright list maps`"});
  }
  auto scenario = generate_station(arguments.seed, {arguments.boxes});
  if (!scenario) return complain(scenario.error());
  return write_scenario(arguments.out, *scenario);
}

}  // namespace waywright::app
