// Expected lines are typed from docs/profile-json.md.
#include "canvoy/formats/profile_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::formats::profile_json_test {
namespace {

using nlohmann::json;

constexpr NamedValue door_values[] = {{0, "closed"},
                                      {1, "open"},
                                      {2, 6, "reserved", Meaning::reserved},
                                      {7, "none", Meaning::invalid}};
constexpr FieldCondition if_open[] = {{"door #", 1, 1}, {"door #", 4, 5}};
constexpr FieldInfo door_fields[] = {
    {.bits = 3, .name = "door #", .value = {.names = door_values}, .number = 2},
    {.first_bit = 3, .bits = 5, .name = "width", .when = if_open},
};
constexpr NamedValue broken[] = {{-1, "broken", Meaning::failure}};
constexpr Piece pieces[] = {{0, 10, {}, "near"}, {11, 20, {.numerator = 2, .offset = 10}, "far"}};
constexpr EntryInfo positions[] = {
    {.name = "highest sub-index supported", .initial = highest_sub(3)},
    {.sub_first = 1,
     .sub_last = 3,
     .name = "position_#",
     .type = DataType::integer16,
     .access = Access::ro,
     .consumer_access = Access::rw,
     .mapping = Mapping::by_default,
     .initial = 0,
     .consumer_initial = -1,
     .value = {.unit = Unit::metre,
               .scale = {.denominator = 4, .offset = 8},
               .limits = within(-100, 100),
               .names = broken},
     .clause = "2.1"},
};
constexpr ObjectInfo doors = {.index = 0x6100,
                              .count = 2,
                              .name = "doors #",
                              .clause = "1",
                              .entry = {.access_by_device = true, .fields = door_fields}};
constexpr ObjectInfo places = {.index = 0x6200,
                               .code = ObjectCode::array,
                               .name = "places",
                               .category = Category::conditional,
                               .condition = "if there are doors",
                               .clause = "2",
                               .errata = "7",
                               .subs = positions};
constexpr ObjectInfo distance = {.index = 0x6300,
                                 .name = "distance",
                                 .clause = "3",
                                 .entry = {.value = {.unit = Unit::metre, .pieces = pieces}}};
constexpr const ObjectInfo* objects[] = {&doors, &places, &distance};
constexpr DeviceObject door_objects[] = {{.index = 0x6100, .access = Access::wo, .last = 0x6101},
                                         {.index = 0x6200, .category = Category::optional}};
constexpr VirtualDeviceInfo devices[] = {{.code = 0x0A,
                                          .device_class = 1,
                                          .subclass = 2,
                                          .name = "door",
                                          .objects = door_objects,
                                          .clause = "4"}};
constexpr std::uint32_t mapped[] = {0x6200'01'10, 0x6100'00'08};
constexpr PdoInfo pdos[] = {
    {.number = 3, .cob_id = 0x180, .plus_node_id = true, .mapping = mapped},
    {.direction = PdoInfo::Direction::receive, .number = 1, .last_number = 4, .cob_id = 0x201}};
constexpr ErrorCodeInfo errors[] = {{0xFF05, "overspeed", "5"}};
constexpr Profile profile = {.number = 499,
                             .name = "CiA 499-1",
                             .title = "Doors",
                             .objects = objects,
                             .virtual_devices = devices,
                             .pdos = pdos,
                             .error_codes = errors};

std::vector<json> lines_of(const char* kind) {
  std::vector<json> lines;
  write_profile_json(profile, [&](const std::string& text) {
    json line = json::parse(text);
    if (line.at("kind") == kind) lines.push_back(std::move(line));
  });
  return lines;
}

TEST(ProfileJson, AnEntryHasItsPlaceNamesAndAttributes) {
  const std::vector<json> lines = lines_of("entry");
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0],
            json::parse(R"({"kind":"entry","profile":"499-1","index":"6100","index_last":"6101",
      "sub":"00","sub_last":"00","object":"doors 1 to doors 2","entry":"doors 1 to doors 2","code":"VAR",
      "type":"UNSIGNED8","access":"vd","pdo":"no","default":null,"range":null,"category":"mandatory",
      "entry_category":"mandatory","clause":"1"})"));
  EXPECT_EQ(lines[1].at("default"), 3);
  EXPECT_EQ(lines[2],
            json::parse(R"({"kind":"entry","profile":"499-1","index":"6200","index_last":"6200",
      "sub":"01","sub_last":"03","object":"places","entry":"position_1 to position_3","code":"ARRAY",
      "type":"INTEGER16","access":"ro","consumer_access":"rw","pdo":"default","default":0,
      "consumer_default":-1,"range":[-100,100],"category":"conditional","condition":"if there are doors",
      "entry_category":"mandatory","clause":"2.1","errata":"7"})"));
}

TEST(ProfileJson, AFieldHasItsBitsValuesAndCondition) {
  const std::vector<json> lines = lines_of("field");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0],
            json::parse(R"({"kind":"field","profile":"499-1","index":"6100","index_last":"6101",
      "sub":"00","sub_last":"00","field":"door 2","lsb":0,"width":3,
      "values":{"0":"closed","1":"open","2-6":"reserved","7":"none"}})"));
  EXPECT_EQ(lines[1].at("lsb"), 3);
  EXPECT_EQ(lines[1].at("width"), 5);
  EXPECT_EQ(lines[1].at("when"), "door # = 01h, 04h to 05h");
  EXPECT_EQ(lines[2].at("values"), json::parse(R"({"FFFF":"broken"})"));
}

TEST(ProfileJson, AQuantityHasFactorOffsetUnitRangeAndSentinels) {
  const std::vector<json> lines = lines_of("quantity");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0],
            json::parse(R"({"kind":"quantity","profile":"499-1","index":"6200","index_last":"6200",
      "sub":"01","sub_last":"03","field":"","factor":0.25,"offset":2.0,"unit":"m","min_raw":-100,
      "max_raw":100,"sentinels":{"FFFF":"failure"}})"));
}

TEST(ProfileJson, EachPieceOfACodingIsAQuantity) {
  const std::vector<json> lines = lines_of("quantity");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[2],
            json::parse(R"({"kind":"quantity","profile":"499-1","index":"6300","index_last":"6300",
      "sub":"00","sub_last":"00","field":"","piece":"far","factor":2.0,"offset":10.0,"unit":"m",
      "min_raw":11,"max_raw":20,"sentinels":{}})"));
}

TEST(ProfileJson, ADeviceHasALineForEachOfItsObjects) {
  const std::vector<json> lines = lines_of("device");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0],
            json::parse(R"({"kind":"device","profile":"499-1","code":"0A","device":"door","class":1,
      "subclass":2,"index":"6100","index_last":"6101","category":"mandatory","access":"wo",
      "consumed":false,"clause":"4"})"));
  EXPECT_EQ(lines[1].at("index"), "6200");
  EXPECT_EQ(lines[1].at("index_last"), "6200") << "a device that names no last one has this one";
  EXPECT_EQ(lines[1].at("category"), "optional");
  EXPECT_EQ(lines[1].at("access"), "ro") << "as the object says";
}

TEST(ProfileJson, APdoHasItsCanIdAndMapping) {
  const std::vector<json> lines = lines_of("pdo");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], json::parse(R"({"kind":"pdo","profile":"499-1","direction":"tpdo","number":3,
      "number_last":3,"cob_id":"$NODEID+0x180","mapping":["62000110","61000008"],
      "transmission_type":255,"inhibit_time":0,"event_timer":0})"));
  EXPECT_EQ(lines[1].at("cob_id"), "201");
  EXPECT_EQ(lines[1].at("number_last"), 4);
}

TEST(ProfileJson, AnEmergencyCodeHasItsMeaning) {
  const std::vector<json> lines = lines_of("emcy");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(
      lines[0],
      json::parse(
          R"({"kind":"emcy","profile":"499-1","code":"FF05","meaning":"overspeed","clause":"5"})"));
}

TEST(ProfileJson, EachLineOfEachProfileSaysWhatItIsAndWhoseItIs) {
  const std::set<std::string> kinds = {
      "profile",       "device_type", "entry",   "field",   "quantity", "type",
      "device",        "pdo",         "emcy",    "reading", "bit_rate", "index_range",
      "configuration", "abort",       "failure", "rule",    "coding",   "command"};
  for (const Profile* each : all_profiles()) {
    write_profile_json(*each, [&](const std::string& text) {
      const json line = json::parse(text);
      EXPECT_TRUE(kinds.contains(line.at("kind"))) << text;
      EXPECT_EQ(line.at("profile"), short_name(*each)) << text;
    });
  }
}

}  // namespace
}  // namespace canvoy::formats::profile_json_test
