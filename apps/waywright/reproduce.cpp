#include <fmt/format.h>

#include "outputs.hpp"
#include "waywright/io/files.hpp"
#include "waywright/study/reproduce_safe_astar.hpp"

namespace waywright::app {

int reproduce(const ReproduceArguments& arguments) {
  if (arguments.what != "safe_astar") return complain({"", "WHAT", fmt::format("\"{}\" is not known", arguments.what), "safe_astar"});
  const auto folder = arguments.out.value_or(default_folder("reproduce-safe_astar"));
  if (auto ready = prepare_folder(folder); !ready) return complain(ready.error());
  bool is_whole = true;
  const auto experiments = [&] {
    const Interruptible interruptible;
    auto all = reproduction::safe_astar(arguments.runs, interruptible.flag());
    is_whole = !*interruptible.flag();
    return all;
  }();
  std::string text = reproduction::text(experiments);
  const auto broken = reproduction::broken_trends(experiments);
  text += broken.empty() ? "\nEvery printed trend holds.\n"
                         : fmt::format("\nPrinted trends that do not hold with the same rules on the reconstructed maps (the printed maps are pictures, and ties are broken by rules that are not told):\n");
  for (const std::string& sentence : broken) text += "  " + sentence + "\n";
  const std::vector<NamedContent> files{{folder / "safe_astar.txt", text}, {folder / "safe_astar.csv", reproduction::csv(experiments)}, {folder / "safe_astar.svg", reproduction::svg(experiments, 980.0)}};
  if (auto written = write_files(files); !written) return complain(written.error());
  text += fmt::format("\nwritten: {}/safe_astar.txt, safe_astar.csv, safe_astar.svg{}\n", folder.string(), is_whole ? "" : "; interrupted: what was finished is in them");
  return print(text) && is_whole ? solved : not_solved;
}

}  // namespace waywright::app
