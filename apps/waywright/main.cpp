#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "commands.hpp"
#include "map_scenario.hpp"
#include "waywright/core/spelling.hpp"
#include "waywright/core/version.hpp"

namespace {

using namespace waywright::app;

/// What the first word that is neither a command nor an option of the command may have been meant to be: `, did you mean "…"?`, or nothing.
std::string meant_on_command_line(const CLI::App& app, int argc, char** argv) {
  const CLI::App* command = &app;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word{argv[i]};
    std::vector<std::string> known;
    if (!word.starts_with('-')) {
      if (command != &app) continue;
      const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
      const auto found = std::find_if(commands.begin(), commands.end(), [&](const CLI::App* c) { return c->get_name() == word; });
      if (found != commands.end()) {
        command = *found;
        continue;
      }
      for (const CLI::App* c : commands) known.push_back(c->get_name());
      return waywright::meant_instead(word, known);
    }
    const std::string_view option = word.substr(0, word.find('='));
    for (const CLI::Option* o : command->get_options()) {
      for (const std::string& name : o->get_lnames()) known.push_back("--" + name);
      for (const std::string& name : o->get_snames()) known.push_back("-" + name);
    }
    if (std::find(known.begin(), known.end(), option) == known.end() && option.starts_with("--")) return waywright::meant_instead(option, known);
  }
  return {};
}

int run(int argc, char** argv) {
  CLI::App app{"waywright: safe, smooth, short and explainable paths for industrial mobile robots.\n"
               "Without a command it plans the bundled docking example."};
  app.set_version_flag("--version", waywright::version);
  app.require_subcommand(0, 1);
  int status = solved;

  PlanArguments plan_arguments;
  std::string out;
  auto* plan_command = app.add_subcommand("plan", "plan a scenario; writes plan.json, plan.svg and report.html");
  plan_command->add_option("SCENARIO", plan_arguments.scenario, "scenario.json")->required();
  plan_command->add_option("-o,--out", plan_arguments.out, "folder to write to (default: waywright-out/NAME)");
  plan_command->add_option("--planner", plan_arguments.planner, "planner in place of the scenario's");
  plan_command->add_option("--set", plan_arguments.set, "KEY=VALUE, a parameter of the planner; may be repeated. evaluations is refused where the scenario's budget names them");
  plan_command->add_option("--seed", plan_arguments.seed, "seed in place of the scenario's");
  plan_command->add_flag("--json", plan_arguments.json, "plan.json on standard output and nothing else there");
  plan_command->callback([&] { status = plan(plan_arguments); });

  ParetoArguments pareto_arguments;
  auto* pareto_command = app.add_subcommand("pareto", "length against clearance against curvature: proven plans of which none is better in all three");
  pareto_command->add_option("SCENARIO", pareto_arguments.plan.scenario, "scenario.json, with waypoints or a goal")->required();
  pareto_command->add_option("-o,--out", pareto_arguments.plan.out, "folder to write to (default: waywright-out/NAME-pareto)");
  pareto_command->add_option("--points", pareto_arguments.points, "plans, at most")->check(CLI::Range(1, 200));
  pareto_command->add_option("--set", pareto_arguments.plan.set, "KEY=VALUE, a parameter of the planner; may be repeated");
  pareto_command->add_option("--seed", pareto_arguments.plan.seed, "seed in place of the scenario's");
  pareto_command->callback([&] { status = pareto(pareto_arguments); });

  std::filesystem::path plan_file;
  auto* verify_command = app.add_subcommand("verify", "prove a plan again from its file alone");
  verify_command->add_option("PLAN", plan_file, "plan.json")->required();
  verify_command->callback([&] { status = verify(plan_file); });

  ReplanArguments replan_arguments;
  auto* replan_command = app.add_subcommand("replan", "while a plan is driven and obstacles appear: what is left is kept, mended or planned anew, and waits for what moves; or the shelf, the goal or the vehicle is elsewhere by centimetres: what is left is carried along with its ends, as long as a bend is left to do so, else planned anew");
  replan_command->add_option("PLAN", replan_arguments.plan, "plan.json that is being driven")->required();
  replan_command->add_option("--at", replan_arguments.at, "s since its start");
  replan_command->add_option("--after", replan_arguments.after, "m that the vehicle has driven of it, instead of --at");
  replan_command->add_option("--obstacles", replan_arguments.obstacles, "obstacles.json: what has been seen then, that stands or moves");
  replan_command->add_option("--shelf", replan_arguments.shelf, "X,Y,HEADING: centre and heading of the shelf as it is now");
  replan_command->add_option("--goal", replan_arguments.goal, "X,Y,HEADING: the goal as it is now, of a mission without a station");
  replan_command->add_option("--pose", replan_arguments.pose, "X,Y,HEADING: where the vehicle is (default: where the plan has it)");
  replan_command->add_option("-o,--out", replan_arguments.out, "folder to write to (default: waywright-out/NAME-replanned)");
  replan_command->add_flag("--json", replan_arguments.json, "plan.json on standard output and nothing else there");
  replan_command->callback([&] { status = replan(replan_arguments); });

  ControlsArguments controls_arguments;
  auto* controls_command = app.add_subcommand("controls", "speeds, turning rates, wheel speeds and torques that drive a plan; writes controls.json, controls.csv and controls.svg");
  controls_command->add_option("PLAN", controls_arguments.plan, "plan.json")->required();
  controls_command->add_option("-o,--out", controls_arguments.out, "folder to write to (default: waywright-out/NAME-controls)");
  controls_command->add_option("--period", controls_arguments.period, "s, of a command, or of the simulation's steps (default: 0.05)");
  controls_command->add_option("--method", controls_arguments.method, "exact: the plan's own motion; woa: searched from waypoint to waypoint (default: exact)");
  controls_command->add_option("--set", controls_arguments.set, "KEY=VALUE, a parameter of woa, or of a mecanum base's motors: inertia, wheel_inertia, rolling_arm, max_torque, max_wheel_speed; may be repeated");
  controls_command->add_option("--seed", controls_arguments.seed, "of woa (default: 1)");
  controls_command->add_flag("--json", controls_arguments.json, "controls.json on standard output and nothing else there");
  controls_command->callback([&] { status = controls(controls_arguments); });

  ImportArguments import_arguments;
  auto* import_command = app.add_subcommand("import", "judge anyone's poses: a CSV with x, y, heading and direction");
  import_command->add_option("PATH", import_arguments.path, "CSV of poses")->required();
  import_command->add_option("--scenario", import_arguments.scenario, "scenario.json that the path is for")->required();
  import_command->add_option("-o,--out", import_arguments.out, "folder to write to (default: waywright-out/NAME-import)");
  import_command->callback([&] { status = import(import_arguments); });

  CompareArguments compare_arguments;
  auto* compare_command = app.add_subcommand("compare", "planners side by side under one validity check and one budget");
  compare_command->add_option("SCENARIO", compare_arguments.scenarios, "scenario files");
  compare_command->add_option("--planners", compare_arguments.planners,
                              "comma-separated: NAME, NAME:key=value:key=value, exec:COMMAND (default: all planners). COMMAND is run by sh with the "
                              "scenario's JSON on its standard input, and answers with a CSV of poses (x,y,heading,direction) within the budget's seconds, "
                              "or 60 s; a comma of its own is written \\,");
  compare_command->add_option("--set", compare_arguments.set, "KEY=VALUE for every planner that has the parameter; KEY=A,B makes one contestant of each");
  compare_command->add_option("--runs", compare_arguments.runs, "seeds each")->check(CLI::Range(1, 1000000));
  compare_command->add_option("--threads", compare_arguments.threads, "0: all cores")->check(CLI::Range(0, 1024));
  compare_command->add_option("--evaluations", compare_arguments.evaluations, "the same budget for all (default: the scenario's, or 2000)")->check(CLI::Range(1LL, 1000000000000LL));
  compare_command->add_option("--suite", compare_arguments.suite, "NAME DIR: not supported yet")->expected(1, 2);
  compare_command->add_option("-o,--out", compare_arguments.out, "folder to write to");
  compare_command->callback([&] { status = compare(compare_arguments); });

  CheckArguments check_arguments;
  auto* check_command = app.add_subcommand("check", "plan and prove every place of a site; one table with pictures; what did not change is taken over");
  check_command->add_option("STATIONS", check_arguments.inputs, "STATIONS.csv, or scenario files");
  check_command->add_option("--map", check_arguments.map, "map of the site, with STATIONS.csv");
  check_command->add_option("--vehicle", check_arguments.vehicle, "vehicle.json, with STATIONS.csv");
  check_command->add_option("--clearance", check_arguments.clearance, "m, of rows of STATIONS.csv that name none");
  check_command->add_option("--planner", check_arguments.planner, "planner of rows that name none; in place of a scenario file's");
  check_command->add_option("--set", check_arguments.set, "KEY=VALUE for every place whose planner has the parameter; may be repeated");
  check_command->add_option("--seed", check_arguments.seed, "seed of rows that name none; in place of a scenario file's");
  check_command->add_option("--threads", check_arguments.threads, "0: all cores")->check(CLI::Range(0, 1024));
  check_command->add_flag("--fresh", check_arguments.fresh, "plan all, take nothing over");
  check_command->add_flag("--json", check_arguments.json, "the table as JSON on standard output and nothing else there");
  check_command->add_option("-o,--out", check_arguments.out, "folder to write to, and to take over from");
  check_command->callback([&] { status = check(check_arguments); });

  std::string what;
  auto* list_command = app.add_subcommand("list", "what there is, a line each");
  list_command->add_option("WHAT", what, "planners, optimizers, objectives, vehicles, maps, zones, generators, or a planner's name");
  list_command->callback([&] { status = list(what); });

  MapArguments map_arguments;
  LaneArguments lane_arguments;
  auto* map_command = app.add_subcommand("map", "what a map file holds; with -o it is written as map.json");
  map_command->add_option("FILE", map_arguments.file, "ROS yaml, map.json, PNG or PGM picture, DXF or SVG drawing, MovingAI map, Open-RMF building, openTCS plant model")->required();
  map_command->add_option("-o,--out", map_arguments.out, "map.json to write");
  map_command->add_option("--align", map_arguments.align,
                          "X,Y=X,Y: a point on the map and where it lies in the world; two or more place the map, and their residuals are told");
  const std::vector<CLI::Option*> of_drawings{
      map_command->add_option("--unit", map_arguments.drawing.unit, "of a DXF: mm, cm, m, in, ft (default: as the drawing says)"),
      map_command->add_option("--obstacle-layers", map_arguments.obstacle_layers,
                              "A,B: of a DXF, the layers that are obstacles; a comma of a name is written \\, (default: all but those of writing and the boundary)"),
      map_command->add_option("--boundary-layer", map_arguments.drawing.boundary_layer, "of a DXF: the layer whose closed rings are the boundary"),
      map_command->add_option("--tolerance", map_arguments.drawing.tolerance, "m, of a DXF: chords stay so near to their curves (default: 0.001)")
          ->check(CLI::Range(waywright::dxf::least_tolerance, waywright::dxf::most_tolerance)),
      map_command->add_option("--closing", map_arguments.drawing.closing, "m, of a DXF: outlines are closed over gaps up to this (default: 0.01)")
          ->check(CLI::Range(0.0, waywright::dxf::most_closing))};
  map_command->add_option("--resolution", map_arguments.cells.resolution, "m a pixel, of a picture");
  map_command->add_option("--trace", map_arguments.cells.trace, "TOLERANCE in m, at least half a cell: polygons in place of cells, which hold every blocked cell and reach no farther beyond");
  map_command->add_option("--trace-relative", map_arguments.cells.trace_relative, "with --trace: of each polygon this share of its outline's length is the tolerance, where that is less (0.02, say)");
  map_command->add_option("--dilate", map_arguments.cells.dilate, "with --trace: METRES by which blocked cells grow before");
  map_command->add_option("--overlay", map_arguments.overlay, "a map (ROS yaml, map.json, DXF) drawn in the same picture, as it lies in the world");
  map_command->add_option("--overlay-unit", map_arguments.overlay_unit, "of a DXF that --overlay names: mm, cm, m, in, ft (default: as the drawing says)");
  map_command->add_option("--picture", map_arguments.picture, "FILE.svg to write: the map, and what --overlay names");
  map_command->add_option("--corridor", lane_arguments.corridor, "METRES: strips so wide along the lanes of a plant model or building are all that is free (default: with --scenario as wide as the vehicle needs to turn)");
  map_command->add_option("--margin", lane_arguments.margin, "METRES, of an openTCS plant model, which has no walls: all is free so far around its places and lanes (default without --scenario: 5)");
  map_command->add_option("--scenario", lane_arguments.scenario, "scenario.json to write: from the place --from to the place --to of the map's lanes, with one-way lanes and speeds as zones");
  const std::vector<CLI::Option*> of_scenarios{
      map_command->add_flag("--off-lanes", lane_arguments.off_lanes, "with --scenario: the vehicle may leave the lanes; what walls leave free is free, of a plant model all within --margin"),
      map_command->add_option("--from", lane_arguments.from, "with --scenario: name of a place, or of a station"),
      map_command->add_option("--to", lane_arguments.to, "with --scenario: the same"),
      map_command->add_option("--vehicle", lane_arguments.vehicle, "with --scenario: vehicle.json (default: the plant model's first, as a box that turns on the spot; an Open-RMF building tells none, so there it is needed)"),
      map_command->add_option("--lane-width", lane_arguments.lane_width, "with --scenario: METRES, of the lanes' zones (default: --corridor, or 1)"),
      map_command->add_option("--prefer", lane_arguments.prefer, "with --scenario: FACTOR under 1, what a metre on a lane costs (default: lanes are not preferred)")};
  map_command->callback([&] {
    const bool about_scenario = std::any_of(of_scenarios.begin(), of_scenarios.end(), [](const CLI::Option* option) { return option->count() > 0; });
    if (about_scenario && !lane_arguments.scenario) {
      status = complain({"", "command line", "--from, --to, --vehicle, --off-lanes, --lane-width and --prefer go with --scenario alone", "--scenario FILE.json beside them"});
      return;
    }
    map_arguments.about_drawing = std::any_of(of_drawings.begin(), of_drawings.end(), [](const CLI::Option* option) { return option->count() > 0; });
    status = map(map_arguments, lane_arguments);
  });

  GenerateArguments generate_arguments;
  auto* generate_command = app.add_subcommand("generate", "make a test scenario, map or site");
  generate_command->add_option("NAME", generate_arguments.name, "station, stations, warehouse, or a publication's map as list maps names them")->required();
  generate_command->add_option("-o,--out", generate_arguments.out, "file to write")->required();
  generate_command->add_option("--seed", generate_arguments.seed, "other seeds, other scenarios");
  generate_command->add_option("--boxes", generate_arguments.boxes, "number of boxes in a station (default: 0 to 12 by seed)")->check(CLI::Range(0, 200));
  generate_command->add_option("--count", generate_arguments.count, "number of stations of a site (default: 20)")->check(CLI::Range(1, 1000));
  generate_command->add_option("--vehicle", generate_arguments.vehicle, "vehicle.json that the stations leave room for (default: the bundled forklift)");
  generate_command->callback([&] { status = generate(generate_arguments); });

  ReproduceArguments reproduce_arguments;
  auto* reproduce_command = app.add_subcommand("reproduce", "a publication's experiments, printed and ours side by side");
  reproduce_command->add_option("WHAT", reproduce_arguments.what, "safe_astar or rrt_woa")->required();
  reproduce_command->add_option("-o,--out", reproduce_arguments.out, "folder to write to (default: waywright-out/reproduce-WHAT)");
  reproduce_command->add_option("--runs", reproduce_arguments.runs, "searches each (safe_astar: 5, for the median of their times; rrt_woa: 100 seeds a map)")->check(CLI::Range(1, 1000));
  reproduce_command->callback([&] { status = reproduce(reproduce_arguments); });

  for (const char* later : {"sweep", "tune", "simulate", "serve", "agv", "fleet"}) {
    auto* command = app.add_subcommand(later, "not supported yet");
    command->allow_extras();
    command->callback([&status, later] {
      status = complain({"", std::string{"command "} + later, "it is not supported yet", "plan, replan, verify, controls, import, compare, check, pareto, reproduce, list, map, generate"});
    });
  }

  // No option and no place of a file takes an empty word: mostly a variable of a script that is not set.
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i], before = i > 1 ? argv[i - 1] : "";
    const bool is_bare = word.starts_with("--") && word.ends_with('=');
    if (!word.empty() && !is_bare) continue;
    const std::string option{is_bare ? word.substr(0, word.size() - 1) : before.starts_with('-') ? before : std::string_view{"command line"}};
    return complain({"", option, "an empty word is given", option == "command line" ? "the name of a file" : "a value, or the option left out"});
  }

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return print(app.help()) ? solved : not_solved;
  } catch (const CLI::CallForVersion&) {
    return print(std::string{waywright::version} + "\n") ? solved : not_solved;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) {
      app.exit(e);
      return solved;
    }
    std::string sentence = e.what();
    for (char& c : sentence) {
      if (c == '\n') c = ' ';
    }
    if (dynamic_cast<const CLI::ExtrasError*>(&e) != nullptr) sentence += meant_on_command_line(app, argc, argv);
    return complain({"", "command line", sentence, "see --help"});
  }
  if (app.get_subcommands().empty()) return plan_example();
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("waywright: there is not enough memory for this input\n", stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "waywright: %s\n", e.what());
  }
  return bad_input;
}
