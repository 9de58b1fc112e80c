#include <fmt/format.h>

#include "commands.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/report/words.hpp"

namespace waywright::app {

int verify(const std::filesystem::path& file) {
  auto plan = read_plan(file);
  if (!plan) return complain(plan.error());
  auto verification = waywright::verify(*plan);
  if (!verification) {
    InputError error = verification.error();
    error.file = file.string();
    return complain(error);
  }
  const Certificate& c = verification->fresh.certificate;
  std::string text;
  if (verification->holds) {
    text = fmt::format(
        "{}: proven again: collision-free over {:.3f} m with {}{} of clearance; start, goal, limits, "
        "continuity, "
        "samples and speed hold{}\n",
        file.string(), c.checked_length, is_beyond_measure(c) ? "" : "at least ", clearance_words(c), plan->scenario.moving.empty() ? "" : "; so do its times, against all that moves as predicted");
  } else {
    text = fmt::format("{}: not proven\n", file.string());
    for (const std::string& finding : verification->findings) text += "  - " + finding + "\n";
  }
  return print(text) && verification->holds ? solved : not_solved;
}

}  // namespace waywright::app
