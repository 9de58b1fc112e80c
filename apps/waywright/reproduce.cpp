#include <fmt/format.h>

#include "outputs.hpp"
#include "waywright/core/spelling.hpp"
#include "waywright/io/files.hpp"
#include "waywright/study/reproduce_rrt_woa.hpp"
#include "waywright/study/reproduce_safe_astar.hpp"

namespace waywright::app {
namespace {

/// What a publication's experiments came to.
struct Reproduced {
  std::string text, csv, svg;
  std::vector<std::string> broken;  ///< printed trends that do not hold, a sentence each
  std::vector<std::string> undecided;  ///< of which these runs tell neither
  int runs = 0;                     ///< that tell
  std::string why_broken;           ///< what may be the reason
};

Reproduced safe_astar(int runs, const std::atomic<bool>* cancel) {
  const auto experiments = reproduction::safe_astar(runs, cancel);
  return {reproduction::text(experiments), reproduction::csv(experiments), reproduction::svg(experiments, 980.0), reproduction::broken_trends(experiments), {}, runs,
          "with the same rules on the reconstructed maps (the printed maps are pictures, and ties are broken by rules that are not told)"};
}

Reproduced whales(int runs, const std::atomic<bool>* cancel) {
  const auto results = rrt_woa::run(runs, cancel);
  rrt_woa::Trends trends = rrt_woa::trends(results);
  return {rrt_woa::text(results), rrt_woa::csv(results), rrt_woa::svg(results, 1100.0), std::move(trends.broken), std::move(trends.undecided), results.runs,
          "on the reconstructed maps (the publication tells neither scale nor map of its study, nor the local variant's cost)"};
}

}  // namespace

int reproduce(const ReproduceArguments& arguments) {
  const std::string& what = arguments.what;
  if (what != "safe_astar" && what != "rrt_woa") return complain({"", "WHAT", fmt::format("\"{}\" is not known{}", what, meant_instead(what, {"safe_astar", "rrt_woa"})), "safe_astar, rrt_woa"});
  const auto folder = arguments.out.value_or(default_folder("reproduce-" + what));
  if (auto ready = prepare_folder(folder); !ready) return complain(ready.error());
  bool is_whole = true;
  Reproduced all = [&] {
    const Interruptible interruptible;
    Reproduced done = what == "safe_astar" ? safe_astar(arguments.runs.value_or(5), interruptible.flag()) : whales(arguments.runs.value_or(100), interruptible.flag());
    is_whole = !*interruptible.flag();
    return done;
  }();
  std::string text = std::move(all.text);
  if (all.broken.empty()) text += all.undecided.empty() ? "\nEvery printed trend holds.\n" : "\nNo printed trend is refuted.\n";
  if (!all.broken.empty()) text += fmt::format("\nPrinted trends that do not hold {}:\n", all.why_broken);
  for (const std::string& sentence : all.broken) text += "  " + sentence + "\n";
  if (!all.undecided.empty()) text += fmt::format("\nPrinted trends of which {} runs a map cannot tell whether they hold (95 % intervals of what the same seeds differ by):\n", all.runs);
  for (const std::string& sentence : all.undecided) text += "  " + sentence + "\n";
  const std::vector<NamedContent> files{{folder / (what + ".txt"), text}, {folder / (what + ".csv"), all.csv}, {folder / (what + ".svg"), all.svg}};
  if (auto written = write_files(files); !written) return complain(written.error());
  text += fmt::format("\nwritten: {0}/{1}.txt, {1}.csv, {1}.svg{2}\n", folder.string(), what, is_whole ? "" : "; interrupted: what was finished is in them");
  return print(text) && is_whole ? solved : not_solved;
}

}  // namespace waywright::app
