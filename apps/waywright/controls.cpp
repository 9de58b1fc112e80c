#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "numbers.hpp"
#include "outputs.hpp"
#include "waywright/core/spelling.hpp"
#include "waywright/drive/whale_controls.hpp"
#include "waywright/io/controls_io.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/report/controls_picture.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright::app {
namespace {

constexpr double least_period = 0.001, most_period = 1.0;  // s
constexpr double most_commands = 1e6;
constexpr double largest_miss = 0.10;  // m

/// What the whale search is told, described as planners' parameters are.
PlannerDescription whale_description() {
  const WhaleControlOptions o;
  const auto whole = [](std::int64_t value) { return static_cast<double>(value); };
  PlannerDescription d;
  d.name = "woa";
  d.parameters = {
      {.name = "population", .default_value = whole(o.population), .summary = "agents", .low = 2, .high = 10'000, .whole = true},
      {.name = "iterations", .default_value = whole(o.iterations), .summary = "of a search", .low = 1, .high = 100'000, .whole = true},
      {.name = "restarts", .default_value = whole(o.restarts), .summary = "more searches, at most", .low = 0, .high = 1000, .whole = true},
      {.name = "triplets", .default_value = whole(o.triplets), .summary = "commands of a segment, at first", .low = 1, .high = 16, .whole = true},
      {.name = "most_triplets", .default_value = whole(o.most_triplets), .summary = "commands of a segment, at most", .low = 1, .high = 16, .whole = true},
      {.name = "backtracks", .default_value = whole(o.backtracks), .summary = "times that segments before one that fails are searched again", .low = 0, .high = 10'000, .whole = true},
      {.name = "tolerance", .default_value = o.tolerance, .summary = "of a segment's end", .unit = "m", .low = 1e-4, .high = largest_miss},
      {.name = "heading_tolerance", .default_value = o.heading_tolerance, .summary = "of a segment's end", .unit = "rad", .low = 1e-4, .high = pi},
      {.name = "aim", .default_value = o.aim, .summary = "of the same, until which searches go on", .unit = "m", .low = 1e-4, .high = largest_miss},
      {.name = "heading_aim", .default_value = o.heading_aim, .summary = "likewise", .unit = "rad", .low = 1e-4, .high = pi},
      {.name = "heading_weight", .default_value = o.heading_weight, .summary = "w_phi", .unit = "m/rad", .low = 0, .high = 100},
      {.name = "time_weight", .default_value = o.time_weight, .summary = "w_t", .unit = "m/s", .low = 0, .high = 100},
      {.name = "speed_weight", .default_value = o.speed_weight, .summary = "of ending faster than the plan", .unit = "s", .low = 0, .high = 100},
      {.name = "rate_weight", .default_value = o.rate_weight, .summary = "of ending turning otherwise than the plan", .unit = "m s/rad", .low = 0, .high = 100},
      {.name = "least_time", .default_value = o.least_time, .summary = "of a command", .unit = "s", .low = 0.001, .high = 10},
      {.name = "most_time", .default_value = o.most_time, .summary = "of a command", .unit = "s", .low = 0.01, .high = 100},
      {.name = "turn_speed", .default_value = o.turn_speed, .summary = "where the vehicle names no limit", .unit = "rad/s", .low = 0.01, .high = 10},
      {.name = "spacing", .default_value = o.spacing, .summary = "of waypoints, at most", .unit = "m", .low = 0.05, .high = 100},
      {.name = "clearance", .default_value = o.clearance, .summary = "that the track keeps", .unit = "m", .low = 0, .high = 10},
      {.name = "warm", .default_value = o.warm, .summary = "one agent begins as the plan drives the segment"},
      {.name = "a", .default_value = o.whale.start, .summary = "of the whale optimisation algorithm, at the beginning", .low = 0, .high = 100},
      {.name = "b", .default_value = o.whale.spiral, .summary = "of its spiral", .low = -10, .high = 10},
      {.name = "mu", .default_value = o.whale.choice, .summary = "share of its moves that are no spirals", .low = 0, .high = 1},
      {.name = "lambda", .default_value = o.whale.threshold, .summary = "its threshold of |A|", .low = 0, .high = 1e9},
      {.name = "form", .default_value = std::string{"unbiased"}, .summary = "of its moves", .choices = {"unbiased", "published"}},
  };
  return d;
}

WhaleControlOptions whale_options(const Parameters& p) {
  WhaleControlOptions o;
  o.population = whole_number_of(p, "population");
  o.iterations = whole_number_of(p, "iterations");
  o.restarts = whole_number_of(p, "restarts");
  o.triplets = whole_number_of(p, "triplets");
  o.most_triplets = whole_number_of(p, "most_triplets");
  o.backtracks = whole_number_of(p, "backtracks");
  o.tolerance = number_of(p, "tolerance");
  o.heading_tolerance = number_of(p, "heading_tolerance");
  o.aim = number_of(p, "aim");
  o.heading_aim = number_of(p, "heading_aim");
  o.speed_weight = number_of(p, "speed_weight");
  o.rate_weight = number_of(p, "rate_weight");
  o.heading_weight = number_of(p, "heading_weight");
  o.time_weight = number_of(p, "time_weight");
  o.least_time = number_of(p, "least_time");
  o.most_time = number_of(p, "most_time");
  o.turn_speed = number_of(p, "turn_speed");
  o.spacing = number_of(p, "spacing");
  o.clearance = number_of(p, "clearance");
  o.warm = flag_of(p, "warm");
  o.whale = {number_of(p, "a"), number_of(p, "b"), number_of(p, "mu"), number_of(p, "lambda")};
  o.form = word_of(p, "form") == "published" ? WhaleForm::published : WhaleForm::unbiased;
  return o;
}

struct Made {
  std::string json, text;
  std::vector<ControlRow> rows;
  std::optional<WheelTorques> torques{};
  bool is_good = false;
};

std::string line(const char* name, const std::string& value) { return fmt::format("  {:<22} {}\n", name, value); }
std::string error_words(const EndError& e) { return fmt::format("{:.4f} m, {:.4f} rad", e.position, e.heading); }

/// Motors are known of a mecanum base with a mass.
bool has_motors(const Vehicle& vehicle) { return std::holds_alternative<Mecanum>(vehicle.drive) && vehicle.mass > 0.0; }

/// What the exact method is told of a mecanum base's motors.
PlannerDescription exact_description() {
  PlannerDescription d;
  d.name = "exact";
  d.parameters = {
      {.name = "inertia",
       .default_value = 0.0,
       .summary = "of yaw about the origin, without a load; 0: the mass spread evenly over the footprint",
       .unit = "kg m2",
       .low = 0,
       .high = 1e9},
      {.name = "wheel_inertia", .default_value = 0.0, .summary = "of one wheel's spin with its motor's", .unit = "kg m2", .low = 0, .high = 1e6},
      {.name = "rolling_arm", .default_value = 0.0, .summary = "rolling resistance of a wheel over its load", .unit = "m", .low = 0, .high = 10},
      {.name = "max_torque", .default_value = 0.0, .summary = "of a motor at its wheel; 0: no limit", .unit = "N m", .low = 0, .high = 1e9},
      {.name = "max_wheel_speed", .default_value = 0.0, .summary = "0: no limit", .unit = "rad/s", .low = 0, .high = 1e6},
  };
  return d;
}

/// What is set, of what is not what the vehicle's file says. Refused where the vehicle is none that has such motors, or the values fit none.
Parsed<WheelMotors> motors_of(const Plan& plan, const Parameters& p, const Parameters& set, const ControlsArguments& arguments) {
  const Vehicle& vehicle = plan.scenario.vehicle;
  WheelMotors m{number_of(p, "inertia"), number_of(p, "wheel_inertia"), number_of(p, "rolling_arm"), number_of(p, "max_torque"), number_of(p, "max_wheel_speed")};
  if (const auto* mecanum = std::get_if<Mecanum>(&vehicle.drive)) {
    if (!set.contains("wheel_inertia")) m.wheel_inertia = mecanum->wheel_inertia;
    if (!set.contains("rolling_arm")) m.rolling_arm = mecanum->rolling_arm;
    if (!set.contains("max_torque")) m.most_torque = mecanum->max_torque.value_or(0.0);
    if (!set.contains("max_wheel_speed")) m.most_speed = mecanum->max_wheel_speed.value_or(0.0);
  }
  if (arguments.set.empty()) return m;
  const auto refuse = [](const char* field, std::string problem, std::string allowed) {
    return tl::unexpected{InputError{"", field, std::move(problem), std::move(allowed)}};
  };
  if (!std::holds_alternative<Mecanum>(vehicle.drive))
    return refuse("--set", "the exact method's parameters are those of a mecanum base's motors", "a plan of a mecanum base, or --method woa");
  if (!has_motors(vehicle))
    return tl::unexpected{InputError{arguments.plan.string(), "scenario.vehicle.mass", "torques follow from it, and there is none", "a vehicle with a mass"}};
  const double farthest = vehicle.mass * vehicle.footprint.radius() * vehicle.footprint.radius();
  if (m.inertia > farthest)
    return refuse("--set inertia", fmt::format("{:g} is more than the whole mass has at the farthest corner of the footprint", m.inertia),
                  fmt::format("at most {:g} kg m2", farthest));
  if (m.rolling_arm > std::get<Mecanum>(vehicle.drive).wheel_radius)
    return refuse("--set rolling_arm", fmt::format("{:g} is more than the wheel's radius", m.rolling_arm),
                  fmt::format("at most {:g} m", std::get<Mecanum>(vehicle.drive).wheel_radius));
  return m;
}

/// The plan is what it should be, and these motors cannot follow it.
struct TooWeak {
  std::string sentence;
};

/// Which wheel would need more than it has, when, how much, and what it has; of what is over its limit, torque first.
std::string shortfall(const WheelTorques& needed) {
  const WheelMotors& m = needed.motors;
  std::string words;
  if (m.most_torque > 0.0 && needed.greatest_torque > m.most_torque)
    words = fmt::format("the {} wheel needs {:.4g} N m at {:.2f} s, and max_torque is {:.4g} N m", needed.greatest_torque_wheel, needed.greatest_torque, needed.greatest_torque_at, m.most_torque);
  if (m.most_speed > 0.0 && needed.greatest_speed > m.most_speed * (1.0 + of_profile))
    words += fmt::format("{}the {} wheel turns at {:.4g} rad/s at {:.2f} s, and max_wheel_speed is {:.4g} rad/s", words.empty() ? "" : "; ", needed.greatest_speed_wheel, needed.greatest_speed,
                         needed.greatest_speed_at, m.most_speed);
  return words;
}

/// The limits that would do, each that is exceeded rounded up to four digits.
std::string enough(const WheelTorques& needed) {
  const auto rounded_up = [](double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 3.0);
    return std::ceil(value / unit) * unit;
  };
  const WheelMotors& m = needed.motors;
  std::string words;
  if (m.most_torque > 0.0 && needed.greatest_torque > m.most_torque) words = fmt::format("max_torque {:.5g} N m", rounded_up(needed.greatest_torque));
  if (m.most_speed > 0.0 && needed.greatest_speed > m.most_speed * (1.0 + of_profile)) words += fmt::format("{}max_wheel_speed {:.5g} rad/s", words.empty() ? "" : " and ", rounded_up(needed.greatest_speed));
  return words;
}

/// How many times slower the motors need it. Too weak where times are not to be stretched, or no stretching serves.
tl::expected<double, TooWeak> slowing_of(const Plan& plan, double period, const WheelMotors& motors) {
  if (!has_motors(plan.scenario.vehicle)) return 1.0;
  const auto slowing = slowing_within(plan, period, motors);
  if (slowing && *slowing <= 1.0) return 1.0;
  const WheelTorques needed = wheel_torques(plan, exact_controls(plan, period), motors);
  const auto too_weak = [&](const std::string& why, const std::string& otherwise) {
    return tl::unexpected{TooWeak{fmt::format("the motors are too weak for the plan: {}. {}. {} would be enough{}.", shortfall(needed), why, enough(needed), otherwise)}};
  };
  if (!slowing) {
    const double most = most_slowing(plan, period);
    const Plan slow = slowed(plan, most);
    const WheelTorques slowest = wheel_torques(slow, exact_controls(slow, period), motors);
    return too_weak(fmt::format("Driven {:.4g} times slower it is no better: {}", most, shortfall(slowest)), fmt::format(" at the plan's speed, {} so much slower", enough(slowest)));
  }
  if (!plan.scenario.moving.empty()) return too_weak(fmt::format("It would have to be driven {:.3f} times slower, and its times among what moves are proven", *slowing), "");
  if (plan.samples.front().speed > 0.0) return too_weak("It begins in motion, so it cannot be driven slower", "");
  return *slowing;
}

Made exact(const Plan& plan, double period, const WheelMotors& motors, double slowing) {
  const Plan driven = slowing > 1.0 ? slowed(plan, slowing) : plan;
  const ExactControls c = exact_controls(driven, period);
  Made made;
  if (has_motors(plan.scenario.vehicle)) made.torques = wheel_torques(driven, c, motors);
  made.json = controls_json(plan, c, made.torques ? &*made.torques : nullptr, slowing);
  made.rows = c.rows;
  made.is_good = c.end.position < largest_miss;
  made.text = line("method", fmt::format("exact, a command every {:g} s", period)) + line("commands", fmt::format("{}", c.rows.size() - 1)) +
              line("time", fmt::format("{:.2f} s (the plan's {:.2f} s; {} stands on the way)", c.rows.back().t, plan.samples.back().t, c.stands)) +
              line("end error", error_words(c.end) + "; by midpoint odometry " + error_words(c.midpoint_end)) +
              line("greatest deviation", fmt::format("{:.4f} m", c.deviation));
  if (!made.torques) return made;
  const WheelTorques& t = *made.torques;
  made.text += line("wheels", fmt::format("at most {:.3f} N m (at {:.2f} s) and {:.3f} rad/s (at {:.2f} s)", t.greatest_torque, t.greatest_torque_at,
                                          t.greatest_speed, t.greatest_speed_at)) +
               line("work of the motors", fmt::format("driving {:.3f} J, braking {:.3f} J; rolling takes {:.3f} J", t.driving, t.braking, t.rolling_losses));
  if (slowing > 1.0) {
    const WheelTorques needed = wheel_torques(plan, exact_controls(plan, period), motors);
    made.text += line("slowed", fmt::format("{:.3f} times: at the plan's speed a wheel would take {:.3f} N m and turn at {:.3f} rad/s", slowing,
                                            needed.greatest_torque, needed.greatest_speed));
  }
  return made;
}

/// Which segments miss their ends, and by what they may.
std::string arrival_words(const WhaleControls& c, double tolerance, double heading_tolerance) {
  const std::string limits = fmt::format("under {:g} m and {:g} rad", tolerance, heading_tolerance);
  std::size_t off = 0, turned = 0;
  for (const ControlSegment& segment : c.segments) {
    off += segment.end.position < tolerance ? 0 : 1;
    turned += segment.end.heading < heading_tolerance ? 0 : 1;
  }
  if (off + turned == 0) return fmt::format("yes, every segment ends {} off", limits);
  return fmt::format("no: of {} segments {} end that far off in position and {} in heading; {} is asked for", c.segments.size(), off, turned, limits);
}

Made whale(const Problem& problem, const Plan& plan, double period, const Parameters& parameters, std::uint64_t seed) {
  const WhaleControls c = whale_controls(problem, plan, whale_options(parameters), period, seed);
  Made made{controls_json(plan, c, parameters, seed), {}, c.rows, {}, c.collision_free && c.arrives && c.end.position < largest_miss};
  std::size_t triplets = 0, free = 0;
  for (const ControlSegment& segment : c.segments) {
    triplets += segment.triplets.size();
    free += segment.collision_free ? 1 : 0;
  }
  const double exact_time = exact_controls(plan, period).rows.back().t;
  made.text = line("method", fmt::format("woa, simulated in steps of {:g} s", period)) +
              line("segments", fmt::format("{}, {} triplets, {} evaluations", c.segments.size(), triplets, c.evaluations)) +
              line("time", fmt::format("{:.2f} s (exact: {:.2f} s)", c.rows.back().t, exact_time)) + line("end error", error_words(c.end)) +
              line("worst segment", fmt::format("ends {:.4f} m off, {:.4f} rad", c.worst_end, c.worst_heading)) +
              line("arrives", arrival_words(c, number_of(parameters, "tolerance"), number_of(parameters, "heading_tolerance"))) +
              line("collision-free", free == c.segments.size() ? fmt::format("yes, at least {:.4f} m clear at its steps", c.least_clearance)
                                                               : fmt::format("no: {} of {} segments", free, c.segments.size()));
  return made;
}

/// The one sentence, of the plan's file where it is about the plan.
InputError of_plan(InputError error, const std::filesystem::path& file) {
  error.file = file.string();
  return error;
}

Parsed<double> period_of(const ControlsArguments& arguments, const Plan& plan) {
  const auto given = numbers_from(arguments.period, std::array<char, 0>{});
  if (!given || !((*given)[0] >= least_period && (*given)[0] <= most_period)) {
    return tl::unexpected{InputError{"", "--period", fmt::format("\"{}\" is no time of a command", arguments.period), fmt::format("{} to {} s", least_period, most_period)}};
  }
  const double time = plan.samples.back().t;
  if (time / (*given)[0] > most_commands) {
    return tl::unexpected{InputError{"", "--period", fmt::format("{:.0f} s of driving would be more than {:.0f} commands", time, most_commands), "a longer period"}};
  }
  return (*given)[0];
}

}  // namespace

int controls(const ControlsArguments& arguments) {
  const bool is_whale = arguments.method == "woa";
  if (!is_whale && arguments.method != "exact") return complain({"", "--method", fmt::format("\"{}\" is not known{}", arguments.method, meant_instead(arguments.method, {"exact", "woa"})), "exact, woa"});
  if (!is_whale && arguments.seed) return complain({"", "--seed", "the exact method draws no numbers", "--method woa"});
  if (arguments.seed && *arguments.seed > static_cast<std::uint64_t>(INT64_MAX)) return complain({"", "--seed", "the number is out of range", "0 to 9223372036854775807"});
  if (auto once = check_each_key_once(arguments.set); !once) return complain(once.error());
  const PlannerDescription description = is_whale ? whale_description() : exact_description();
  Parameters given;
  for (const std::string& setting : arguments.set) {
    if (auto set = set_parameter(description, given, setting); !set) return complain(set.error());
  }
  const auto parameters = complete_parameters(description, given);
  if (!parameters) return complain(parameters.error());
  if (is_whale && number_of(*parameters, "least_time") > number_of(*parameters, "most_time")) return complain({"", "--set least_time", "it is greater than most_time", "at most that"});
  if (is_whale && number_of(*parameters, "triplets") > number_of(*parameters, "most_triplets")) return complain({"", "--set triplets", "there are more than most_triplets", "at most those"});

  const auto plan = read_plan(arguments.plan);
  if (!plan) return complain(plan.error());
  if (plan->samples.size() < 2) return complain({arguments.plan.string(), "path", fmt::format("the plan has none (status {})", to_string(plan->status)), "a plan with a path"});
  const auto period = period_of(arguments, *plan);
  if (!period) return complain(period.error());
  // What a file claims is believed where it verifies: its samples may be slower than the vehicle could.
  const auto verification = verify(*plan);
  if (!verification) return complain(of_plan(verification.error(), arguments.plan));
  if (!verification->holds) {
    return complain({arguments.plan.string(), "path", "the plan is not proven: " + verification->findings.front(), "a plan that `waywright verify` confirms"});
  }
  std::optional<Problem> problem;
  if (is_whale) {
    if (auto one = refuse_legs(plan->scenario, arguments.plan, "woa makes no controls for a mission in legs", "--method exact"); !one) return complain(one.error());
    auto prepared = Problem::prepare(plan->scenario);
    if (!prepared) return complain(of_plan(prepared.error(), arguments.plan));
    if (!plan->scenario.moving.empty()) return complain({arguments.plan.string(), "scenario.moving", "woa makes controls that know nothing of what moves", "--method exact"});
    if (prepared->pocket()) return complain({arguments.plan.string(), "station.insertion", "woa makes no controls for the way into a pocket", "--method exact"});
    problem = std::move(*prepared);
  }
  const auto motors = is_whale ? Parsed<WheelMotors>{} : motors_of(*plan, *parameters, given, arguments);
  if (!motors) return complain(motors.error());
  const auto slowing = is_whale ? tl::expected<double, TooWeak>{1.0} : slowing_of(*plan, *period, *motors);
  if (!slowing) {
    note(fmt::format("{}: {}", arguments.plan.string(), slowing.error().sentence));
    return not_solved;
  }
  const std::string& name = plan->scenario.name;
  const std::filesystem::path folder = arguments.out.value_or(default_folder((name.empty() ? arguments.plan.stem().string() : name) + "-controls"));
  const bool write = !arguments.json || arguments.out;
  if (write) {
    if (auto made = prepare_folder(folder); !made) return complain(made.error());
  }
  const Made made = is_whale ? whale(*problem, *plan, *period, *parameters, arguments.seed.value_or(1)) : exact(*plan, *period, *motors, *slowing);
  const std::string title = fmt::format("{}: controls, {}", name.empty() ? arguments.plan.stem().string() : name, arguments.method);
  if (write) {
    const Vehicle& vehicle = plan->scenario.vehicle;
    const WheelTorques* torques = made.torques ? &*made.torques : nullptr;
    auto written = write_files({{folder / "controls.json", made.json},
                                {folder / "controls.csv", controls_csv(vehicle, made.rows, torques)},
                                {folder / "controls.svg", controls_svg(vehicle, title, made.rows, torques)}});
    if (!written) return complain(written.error());
  }
  const bool printed = arguments.json ? print_raw(made.json)
                                      : print(title + "\n" + made.text + fmt::format("written: {0}/controls.json, {0}/controls.csv, {0}/controls.svg\n", folder.string()));
  return made.is_good && printed ? solved : not_solved;
}

}  // namespace waywright::app
