#include "waywright/io/json_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "waywright/io/scenario_json.hpp"

namespace waywright {
namespace {

std::string refusal(const std::string& text) {
  const auto json = parse_json(text, "f.json");
  return json ? "accepted" : json.error().message();
}

double seconds_of(const auto& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(ParseJson, RefusalsNameThePlace) {
  EXPECT_EQ(
      refusal(""),
      "f.json: line 1, column 1: not valid JSON: unexpected end of input; expected '[', '{', or a literal");
  EXPECT_EQ(refusal("{\"a\": [1, 2,\n 3 }"),
            "f.json: line 2, column 4: not valid JSON: unexpected '}'; expected ']'");
  EXPECT_EQ(refusal("{} {}"),
            "f.json: line 1, column 4: not valid JSON: unexpected '{'; expected end of input");
  EXPECT_EQ(refusal("{\"a\": {\"b\": [0, 1e999]}}"),
            "f.json: a.b[1]: the number 1e999 is too large (allowed: finite numbers)");
  EXPECT_EQ(refusal("{\"a\": [1, [2], -1e400]}"),
            "f.json: a[2]: the number -1e400 is too large (allowed: finite numbers)");
  EXPECT_EQ(refusal("{\"a\": NaN}"),
            "f.json: a: not valid JSON: nan is not a number (allowed: finite numbers)");
  EXPECT_EQ(refusal("{\"a\": [Infinity]}"),
            "f.json: a[0]: not valid JSON: infinity is not a number (allowed: finite numbers)");
  EXPECT_EQ(refusal("{\"a\": -Infinity}"),
            "f.json: a: not valid JSON: -infinity is not a number (allowed: finite numbers)");
  EXPECT_EQ(refusal("{\"a\": {\"b\": 1, \"c\": 2, \"b\": 3}}"),
            "f.json: a.b: the field stands twice in one object (allowed: once)");
  EXPECT_EQ(refusal("[{\"\\u0062\": 1, \"b\": 3}]"),
            "f.json: [0].b: the field stands twice in one object (allowed: once)");
}

TEST(ParseJson, BytesThatAreNoTextAreRefusedInPlainLetters) {
  for (const std::string& text :
       {std::string("\xff\xfe\x00", 3), std::string("\"\xc3\x28\""), std::string("{\"a\": \"\x01\"}"),
        std::string("{\"a\0\": 1}", 9), std::string("{\"\x80\": 1}")}) {
    const std::string sentence = refusal(text);
    EXPECT_NE(sentence.find("not valid JSON"), std::string::npos) << sentence;
    for (const char c : sentence) EXPECT_TRUE(c >= 0x20 && c < 0x7F) << sentence;
  }
}

TEST(ParseJson, DepthIsBounded) {
  const auto nested = [](std::size_t n) { return std::string(n, '[') + std::string(n, ']'); };
  EXPECT_TRUE(parse_json(nested(deepest_json), "f"));
  EXPECT_EQ(refusal(nested(deepest_json + 1)),
            "f.json: the JSON is nested too deeply (allowed: at most 64 levels)");
  EXPECT_TRUE(parse_json(fmt::format("\"{}\"", std::string(1000, '[')), "f")) << "brackets in text are text";
  EXPECT_LT(seconds_of([&] {
              for (const char* open : {"[", "{\"a\":", "[[], ", "{\"a\":["}) {
                std::string text;
                for (int i = 0; i < 1'000'000; ++i) text += open;
                EXPECT_NE(refusal(text).find("nested too deeply"), std::string::npos);
              }
            }),
            2.0);
}

TEST(ParseJson, LargeTextsAreReadInTime) {
  std::string array = "[0";
  for (int i = 1; i < 1'000'000; ++i) array += ",0.5";
  array += "]";
  std::string object = "{\"k\":0";
  for (int i = 0; i < 200'000; ++i) object += ",\"k" + std::to_string(i) + "\":0";
  object += "}";
  EXPECT_LT(seconds_of([&] {
              EXPECT_EQ(parse_json(array, "f")->size(), 1'000'000U);
              EXPECT_EQ(parse_json(object, "f")->size(), 200'001U) << "as many fields take no quadratic time";
            }),
            5.0);
}

TEST(ParseJson, TextsBeyondTheLimitAreRefusedUnread) {
  EXPECT_EQ(refusal(std::string(largest_json + 1, ' ')),
            "f.json: the JSON is 268435457 bytes long (allowed: at most 268435456)");
}

TEST(ParseJson, AsMuchMemoryAsTheTextAsksForIsRefused) {
  std::string text = "[";
  for (std::size_t i = 0; i < most_json_values; ++i) text += "0,";
  EXPECT_EQ(refusal(text + "0]"),
            "f.json: there are too many values in the JSON (allowed: at most 16777216)");
}

TEST(Node, UnknownFieldsComeWithTheNearestSpelling) {
  const auto sentence = [](const char* text, std::initializer_list<const char*> fields) {
    const Json json = *parse_json(text, "f");
    ReadContext context{"f", {}};
    EXPECT_FALSE((Node{json, "vehicle", context}.is_object_of(fields)));
    return context.error->message();
  };
  EXPECT_EQ(sentence(R"({"wheelbse": 1})", {"wheelbase", "track"}),
            "f: vehicle.wheelbse: unknown field, did you mean \"wheelbase\"? (allowed: wheelbase, track)");
  EXPECT_EQ(sentence(R"({"gaol": 1})", {"start", "goal"}),
            "f: vehicle.gaol: unknown field, did you mean \"goal\"? (allowed: start, goal)");
  EXPECT_EQ(sentence(R"({"wings": 1})", {"wheelbase", "track"}),
            "f: vehicle.wings: unknown field (allowed: wheelbase, track)");
  EXPECT_EQ(sentence(R"({"x": 1})", {"dxf"}), "f: vehicle.x: unknown field (allowed: dxf)");
  EXPECT_EQ(sentence("[]", {"a"}), "f: vehicle: it is an array (allowed: an object)");
  const std::string longest = "{\"" + std::string(100'000, 'a') + "\": 1}";
  EXPECT_EQ(sentence(longest.c_str(), {"aaaa"}),
            "f: vehicle." + std::string(60, 'a') + "...: unknown field (allowed: aaaa)");
}

TEST(Node, ShortenedTextEndsBetweenCharacters) {
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "\xc3\xa4";
  EXPECT_EQ(shortened("a" + umlauts), fmt::format("a{}...", umlauts.substr(0, 58)));
  EXPECT_EQ(shortened(umlauts), fmt::format("{}...", umlauts.substr(0, 58)));
  EXPECT_EQ(shortened("a\nb\x7f"), "a?b?");
}

TEST(Node, WholeNumbersMayBeWrittenWithAnExponent) {
  const auto read = [](const char* text) -> std::string {
    const Json json = *parse_json(text, "f");
    ReadContext context{"f", {}};
    const std::int64_t value = Node{json, "n", context}.integer(0, std::numeric_limits<std::int64_t>::max());
    return context.error ? context.error->problem : std::to_string(value);
  };
  EXPECT_EQ(read("1e3"), "1000");
  EXPECT_EQ(read("7.0"), "7");
  EXPECT_EQ(read("9223372036854775807"), "9223372036854775807");
  EXPECT_EQ(read("9223372036854775808"), "9223372036854775808 is out of range");
  EXPECT_EQ(read("18446744073709551616"), "1.8446744073709552e+19 is out of range");
  EXPECT_EQ(read("-1"), "-1 is out of range");
  EXPECT_EQ(read("1.5"), "1.5 is not a whole number");
  EXPECT_EQ(read("true"), "it is true");
  EXPECT_EQ(read("null"), "it is null");
}

TEST(Node, FirstErrorStays) {
  const Json json = *parse_json(R"({"a": "x", "b": [1, "y"]})", "f");
  ReadContext context{"f", {}};
  const Node node{json, "", context};
  node.at("a").number(0, 1);
  node.at("b").at(1).number(0, 1);
  node.at("c");
  EXPECT_EQ(context.error->message(), "f: a: it is text (allowed: a number from 0 to 1)");
}

TEST(Pretty, NumbersReadBackToTheSameBits) {
  std::mt19937_64 random{7};
  Json numbers = Json::array();
  for (const double v :
       {0.0, -0.0, 0.1, 1e-300, 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 1e22, 1e15, 1e16,
        1e21, 123456789012345680000.0, -9007199254740993.0, 18446744073709551615.0, 0.3, 1.0 / 3.0, 100.0}) {
    numbers.push_back(v);
  }
  while (numbers.size() < 20'000) {
    const std::uint64_t bits = random();
    double v = 0.0;
    std::memcpy(&v, &bits, sizeof v);
    if (std::isfinite(v)) numbers.push_back(v);
  }
  const Json back = *parse_json(pretty(numbers), "f");
  ASSERT_EQ(back.size(), numbers.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    const double a = numbers[i].get<double>();
    const double b = back[i].get<double>();
    EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0) << a << " became " << b;
    EXPECT_TRUE(back[i].is_number_float());
  }
}

TEST(Pretty, RowsStandOnOneLine) {
  const Json json = *parse_json(
      R"({"a":{"b":[1,2.50,-3],"c":[]},"d":[[[1,2],[3,4]],[[5,6]]],"e":{},"f":[{"g":null},"\u00e4\n"]})",
      "f");
  EXPECT_EQ(pretty(json, 1),
            "{\n \"a\": {\n  \"b\": [1,2.5,-3],\n  \"c\": []\n },\n \"d\": [\n  [[1,2],[3,4]],\n  [[5,6]]\n "
            "],\n \"e\": {},\n \"f\": [\n  {\n   "
            "\"g\": null\n  },\n  \"\xc3\xa4\\n\"\n ]\n}\n");
}

TEST(Pretty, WhatJsonCannotSayDoesNotThrow) {
  EXPECT_EQ(pretty(Json::array({std::nan(""), std::numeric_limits<double>::infinity()})), "[null,null]\n");
  EXPECT_EQ(pretty(Json{{"a", "\xff"}}, 0), "{\n\"a\": \"\xef\xbf\xbd\"\n}\n");
}

}  // namespace
}  // namespace waywright
