// Options as other tools spell them.
#include "canvoy/tools/node/typed_options.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace canvoy::tools::typed_options_test {
namespace {

using Words = std::vector<std::string>;

class TypedOptions : public testing::Test {
 protected:
  TypedOptions() {
    Verb& monitor = line_.add_verb("monitor", "");
    monitor.add({
        {"source", text_, "", required},
        {"--for", text_, ""},
        {"--count", number_, ""},
        {"--bit-rate", number_, "", between(1U, 1000U)},
        {"--node", texts_, ""},
        {"--filter", texts_, "", one_each},
        {"--table", flag_, ""},
    });
    line_.add_verb("sync", "").add({{"bus", text_, "", required}, {"--every", text_, ""}});
    line_.add_verb("record", "")
        .add({{"bus", text_, "", required}, {"out", text_, "", required}, {"--for", text_, ""}});
    Verb& read = line_.add_verb("read", "");
    read.add({{"bus", text_, "", required},
              {"node", text_, "", required},
              {"object", texts_, "", required},
              {"--watch", text_, "", may_be_bare}});
    line_.add_verb("export", "")
        .add({{"format", text_, "", required},
              {"what", texts_, "", required},
              {"--out", text_, ""}});
    Verb& eds = line_.add_verb("eds", "");
    eds.add_verb("read", "")
        .add({{"bus", text_, "", required}, {"node", text_, "", required}, {"--out", text_, ""}});
  }

  Words meant(const Words& words) const { return with_known_options(words, line_); }
  unsigned bit_rate(const char* said) {
    number_ = 0;
    const auto outcome = line_.parse({"monitor", "can0", "--bit-rate", said});
    return outcome.kind == CommandLine::Outcome::Kind::understood ? number_ : 0;
  }

  CommandLine line_{"", "canvoy"};
  std::string text_;
  std::vector<std::string> texts_;
  unsigned number_ = 0;
  bool flag_ = false;
};

TEST_F(TypedOptions, AreLeftAsTheyAreWhereTheVerbKnowsThem) {
  for (const Words& words :
       {Words{"monitor", "--table", "can0", "--count", "5"},
        Words{"monitor", "can0", "--filter=node=5"},
        Words{"monitor", "can0", "--node", "5=418", "6=419"},
        Words{"monitor", "can0", "--nonsense", "5"}, Words{"nonsense", "-n", "5"},
        Words{"read", "can0", "10", "1018"}, Words{"eds", "read", "can0", "10", "--out", "a.dcf"},
        Words{"eds", "read", "can0", "10", "-o", "a.dcf"}, Words{}}) {
    EXPECT_EQ(meant(words), words);
  }
}

TEST_F(TypedOptions, AreFoundByOtherSpellings) {
  EXPECT_EQ(meant({"monitor", "can0", "-n", "5"}), (Words{"monitor", "can0", "--count", "5"}));
  EXPECT_EQ(meant({"monitor", "can0", "--bitrate", "125k"}),
            (Words{"monitor", "can0", "--bit-rate", "125k"}));
  EXPECT_EQ(meant({"monitor", "can0", "--Bit_Rate=125"}),
            (Words{"monitor", "can0", "--bit-rate", "125"}));
  EXPECT_EQ(meant({"monitor", "--duration", "5s", "can0", "--table"}),
            (Words{"monitor", "can0", "--for", "5s", "--table"}));
  EXPECT_EQ(meant({"monitor", "can0", "--id", "18A"}),
            (Words{"monitor", "can0", "--filter", "id=18A"}));
  EXPECT_EQ(meant({"sync", "can0", "--period", "10ms"}),
            (Words{"sync", "can0", "--every", "10ms"}));
  EXPECT_EQ(meant({"read", "can0", "10", "1018", "--interval", "1s"}),
            (Words{"read", "can0", "10", "1018", "--watch", "1s"}));
}

TEST_F(TypedOptions, SeveralValuesHaveOneForm) {
  EXPECT_EQ(meant({"monitor", "--node", "5=418", "6=419", "a.log", "--table"}),
            (Words{"monitor", "a.log", "--node", "5=418", "6=419", "--table"}));
}

TEST_F(TypedOptions, APlaceMayBeSaidByItsName) {
  EXPECT_EQ(meant({"record", "can0", "-o", "a.log"}), (Words{"record", "can0", "a.log"}));
  EXPECT_EQ(meant({"record", "--out=a.log", "--bus", "can0", "--for", "1s"}),
            (Words{"record", "can0", "a.log", "--for", "1s"}));
  EXPECT_EQ(meant({"read", "can0", "--node", "10", "--index", "0x1018", "--sub", "1"}),
            (Words{"read", "can0", "10", "0x1018:1"}));
  EXPECT_EQ(meant({"export", "dbc", "can0", "--node", "10"}),
            (Words{"export", "dbc", "can0", "10"}));
  const Words without_bus = {"record", "-o", "a.log"};
  EXPECT_EQ(meant(without_bus), without_bus) << "the bus is missing";
}

TEST_F(TypedOptions, AFurtherWordIsWhatItsFormSays) {
  EXPECT_EQ(meant({"sync", "can0", "100ms"}), (Words{"sync", "can0", "--every", "100ms"}));
  EXPECT_EQ(meant({"record", "can0", "a.log", "10s"}),
            (Words{"record", "can0", "a.log", "--for", "10s"}));
  EXPECT_EQ(meant({"eds", "read", "can0", "10", "a.dcf"}),
            (Words{"eds", "read", "can0", "10", "--out", "a.dcf"}));
  const Words twice = {"sync", "can0", "100ms", "--every", "1s"};
  EXPECT_EQ(meant(twice), twice);
  const Words other = {"sync", "can0", "quickly"};
  EXPECT_EQ(meant(other), other);
  EXPECT_EQ(meant({"export", "dbc", "5=a.eds", "b.eds", "all.dbc"}),
            (Words{"export", "dbc", "5=a.eds", "b.eds", "--out", "all.dbc"}));
  const Words objects = {"read", "can0", "10", "1018", "1s"};
  EXPECT_EQ(meant(objects), objects) << "several objects may stand there";
}

TEST_F(TypedOptions, WordsStandInAnyOrderThatTheirFormTells) {
  EXPECT_EQ(meant({"read", "can0", "temperature", "10"}),
            (Words{"read", "can0", "10", "temperature"}));
  EXPECT_EQ(meant({"read", "can0", "1018", "1008", "10"}),
            (Words{"read", "can0", "10", "1018", "1008"}));
  EXPECT_EQ(meant({"eds", "read", "10", "can0"}), (Words{"eds", "read", "can0", "10"}));
  const Words two_nodes = {"read", "can0", "1018", "5", "10"};
  EXPECT_EQ(meant(two_nodes), two_nodes) << "either may be the node";
  const Words fits = {"read", "can0", "10", "20"};
  EXPECT_EQ(meant(fits), fits);
  const Words mistyped = {"read", "can0", "200", "10"};
  EXPECT_EQ(meant(mistyped), mistyped) << "no other node is asked";
  ::setenv("CANVOY_NETWORK", "network.toml", 1);
  const Words named = {"read", "can0", "pump", "10"};
  EXPECT_EQ(meant(named), named) << "pump may be a node of the file";
  ::unsetenv("CANVOY_NETWORK");
  const Words no_node = {"read", "can0", "pump", "temperature"};
  EXPECT_EQ(meant(no_node), no_node);
}

TEST_F(TypedOptions, AListWithCommasIsSeveralWords) {
  EXPECT_EQ(meant({"read", "can0", "10", "1000,1001,1018"}),
            (Words{"read", "can0", "10", "1000", "1001", "1018"}));
  for (const Words& words : {Words{"read", "can0", "10", "0x1018,1"},
                             Words{"read", "can0", "10", "TPDO mapping parameter, number"},
                             Words{"monitor", "can0,can1"}}) {
    EXPECT_EQ(meant(words), words);
  }
}

TEST_F(TypedOptions, BitRatesAreReadInAnyForm) {
  for (const char* text : {"125", "125k", "125000", "125kbit/s", "0.125M"}) {
    EXPECT_EQ(bit_rate(text), 125U) << text;
  }
  for (const char* text : {"83333", "0", "fast", "2M", "1001"})
    EXPECT_EQ(bit_rate(text), 0U) << text;
}

}  // namespace
}  // namespace canvoy::tools::typed_options_test
