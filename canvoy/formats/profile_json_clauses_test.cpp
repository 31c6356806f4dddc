// Content of single clauses as JSON. Expected values are typed from the clauses; where errata
// apply, their numbers are given.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "canvoy/formats/profile_json.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::formats::profile_json_clauses_test {
namespace {

using nlohmann::json;

/// The lines of a profile, made once for all tests, since it takes long with sanitizers.
const std::vector<std::string>& text_of(const char* profile) {
  static std::map<std::string, std::vector<std::string>> texts;
  std::vector<std::string>& text = texts[profile];
  if (text.empty()) {
    write_profile_json(*find_profile(profile),
                       [&text](const std::string& line) { text.push_back(line); });
  }
  return text;
}

std::vector<json> lines_of(const char* profile, const std::string& kind) {
  std::vector<json> lines;
  // Parsing a whole profile takes seconds.
  const std::string start = R"({"kind":")" + kind + "\"";
  for (const std::string& text : text_of(profile)) {
    if (text.starts_with(start)) lines.push_back(json::parse(text));
  }
  return lines;
}
/// Lines with this index; a device without objects has none.
std::vector<json> lines_at(const char* profile, const std::string& kind, const char* index) {
  std::vector<json> lines = lines_of(profile, kind);
  std::erase_if(lines, [&](const json& line) { return line.value("index", "") != index; });
  return lines;
}
json object_of(json line) {
  line.erase("kind");
  line.erase("profile");
  return line;
}

// The table prints wo for all of 6205h (CiA 407, 6.4); the access by sub-index applies (CiA 407,
// 9.2.8.6, errata 29).
TEST(ProfileJsonClauses, TheCharacterSetIsWoInTheTableOfTheDeviceAndRwAndRoInItsEntries) {
  const std::vector<json> devices = lines_at("407", "device", "6205");
  EXPECT_EQ(devices.size(), 7U) << "classes 2 and 3 but 2.1";
  for (const json& line : devices) {
    EXPECT_EQ(line.at("access"), "wo");
    EXPECT_EQ(line.at("clause"), "6.4");
    EXPECT_EQ(line.at("errata"), "29");
  }
  const std::vector<json> entries = lines_at("407", "entry", "6205");
  ASSERT_GE(entries.size(), 3U);
  EXPECT_EQ(entries[1].at("access"), "rw");
  EXPECT_EQ(entries[2].at("access"), "ro");
}

// Sub-index 01h is rw, 02h is ro (CiA 417-4, 4.11.1.8).
TEST(ProfileJsonClauses, TheMostVelocityOfACarDriveCanBeWritten) {
  const std::vector<json> devices = lines_at("417-4", "device", "6408");
  ASSERT_EQ(devices.size(), 1U);
  EXPECT_EQ(devices[0].at("access"), "rw") << "as one of its entries";
  const std::vector<json> entries = lines_at("417-4", "entry", "6408");
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[1].at("access"), "rw");
  EXPECT_EQ(entries[2].at("access"), "ro");
}

// Numbers with a meaning of 0 (CiA 407, 9.2.6.7, 9.2.6.8, 9.2.7.6).
TEST(ProfileJsonClauses, AZeroThatSaysSomethingHasItsName) {
  struct Zero {
    const char* index;
    const char* pattern;
    const char* name;
  };
  for (const auto& [index, pattern, name] :
       {Zero{"6106", "00000000", "no driver schedule assigned"},
        Zero{"6107", "00000000", "no route destination assigned"},
        Zero{"6195", "0000", "non-service journey"}}) {
    const std::vector<json> fields = lines_at("407", "field", index);
    ASSERT_EQ(fields.size(), 1U) << index;
    EXPECT_EQ(fields[0].at("values"), (json{{pattern, name}}));
    EXPECT_TRUE(lines_at("407", "quantity", index).empty()) << index << " identifies";
  }
}

// Unused characters are 0; there are eight (CiA 407, 9.2.6.12 and 9.2.6.25).
TEST(ProfileJsonClauses, UnusedCharactersAreZero) {
  for (const char* index : {"610B", "6118"}) {
    const std::vector<json> fields = lines_at("407", "field", index);
    ASSERT_EQ(fields.size(), 2U) << index;
    EXPECT_EQ(fields[0].at("sub"), "01");
    EXPECT_EQ(fields[1].at("sub_last"), "08");
    for (const json& line : fields) EXPECT_EQ(line.at("values"), (json{{"00", "unused"}}));
    EXPECT_EQ(lines_at("407", "quantity", index).size(), 1U) << "the number of characters";
  }
}

// CiA 407, 9.2.25.1, 9.2.26.2 and 9.2.26.3.
TEST(ProfileJsonClauses, PassengersAreCounted) {
  const std::vector<json> by_door = lines_at("407", "quantity", "6700");
  ASSERT_EQ(by_door.size(), 2U);
  EXPECT_EQ(by_door[1].at("max_raw"), 255);
  EXPECT_EQ(lines_at("407", "quantity", "6721").size(), 3U) << "in, out, and the number of entries";
  const std::vector<json> sum = lines_at("407", "quantity", "6722");
  ASSERT_EQ(sum.size(), 1U);
  EXPECT_EQ(sum[0].at("factor"), 1);
  EXPECT_EQ(sum[0].at("max_raw"), 65535);
}

// The colour is to be defined, FFh means unused; the others are in 1/10 Hz and in lines per second
// (CiA 417-4, 4.5.4).
TEST(ProfileJsonClauses, ColorsOfOutputsAreToBeDefined) {
  const std::vector<json> fields = lines_at("417-4", "field", "6280");
  const auto color = std::ranges::find(
      fields, "Color", [](const json& line) { return line.at("field").get<std::string>(); });
  ASSERT_NE(color, fields.end());
  EXPECT_EQ(color->at("values"), (json{{"00-FE", "to be defined"}, {"FF", "not used"}}));
  for (const json& line : lines_at("417-4", "quantity", "6280")) {
    EXPECT_NE(line.at("field"), "Color");
    EXPECT_TRUE(line.at("field") != "" || line.at("sub") == "00") << "bit fields are no number";
  }
}

// Bits 15 to 2 of the function data, signed (CiA 417-4, 4.13.1, errata A21); 6012h is the same (CiA
// 417-4, 4.2.5, errata A8).
TEST(ProfileJsonClauses, ASensorMeasures) {
  for (const char* index : {"6012", "6500"}) {
    std::vector<json> lines = lines_at("417-4", "quantity", index);
    std::erase_if(lines, [](const json& line) { return line.at("field") != "Sensor value"; });
    ASSERT_EQ(lines.size(), index == std::string_view("6012") ? 1U : 2U);
    for (const json& line : lines) {
      EXPECT_EQ(line.at("min_raw"), -8192);
      EXPECT_EQ(line.at("max_raw"), 8191);
      EXPECT_EQ(line.at("factor"), 1);
    }
    EXPECT_EQ(lines.back().at("sub_last"), index == std::string_view("6012") ? "00" : "FE");
  }
  // SI unit and prefix are in sensor parameter 3, of the same group and sensor (CiA 417-4, 4.13.4).
  std::vector<json> sensors = lines_at("417-4", "quantity", "6500");
  std::erase_if(sensors, [](const json& line) { return line.at("field") != "Sensor value"; });
  EXPECT_EQ(sensors.front().at("unit_entry"), "6560:01");
  EXPECT_EQ(sensors.back().at("unit_entry"), "6560:02") << "of sensors 2 to 254";
  EXPECT_EQ(sensors.back().at("unit_entry_last"), "657F:FE");
}

// Times of an impulse and frequencies of flashing, by property parameter (CiA 417-4, 4.4.1).
TEST(ProfileJsonClauses, EachImpulseAndFlashingIsANumberAndNoSentinel) {
  const double impulses[] = {0.5, 1, 1.5, 2, 3, 5, 10, 15};
  const double frequencies[] = {10, 7.5, 5, 2, 1.5, 1, 0.5, 0.25};
  for (const char* index : {"6011", "6200"}) {
    unsigned seen = 0;
    for (const json& line : lines_at("417-4", "quantity", index)) {
      const bool is_impulse = line.at("field") == "Impulse";
      if (!is_impulse && line.at("field") != "Flashing") continue;
      if (line.at("sub") == "02") continue;  // the other outputs
      EXPECT_TRUE(line.at("sentinels").empty());
      EXPECT_EQ(line.at("unit"), is_impulse ? "s" : "Hz");
      const int last = line.at("max_raw");
      for (int raw = line.at("min_raw"); raw <= last; ++raw, ++seen) {
        const double number =
            raw * line.at("factor").get<double>() + line.at("offset").get<double>();
        EXPECT_DOUBLE_EQ(number, (is_impulse ? impulses : frequencies)[raw]);
      }
    }
    EXPECT_EQ(seen, 16U) << index;
  }
}

// Amounts in units of the drive (no unit here), and in physical ones (CiA 402).
TEST(ProfileJsonClauses, AmountsOfADriveAreQuantitiesAndItsCodesAreNot) {
  const auto unit_of = [](const char* index) -> std::string {
    const std::vector<json> lines = lines_at("402", "quantity", index);
    return lines.empty() ? "no quantity" : lines.back().at("unit").get<std::string>();
  };
  for (const char* index :
       {"6064", "6065", "6067", "6069", "606B", "606C", "606D", "606F", "607A", "607B", "607C",
        "607D", "607F", "6081", "6082", "6083", "6084", "6085", "608F", "6090", "6091", "6092",
        "6099", "609A", "60A4", "60C5", "60C6", "60F4", "60F8", "60FA", "60FC", "60FF"}) {
    EXPECT_EQ(unit_of(index), "") << index;
  }
  for (const char* index : {"6071", "6072", "6073", "6074", "6077", "6078", "6087"}) {
    EXPECT_EQ(unit_of(index), "‰") << index << " of the rated one";
  }
  for (const char* index : {"6066", "6068", "606E", "6070"}) EXPECT_EQ(unit_of(index), "ms");
  EXPECT_EQ(unit_of("6075"), "A");
  EXPECT_EQ(unit_of("6076"), "Nm");
  EXPECT_EQ(unit_of("6079"), "V");
  EXPECT_EQ(unit_of("6080"), "1/min");
  for (const char* index : {"6040", "6041", "605A", "6060", "6061", "606A", "607E", "6086", "608A",
                            "608C", "6098", "60FD", "6402", "6502"}) {
    EXPECT_EQ(unit_of(index), "no quantity") << index;
  }
  for (const json& line : lines_at("402", "quantity", "60FE")) EXPECT_EQ(line.at("sub"), "00");
}

// Like those of CiA 402 (CiA 417-4, 4.11.1 to 4.11.6).
TEST(ProfileJsonClauses, AmountsOfTheDriveOfACarAreThoseOfCia402) {
  const auto unit_of = [](const char* index, const char* sub) -> std::string {
    for (const json& line : lines_at("417-4", "quantity", index)) {
      if (line.at("sub") == sub) return line.at("unit");
    }
    return "no quantity";
  };
  for (const char* index :
       {"6406", "640A", "6420", "6423", "6424", "6428", "6430", "6431", "6432", "6433", "6437"}) {
    EXPECT_EQ(unit_of(index, "00"), "") << index;
  }
  for (const char* index :
       {"6408", "6409", "640B", "640D", "6414", "6415", "6416", "6417", "6418", "6419", "641A",
        "641B", "641C", "641D", "6421", "6422", "6435", "6436", "6438"}) {
    EXPECT_EQ(unit_of(index, "01"), "") << index;
  }
  EXPECT_EQ(unit_of("6408", "02"), "1/min") << "as 6080h";
  EXPECT_EQ(unit_of("6435", "02"), "ms") << "as 606Eh";
  EXPECT_EQ(unit_of("6436", "02"), "ms") << "as 6070h";
  for (const char* index : {"6400", "6401", "6403", "6404", "6405", "640C", "641E", "6434"}) {
    EXPECT_EQ(unit_of(index, "00"), "no quantity") << index;
  }
  EXPECT_EQ(unit_of("6410", "02"), "no quantity") << "the code of a unit";
}

// Positions and values of displays are analogue; switches, indicators and memory functions are bits
// (CiA 852, 9.2 to 9.8).
TEST(ProfileJsonClauses, PositionsOfACabinAreQuantitiesAndItsSwitchesAreNot) {
  const auto counts = [](const char* index) {
    std::size_t found = 0;
    for (const json& line : lines_at("852", "quantity", index)) {
      if (line.at("sub") == "00") continue;
      ++found;
      EXPECT_EQ(line.at("unit"), "") << index;
    }
    return found;
  };
  EXPECT_EQ(counts("6401"), 16U * 3U + 16U + 8U) << "joysticks, foot pedals, wheels";
  EXPECT_EQ(counts("6120"), 8U) << "encoders";
  for (const char* index : {"6411", "6413", "6444", "6445"}) EXPECT_EQ(counts(index), 8U * 12U);
  for (const char* index : {"6000", "6200", "6206", "6207", "6423", "6443"}) {
    EXPECT_EQ(counts(index), 0U) << index;
  }
}

// All loads are in the unit of 6480h:02h, kg if it does not exist (CiA 417-4, 4.12.1 to 4.12.5).
TEST(ProfileJsonClauses, LoadsAreInTheUnitThatTheLoadUnitTells) {
  for (const char* index : {"6480", "6481", "6483", "6484"}) {
    unsigned loads = 0;
    for (const json& line : lines_at("417-4", "quantity", index)) {
      if (line.at("sub") == "00") continue;
      ++loads;
      EXPECT_EQ(line.at("unit"), "kg") << index;
      EXPECT_EQ(line.at("unit_entry"), "6480:02") << index;
      EXPECT_EQ(line.at("unit_entry_last"), "6480:02") << index;
    }
    EXPECT_GE(loads, 1U) << index;
  }
  EXPECT_EQ(lines_at("417-4", "quantity", "6482").size(), 1U) << "signals are bits";
}

TEST(ProfileJsonClauses, NoCodeAndNoBitFieldIsAQuantity) {
  // Error codes, SI units and prefixes, lifts by bits, tariffs and their characters.
  for (const char* index : {"6001", "6010"})
    EXPECT_TRUE(lines_at("417-4", "quantity", index).empty());
  for (const char* index : {"6120", "6220", "6520", "6560"}) {
    for (const json& line : lines_at("417-4", "quantity", index)) {
      const std::string field = line.at("field");
      EXPECT_TRUE(line.at("sub") == "00" || line.at("unit") != "") << index << " " << field;
    }
  }
  for (const char* index : {"60D3", "610A"})
    EXPECT_TRUE(lines_at("447-3", "quantity", index).empty());
  for (const json& line : lines_at("447-3", "quantity", "60DA")) {
    EXPECT_NE(line.at("sub"), "03");
    EXPECT_NE(line.at("sub"), "07");
  }
}

// CiA 407, 8.1.4.1 and 8.1.4.2.
TEST(ProfileJsonClauses, TheConfigurationsOfAVehicleNameTheirDevices) {
  const std::vector<json> lines = lines_of("407", "configuration");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(object_of(lines[0]),
            json::parse(R"({"name":"minimum configuration","clause":"8.1.4.1","devices":[
      {"code":"01","class":0,"subclass":0},{"code":"02","class":0,"subclass":0},
      {"code":"03","class":1,"subclass":2},{"code":"04","class":0,"subclass":0}]})"));
  EXPECT_EQ(lines[1].at("name"), "typical configuration");
  ASSERT_EQ(lines[1].at("devices").size(), 6U);
  EXPECT_EQ(lines[1].at("devices")[3], json::parse(R"({"code":"03","class":2,"subclass":2})"));
  EXPECT_EQ(lines[1].at("devices")[5].at("code"), "05");
}

// CiA 407, 9.1.
TEST(ProfileJsonClauses, IndexRangesSayWhoseTheyAre) {
  const std::vector<json> lines = lines_of("407", "index_range");
  ASSERT_EQ(lines.size(), 27U);
  EXPECT_EQ(
      object_of(lines[2]),
      json::parse(
          R"({"index":"6190","index_last":"61FF","owner":"Identification device","clause":"9.1"})"));
  EXPECT_EQ(lines[7].at("index"), "6380");
  EXPECT_EQ(lines[7].at("index_last"), "63AF");
  EXPECT_EQ(lines[24].at("owner"), "Power supply");
  EXPECT_EQ(lines[26].at("index_last"), "9FFF");
}

// Two codes for each of two reasons (CiA 417-4, 4.2.6).
TEST(ProfileJsonClauses, TheCreationOfAnObjectIsAbortedWithTheseCodes) {
  const std::vector<json> lines = lines_at("417-4", "abort", "6020");
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(object_of(lines[0]), json::parse(R"({"index":"6020","sub":"00","code":"06090030",
      "when":"the device does not support the object","clause":"4.2.6"})"));
  EXPECT_EQ(lines[1].at("code"), "08000000");
  EXPECT_EQ(lines[2].at("code"), "05040005");
  EXPECT_EQ(lines[2].at("when"), "no resources are left for the object");
  EXPECT_EQ(lines[3].at("code"), "08000000");
}

// CiA 852, 5.3 and 6.2.
TEST(ProfileJsonClauses, AnOperatorEnvironmentHasItsBitRatesAndNumbers) {
  std::vector<unsigned> mandatory;
  for (const json& line : lines_of("852", "bit_rate")) {
    EXPECT_TRUE(line.at("clause").get<std::string>().starts_with("6.2"));
    if (line.at("category") == "mandatory") mandatory.push_back(line.at("kbit_per_second"));
  }
  EXPECT_EQ(mandatory, (std::vector<unsigned>{125, 250, 500, 1000}));
  const std::vector<json> rules = lines_of("852", "rule");
  ASSERT_FALSE(rules.empty());
  EXPECT_EQ(object_of(rules[0]), json::parse(R"({"subject":"numbering of sub-devices",
      "rule":"odd numbers: of the right hand or foot","clause":"5.3"})"));
}

// CiA 419, 5.2 and 4.2.2; CiA 407, 7.2.
TEST(ProfileJsonClauses, FailuresThatTheErrorBehaviourActsOn) {
  const std::vector<json> failures = lines_of("419", "failure");
  ASSERT_EQ(failures.size(), 3U);
  EXPECT_EQ(failures[0].at("failure"), "the CAN interface is bus-off");
  EXPECT_EQ(failures[1].at("failure"), "a heartbeat event has occurred");
  EXPECT_EQ(failures[2].at("clause"), "5.2");
  ASSERT_EQ(lines_of("419", "bit_rate").size(), 1U);
  EXPECT_EQ(lines_of("419", "bit_rate")[0].at("kbit_per_second"), 125);
  EXPECT_EQ(lines_of("407", "failure").size(), 4U);
}

// CiA 447-3, Table 381.
TEST(ProfileJsonClauses, APrinterTakesWhatItsModeSays) {
  const std::vector<json> codings = lines_at("447-3", "coding", "60EB");
  ASSERT_EQ(codings.size(), 6U);
  EXPECT_EQ(object_of(codings[1]), json::parse(R"({"index":"60EB","sub":"00","selector":"60EA",
      "selected":"01","content":"Graphics black with ESC",
      "coding":"1 bit a pixel, 1: a dot; the leftmost in the MSB",
      "clause":"4.2.13.10, Table 381"})"));
  EXPECT_EQ(codings[5].at("coding"), "1 byte a logo: 20h is logo 1, 33h logo 20");
  std::vector<std::string> bytes;
  for (const json& line : lines_at("447-3", "command", "60EB")) {
    bytes.push_back(line.at("selected").get<std::string>() + " " +
                    line.at("bytes").get<std::string>());
  }
  EXPECT_EQ(bytes,
            (std::vector<std::string>{"01 1B04", "01 1B0A", "01 1B0D", "01 1B1B", "00 04", "00 0A",
                                      "00 0D", "00 1B", "05 04", "05 0A", "05 0D", "05 1B"}));
}

// 128 and 64 octets (CiA 407, 9.2.6.13 and 9.2.27.3); no number (CiA 407, 9.2.6.29).
TEST(ProfileJsonClauses, WhoSaysHowLongAStringMayBe) {
  const auto text = [](const char* profile, const char* index) {
    return lines_at(profile, "entry", index).back();
  };
  EXPECT_EQ(text("407", "610C").at("capacity"), 128);
  EXPECT_EQ(text("407", "610C").at("capacity_is_printed"), true);
  EXPECT_EQ(text("407", "6742").at("capacity"), 64);
  EXPECT_EQ(text("407", "6742").at("capacity_is_printed"), true);
  EXPECT_EQ(text("447-3", "602B").at("capacity"), 17);
  EXPECT_EQ(text("447-3", "602B").at("capacity_is_printed"), true);
  EXPECT_FALSE(text("407", "611C").contains("capacity_is_printed")) << "our choice";
}

}  // namespace
}  // namespace canvoy::formats::profile_json_clauses_test
