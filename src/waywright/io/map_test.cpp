// Pictures, ROS maps, alignment, files.
#include <gtest/gtest.h>
#include <zlib.h>
#include <png.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "waywright/core/random.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/image.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/world.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

class Folder : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "waywright-io-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }
  void put(const std::string& name, const std::string& text) const { std::ofstream{folder_ / name, std::ios::binary} << text; }
  fs::path folder_;
};
using RosMap = Folder;
using Files = Folder;

std::string yaml(const std::string& more = "") {
  return "image: m.pgm\nresolution: 0.5\norigin: [1.0, 2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n" + more;
}

/// One row of every grey value.
std::string all_greys() {
  std::string pgm = "P5\n# comment\n256 1\n255\n";
  for (int i = 0; i < 256; ++i) pgm += static_cast<char>(i);
  return pgm;
}

TEST_F(RosMap, TrinaryThresholdsForEveryGrey) {
  put("m.pgm", all_greys());
  for (const bool negate : {false, true}) {
    std::string text = yaml();
    if (negate) text.replace(text.find("negate: 0"), 9, "negate: 1");
    put("m.yaml", text);
    const auto loaded = load_ros_map(folder_ / "m.yaml", false);
    ASSERT_TRUE(loaded) << loaded.error().message();
    for (int grey = 0; grey < 256; ++grey) {
      const double p = (negate ? grey : 255 - grey) / 255.0;
      EXPECT_EQ(loaded->grid.blocked[static_cast<std::size_t>(grey)], p > 0.65 ? 1 : p < 0.196 ? 0 : 2) << grey;
    }
  }
  // Grey 205 is unknown at 0.196 and free at 0.25, as map_server has it.
  put("m.yaml", yaml());
  EXPECT_EQ(load_ros_map(folder_ / "m.yaml", false)->grid.blocked[205], 2);
  EXPECT_EQ(load_ros_map(folder_ / "m.yaml", true)->grid.blocked[205], 0);
  std::string text = yaml();
  text.replace(text.find("0.196"), 5, "0.25");
  put("m.yaml", text);
  EXPECT_EQ(load_ros_map(folder_ / "m.yaml", false)->grid.blocked[205], 0);
}

TEST_F(RosMap, InScaleModeOnlyWhatIsSurelyFreeIsFree) {
  put("m.pgm", all_greys());
  put("m.yaml", yaml("mode: scale\n"));
  const auto loaded = load_ros_map(folder_ / "m.yaml", true);
  ASSERT_TRUE(loaded) << loaded.error().message();
  for (int grey = 0; grey < 256; ++grey) EXPECT_EQ(loaded->grid.blocked[static_cast<std::size_t>(grey)], (255 - grey) / 255.0 < 0.196 ? 0 : 1) << grey;
}

TEST_F(RosMap, InScaleModeTransparentPixelsAreUnknown) {
  // White and opaque, white and half, white and not at all there, black and opaque.
  const std::array<std::uint8_t, 16> rgba{255, 255, 255, 255, 255, 255, 255, 128, 255, 255, 255, 0, 0, 0, 0, 255};
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = 4;
  png.height = 1;
  png.format = PNG_FORMAT_RGBA;
  std::string bytes(4096, '\0');
  png_alloc_size_t size = bytes.size();
  ASSERT_NE(png_image_write_to_memory(&png, bytes.data(), &size, 0, rgba.data(), 0, nullptr), 0);
  put("m.pgm", bytes.substr(0, size));
  using Cells = std::vector<std::uint8_t>;
  put("m.yaml", yaml("mode: scale\n"));
  EXPECT_EQ(load_ros_map(folder_ / "m.yaml", false)->grid.blocked, (Cells{0, 2, 2, 1}));
  put("m.yaml", yaml("mode: trinary\n"));
  EXPECT_EQ(load_ros_map(folder_ / "m.yaml", false)->grid.blocked, (Cells{0, 0, 0, 1}));
}

TEST_F(RosMap, MapsOfTooManyEdgesAreRefused) {
  const int side = 2048;
  const auto read = [&](const auto& grey) {
    std::string pgm = "P5\n2048 2048\n255\n";
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) pgm += static_cast<char>(grey(column, row));
    }
    put("m.pgm", pgm);
    put("m.yaml", yaml());
    const auto map = read_map(folder_ / "m.yaml");
    return map ? std::string{"accepted"} : map.error().message();
  };
  EXPECT_NE(read([](int c, int r) { return c % 2 == 0 && r % 2 == 0 ? 0 : 255; }).find("edges (allowed: at most"), std::string::npos);
  // Stripes along the columns: few edges, very many runs; occupied and unknown cells side by side: no edges at all.
  EXPECT_NE(read([](int c, int) { return c % 2 == 0 ? 0 : 255; }).find("change"), std::string::npos);
  EXPECT_NE(read([](int c, int) { return c % 2 == 0 ? 0 : 205; }).find("change"), std::string::npos);
  EXPECT_EQ(read([](int, int r) { return r % 2 == 0 ? 0 : 255; }), "accepted");
}

TEST_F(RosMap, TopRowIsUpAndTheOriginMayBeTurned) {
  put("m.pgm", std::string{"P5\n2 2\n255\n"} + "\x00\xff\xff\xff"[0] + "\xff" + "\xff" + "\xff");
  put("m.yaml", yaml());
  auto loaded = load_ros_map(folder_ / "m.yaml", false);
  ASSERT_TRUE(loaded);
  Map map;
  map.grids.push_back(loaded->grid);
  World world{map};
  world.build();
  const Footprint point{{}, 0.0};
  EXPECT_EQ(world.clearance(point, {1.25, 2.75, 0}, 1.0).clearance, 0.0);  // upper left cell
  EXPECT_NEAR(world.clearance(point, {1.25, 2.25, 0}, 1.0).clearance, 0.25, 1e-12);
  EXPECT_TRUE(world.clearance(point, {5.0, 5.0, 0}, 1.0).outside);
  std::string text = yaml();
  text.replace(text.find("[1.0, 2.0, 0.0]"), 15, "[1.0, 2.0, 1.5707963267948966]");
  put("m.yaml", text);
  map.grids[0] = load_ros_map(folder_ / "m.yaml", false)->grid;
  World turned{map};
  turned.build();
  EXPECT_EQ(turned.clearance(point, {0.25, 2.25, 0}, 1.0).clearance, 0.0);
}

TEST_F(RosMap, PngAndPgmOfManyKindsGiveTheSamePixels) {
  GreyImage image{3, 2, {0, 10, 200, 255, 128, 7}};
  const auto png = decode_image(encode_png(image), "x.png");
  ASSERT_TRUE(png);
  EXPECT_EQ(png->pixels, image.pixels);
  const auto ascii = decode_image("P2 # c\n3 2 # d\n255\n0 10 200\n255 128 7\n", "x.pgm");
  ASSERT_TRUE(ascii);
  EXPECT_EQ(ascii->pixels, image.pixels);
  const auto deep = decode_image(std::string{"P5\n2 1\n65535\n"} + std::string{"\x00\x00\xff\xff", 4}, "x.pgm");
  ASSERT_TRUE(deep);
  EXPECT_EQ(deep->pixels, (std::vector<std::uint8_t>{0, 255}));
}

TEST_F(RosMap, BrokenBytesNeverCrash) {
  // Seeded mutations of valid files: any answer but a crash or a hang.
  put("m.pgm", "P5\n4 4\n255\n0123456789abcdef");
  const std::string good_yaml = yaml();
  const std::string good_pgm = "P5\n4 4\n255\n0123456789abcdef";
  const std::string good_png = encode_png({4, 4, std::vector<std::uint8_t>(16, 77)});
  Random random{99};
  const auto mutated = [&](std::string text) {
    for (auto n = random.integer(1, 6); n > 0 && !text.empty(); --n) {
      const auto at = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(text.size()) - 1));
      switch (random.integer(0, 3)) {
        case 0: text[at] = static_cast<char>(random.integer(0, 255)); break;
        case 1: text.erase(at, static_cast<std::size_t>(random.integer(1, 8))); break;
        case 2: text.insert(at, 1, "0123456789-[]{}&*:, \n"[random.integer(0, 20)]); break;
        default: text.resize(at); break;
      }
    }
    return text;
  };
  int read = 0;
  for (int i = 0; i < 4000; ++i) {
    read += decode_image(mutated(good_pgm), "x") ? 1 : 0;
    read += decode_image(mutated(good_png), "x") ? 1 : 0;
    put("f.yaml", mutated(good_yaml));
    const auto loaded = load_ros_map(folder_ / "f.yaml", false);
    if (!loaded) {
      EXPECT_FALSE(loaded.error().message().empty());
    }
  }
  EXPECT_GT(read, 0);
}

// 16384 × 16384 pixels in 57 bytes would be a gigabyte once decoded.
TEST(Image, APngThatClaimsMoreThanItsBytesCanHoldIsRefused) {
  GreyImage image{1, 1, {7}};
  std::string bytes = encode_png(image);
  ASSERT_EQ(bytes.substr(12, 4), "IHDR");
  for (const std::size_t side : {std::size_t{16}, std::size_t{20}}) bytes.replace(side, 4, std::string{"\x00\x00\x40\x00", 4});
  const std::uint32_t crc = static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const unsigned char*>(bytes.data()) + 12, 17));
  for (std::size_t i = 0; i < 4; ++i) bytes[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
  const auto refused = decode_image(bytes, "bomb");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().problem.find("cannot hold"), std::string::npos) << refused.error().message();

  // What compresses best is still read.
  image = {4000, 4000, std::vector<std::uint8_t>(16'000'000, 255)};
  const auto white = decode_image(encode_png(image), "white");
  ASSERT_TRUE(white) << white.error().message();
  EXPECT_EQ(white->pixels, image.pixels);
}

TEST_F(RosMap, RealMapsLoadWithTheirSizes) {
  const char* data = std::getenv("WAYWRIGHT_TEST_DATA");
  if (data == nullptr || !fs::exists(fs::path{data} / "ros_maps")) GTEST_SKIP() << "no outside data (WAYWRIGHT_TEST_DATA)";
  struct Case {
    const char* file;
    int columns, rows;
  };
  for (const Case& c : {Case{"nav2/warehouse.yaml", 1006, 1674}, {"nav2/depot.yaml", 604, 307}, {"nav2/depot_speed.yaml", 604, 307}, {"ipa_factory/map.yaml", 544, 992},
                        {"ipa_production_plant/map.yaml", 1985, 1536}, {"aulario/map.yaml", 2295, 1638}, {"aws_hospital/hospital.yaml", 531, 1164},
                        {"stata_basement/stata_basement.yaml", 1730, 1300}, {"levine/levine.yaml", 4096, 4096}}) {
    const auto loaded = load_ros_map(fs::path{data} / "ros_maps" / c.file, false);
    ASSERT_TRUE(loaded) << loaded.error().message();
    EXPECT_EQ(loaded->grid.columns, c.columns);
    EXPECT_EQ(loaded->grid.rows, c.rows);
    EXPECT_EQ(loaded->files.size(), 2U);
  }
}

TEST(Align, RecoversRigidTransformsAndReportsResiduals) {
  Random random{4};
  for (int i = 0; i < 500; ++i) {
    const Frame truth{Pose{random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-pi, pi)}};
    std::vector<Vec2> from, to;
    for (int k = 0; k < 5; ++k) {
      from.push_back({random.uniform(-20, 20), random.uniform(-20, 20)});
      to.push_back(truth.to_world(from.back()));
    }
    const auto found = align(from, to);
    ASSERT_TRUE(found);
    EXPECT_NEAR(shorter_turn(found->transform.heading, truth.heading()), 0.0, 1e-9);
    EXPECT_NEAR(distance(found->transform.position(), truth.origin()), 0.0, 1e-9);
    for (const double r : found->residuals) EXPECT_LT(r, 1e-9);
  }
  const auto off = align({{0, 0}, {10, 0}}, {{0, 0}, {10.2, 0}});
  ASSERT_TRUE(off);
  EXPECT_NEAR(off->residuals[0], 0.1, 1e-12);
  EXPECT_FALSE(align({{0, 0}}, {{0, 0}}));
  EXPECT_FALSE(align({{1, 1}, {1, 1}}, {{0, 0}, {2, 0}}));
}

TEST_F(Files, AppearWholeOrNotAtAll) {
  const auto no_folder = write_file(folder_ / "a" / "b.txt", "hello");
  ASSERT_FALSE(no_folder);
  EXPECT_NE(no_folder.error().message().find("there is no folder"), std::string::npos);
  fs::create_directory(folder_ / "a");
  EXPECT_TRUE(write_file(folder_ / "a" / "b.txt", "hello"));
  EXPECT_EQ(*read_head(folder_ / "a" / "b.txt", 3), "hel");
  EXPECT_EQ(*read_head(folder_ / "a" / "b.txt", 30), "hello");
  EXPECT_EQ(*read_file(folder_ / "a" / "b.txt", 100), "hello");
  EXPECT_FALSE(read_file(folder_ / "a" / "b.txt", 3));
  EXPECT_FALSE(read_file(folder_ / "a", 100));
  EXPECT_FALSE(write_file(folder_ / "a" / "b.txt" / "c", "x"));
  EXPECT_FALSE(write_file(folder_ / "a", "x"));
  // All of them or none.
  EXPECT_FALSE(write_files({{folder_ / "a" / "b.txt", "other"}, {folder_ / "a" / "c.txt", "more"}, {folder_ / "a", "x"}}));
  EXPECT_EQ(*read_file(folder_ / "a" / "b.txt", 100), "hello");
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& e : fs::recursive_directory_iterator{folder_}) ++entries;
  EXPECT_EQ(entries, 2U);  // the folder and the file: nothing half-written is left
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(Files, PicturesAreRefusedByTheirHeaders) {
  const auto refused = [](const std::string& head) {
    const auto error = refused_by_header(head, "m");
    return error ? error->message() : std::string{};
  };
  EXPECT_EQ(refused("P5\n# a comment\n30000 20000\n255\n"), "m: the picture is 30000 × 20000 pixels (allowed: 1 to 16384 pixels a side)");
  EXPECT_EQ(refused("P5\n3 2\n255\n"), "");
  EXPECT_EQ(refused("P5\n30000 200"), "");  // cut off before the header's end
  const std::string png = encode_png({3, 2, std::vector<std::uint8_t>(6, 0)});
  EXPECT_EQ(refused(png.substr(0, 40)), "");
  EXPECT_NE(refused(png.substr(0, 16) + std::string("\0\1\0\0\0\0\0\2", 8)), "");
  // What the header shows is all that is read of a file that is too large.
  put("m.pgm", "P5\n30000 30000\n255\n");
  put("m.yaml", yaml());
  const auto large = load_ros_map(folder_ / "m.yaml", false);
  ASSERT_FALSE(large);
  EXPECT_NE(large.error().message().find("30000 × 30000"), std::string::npos);
}

TEST_F(Files, RosHeadersAreReadStrictly) {
  put("m.pgm", std::string{"P5\n1 1\n255\n"} + "\xff");
  const auto sentence = [&](const std::string& more) {
    put("m.yaml", "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n" + more);
    const auto loaded = load_ros_map(folder_ / "m.yaml", false);
    return loaded ? std::string{} : loaded.error().field + ": " + loaded.error().problem + " (" + loaded.error().allowed + ")";
  };
  EXPECT_EQ(sentence("negate: true\nfree_thresh: 0.3\noccupied_thresh: 0.3\n"), "");
  EXPECT_EQ(sentence("resolution: 0.1\n"), "resolution: the field is given twice (each field once)");
  EXPECT_EQ(sentence("occupied_tresh: 0.9\n"), "occupied_tresh: unknown field, did you mean \"occupied_thresh\"? (image, resolution, origin, negate, occupied_thresh, free_thresh, mode)");
  EXPECT_EQ(sentence("negate: 7\n"), "negate: 7 is no truth value (0, 1, true, false)");
  EXPECT_EQ(sentence("occupied_thresh: 0.1\n"), "occupied_thresh: 0.1 is under free_thresh 0.196 (free_thresh or more)");
  EXPECT_EQ(sentence("free_thresh: .nan\n"), "free_thresh: \".nan\" is not a number that can be used (a number, 0 to 1)");
  fs::remove(folder_ / "m.pgm");
  EXPECT_NE(sentence("").find("image: "), std::string::npos);
  // A name that no file system takes.
  put("m.yaml", "image: " + std::string(300, 'x') + "\nresolution: 0.05\norigin: [0, 0, 0]\n");
  EXPECT_EQ(load_ros_map(folder_ / "m.yaml", false).error().field, "image");
}

TEST_F(Files, PairsOfAMirroredMapAreRefused) {
  const auto sentence = [&](const char* pairs) {
    put("m.json", R"({"polygons": {"points": [[0, 0]]}, "align": )" + std::string{pairs} + "}");
    const auto map = read_map(folder_ / "m.json");
    return map ? std::string{} : map.error().message();
  };
  EXPECT_EQ(sentence("[[[0,0],[5,5]], [[4,0],[9,5]], [[0,3],[5,8.02]]]"), "");
  EXPECT_NE(sentence("[[[0,0],[5,5]], [[4,0],[9,5]], [[0,3],[5,2]]]").find("mirrored map"), std::string::npos);
  // Pairs that are bad by a few per cent are placed, with their residuals; by more than a tenth of their extent they are refused.
  EXPECT_EQ(sentence("[[[0,0],[5,5]], [[4,0],[9,5]], [[0,3],[5.2,8]]]"), "");
  EXPECT_NE(sentence("[[[0,0],[5,5]], [[4,0],[9,5]], [[0,3],[6,6]]]").find("m apart, more than a tenth of the 5.0 m over which they lie (allowed"), std::string::npos);
}

TEST_F(Files, PairsOfAnotherScaleAreTold) {
  const auto read = [&](const char* pairs) {
    put("m.json", R"({"polygons": {"points": [[0, 0]]}, "align": )" + std::string{pairs} + "}");
    const auto map = read_map(folder_ / "m.json");
    return !map ? map.error().message() : map->notes.empty() ? std::string{} : map->notes.back();
  };
  // Twice as large, drawn in millimetres, and turned besides.
  EXPECT_NE(read("[[[0,0],[3,4]], [[4,0],[11,4]]]").find("the pairs fit a map 2.00 times as large: wrong unit?"), std::string::npos);
  EXPECT_NE(read("[[[0,0],[3,4]], [[4000,0],[3,8]], [[0,3000],[0,4]]]").find("the pairs fit a map 0.001 times as large: wrong unit?"), std::string::npos);
  // Off by 5 % of scale it is placed, with a note; off without any scale it is only refused.
  EXPECT_EQ(read("[[[0,0],[0,0]], [[10,0],[10.5,0]]]"), "m.json: align: the pairs fit a map 1.05 times as large: wrong unit?");
  EXPECT_EQ(read("[[[0,0],[0,0]], [[10,0],[10.02,0]]]"), "");
  EXPECT_EQ(read("[[[0,0],[5,5]], [[4,0],[9,5]], [[0,3],[6,6]]]").find("wrong unit"), std::string::npos);
}

TEST_F(Files, OfASetAppearTogetherOrNotAtAll) {
  fs::create_directories(folder_ / "b");
  ASSERT_TRUE(write_files({{folder_ / "a", "1"}, {folder_ / "b" / "c", "2"}}));
  fs::create_directories(folder_ / "folder");
  const auto refused = write_files({{folder_ / "a", "3"}, {folder_ / "d", "4"}, {folder_ / "folder", "5"}});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("folder: the file cannot be written"), std::string::npos) << refused.error().message();
  EXPECT_EQ(read_file(folder_ / "a", 10).value(), "1");
  EXPECT_EQ(read_file(folder_ / "b" / "c", 10).value(), "2");
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator{folder_}) ++entries;
  EXPECT_EQ(entries, 3U);
}

TEST_F(Files, OverlayAndAlignmentOfMaps) {
  put("m.pgm", std::string{"P5\n4 4\n255\n"} + std::string(16, '\xff'));
  put("m.yaml", yaml());
  const std::string text = R"({"format": "waywright-scenario/1", "vehicle": {"footprint": {"disc": 0.1}, "drive": {"type": "differential", "track": 1}},
    "map": {"ros": "m.yaml", "align": [[[0, 0], [10, 0]], [[1, 0], [10, 1]]],
            "overlay": [{"polygons": {"obstacles": [[[0, 0], [1, 0], [1, 1]]]}, "transform": [5, 5, 0]}]},
    "start": [0, 0, 0], "goal": [1, 1, 0]})";
  const auto scenario = parse_scenario(text, "s.json", folder_);
  ASSERT_TRUE(scenario) << scenario.error().message();
  ASSERT_TRUE(scenario->map.alignment);
  EXPECT_NEAR(scenario->map.alignment->transform.heading, pi / 2, 1e-12);
  EXPECT_NEAR(scenario->map.grids[0].origin.x, 10.0 - 2.0, 1e-9);
  EXPECT_EQ(scenario->map.obstacles[0][0], (Vec2{5, 5}));
  EXPECT_NE(scenario->map_source.find("align_residuals"), std::string::npos);
}

const std::string movingai = "type octile\nheight 3\nwidth 4\nmap\n.@GT\nOSW.\n....\n";

TEST(MovingAi, ReadsCharactersFromTheTopWithEitherLineEnd) {
  std::string with_returns;
  for (const char c : movingai) with_returns += c == '\n' ? std::string{"\r\n"} : std::string{c};
  for (const std::string& text : {movingai, with_returns, movingai.substr(0, movingai.size() - 1), movingai + "\n \n"}) {
    const auto loaded = decode_movingai_map(text, "hall.map", 0.5);
    ASSERT_TRUE(loaded) << loaded.error().message();
    EXPECT_EQ(loaded->grid.columns, 4);
    EXPECT_EQ(loaded->grid.rows, 3);
    EXPECT_EQ(loaded->grid.blocked, (std::vector<std::uint8_t>{0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(loaded->grid.corner(0.5, 2.5), (Vec2{0.25, 0.25}));
    EXPECT_TRUE(loaded->grid.bounds);
  }
}

TEST(MovingAi, RefusesWithOneSentence) {
  const auto sentence = [](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    const auto loaded = decode_movingai_map(text, "hall.map", 1.0);
    return loaded ? std::string{"accepted"} : loaded.error().message();
  };
  EXPECT_EQ(sentence(movingai, "octile", "tile"),
            "hall.map: line 1 is not \"type octile\" (allowed: a MovingAI map: type octile, height, width, map, then a line of characters a row)");
  EXPECT_EQ(sentence(movingai, "height 3", "height 99999"), "hall.map: height: line 2 is not \"height\" and a number that can be used (allowed: a whole number, 1 to 16384)");
  EXPECT_EQ(sentence(movingai, "width 4", "width -4"), "hall.map: width: line 3 is not \"width\" and a number that can be used (allowed: a whole number, 1 to 16384)");
  EXPECT_EQ(sentence(movingai, "map\n", "\n"), "hall.map: line 4 is not \"map\" (allowed: map)");
  EXPECT_EQ(sentence(movingai, "OSW.", "OSW"), "hall.map: line 6 has 3 characters (allowed: as many as the width, 4)");
  EXPECT_EQ(sentence(movingai, "OSW.", "OSx."), "hall.map: line 6 has \"x\" in column 3 (allowed: . G S (free), @ O T W (blocked))");
  EXPECT_EQ(sentence(movingai, "....\n", ""), "hall.map: it ends after 2 of 3 rows (allowed: a line of characters for each row)");
  EXPECT_EQ(sentence(movingai, "....\n", "....\n.\n"), "hall.map: line 8 comes after the last row (allowed: 3 rows, as the height says)");
  EXPECT_EQ(sentence(movingai, "height 3", "height 16000"), "hall.map: it has 52 bytes, too few for 4 x 16000 cells (allowed: a line of characters for each row)");
}

}  // namespace
}  // namespace waywright
