// Options typed in front of the verb.
#include "canvoy/tools/node/front_options.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace canvoy::tools::front_options_test {
namespace {

using Words = std::vector<std::string>;

class FrontOptions : public testing::Test {
 protected:
  std::unique_ptr<CommandLine> line_of(std::string_view name) {
    auto line = std::make_unique<CommandLine>("", "canvoy");
    line->add({{"--colour", text_, ""}});
    Verb& verb = line->add_verb(std::string(name), "");
    if (name == "decode") {
      verb.add({{"log", text_, ""},
                {"--eds", texts_, ""},
                {"--out", text_, ""},
                {"--count", number_, ""},
                {"--json", flag_, ""}});
    } else if (name == "read") {
      verb.add({{"bus", text_, "", required},
                {"node", text_, "", required},
                {"object", texts_, "", required},
                {"--count", number_, ""},
                {"--watch", text_, "", may_be_bare},
                {"--type", text_, ""}});
    } else if (name == "run") {
      verb.add_verb("lift", "").add({{"--lifts", number_, ""}, {"--for", text_, ""}});
    } else if (name == "eds") {
      verb.add_verb("check", "").add({{"file", text_, "", required}, {"--profile", text_, ""}});
    }
    return line;
  }

  Words meant(const Words& words) {
    return with_options_behind_verb(words, [this](std::string_view verb) { return line_of(verb); });
  }

  std::string text_;
  std::vector<std::string> texts_;
  unsigned number_ = 0;
  bool flag_ = false;
};

TEST_F(FrontOptions, GoBehindTheVerbThatHasThem) {
  EXPECT_EQ(meant({"--eds", "x.eds", "decode", "a.log"}),
            (Words{"decode", "a.log", "--eds", "x.eds"}));
  EXPECT_EQ(meant({"--eds", "5=a.eds", "6=b.eds", "--json", "decode", "a.log"}),
            (Words{"decode", "a.log", "--eds", "5=a.eds", "6=b.eds", "--json"}));
  EXPECT_EQ(meant({"--count=5", "decode", "a.log", "--json"}),
            (Words{"decode", "a.log", "--json", "--count=5"}));
  EXPECT_EQ(meant({"--type", "u16", "read", "can0", "10", "2000"}),
            (Words{"read", "can0", "10", "2000", "--type", "u16"}));
  EXPECT_EQ(meant({"--colour", "never", "--count", "5", "decode", "a.log"}),
            (Words{"decode", "a.log", "--colour", "never", "--count", "5"}));
  EXPECT_EQ(meant({"--lifts", "3", "run", "lift"}), (Words{"run", "lift", "--lifts", "3"}));
  EXPECT_EQ(meant({"--profile", "418", "eds", "check", "a.eds"}),
            (Words{"eds", "check", "a.eds", "--profile", "418"}));
}

TEST_F(FrontOptions, AValueMayHaveTheNameOfAVerb) {
  EXPECT_EQ(meant({"--out", "read", "decode", "a.log"}),
            (Words{"decode", "a.log", "--out", "read"}));
  EXPECT_EQ(meant({"--watch", "read", "can0", "10", "1018"}),
            (Words{"read", "can0", "10", "1018", "--watch"}))
      << "this one needs no value";
}

TEST_F(FrontOptions, AreSpeltAsInOtherTools) {
  EXPECT_EQ(meant({"-n", "5", "decode", "a.log"}), (Words{"decode", "a.log", "-n", "5"}));
  EXPECT_EQ(meant({"-o", "a.csv", "decode", "a.log"}), (Words{"decode", "a.log", "-o", "a.csv"}));
  const Words node = {"-n", "10", "read", "can0", "1018"};
  EXPECT_EQ(meant(node), node) << "the node, not the number of values";
}

TEST_F(FrontOptions, OtherNamesOfVerbsAndThingsAloneHaveThemAsWell) {
  EXPECT_EQ(meant({"--eds", "x.eds", "cat", "a.log"}), (Words{"cat", "a.log", "--eds", "x.eds"}));
  EXPECT_EQ(meant({"--eds", "x.eds", "a.log"}), (Words{"a.log", "--eds", "x.eds"}));
  EXPECT_EQ(meant({"--lifts", "3", "lift"}), (Words{"lift", "--lifts", "3"}));
  EXPECT_EQ(meant({"--profile", "418", "validate", "a.eds"}),
            (Words{"validate", "a.eds", "--profile", "418"}));
}

TEST_F(FrontOptions, WhatEndsTheOptionsStaysBehindThem) {
  EXPECT_EQ(meant({"--eds", "x.eds", "decode", "--", "a.log"}),
            (Words{"decode", "--eds", "x.eds", "--", "a.log"}));
  const Words behind = {"--", "decode", "a.log"};
  EXPECT_EQ(meant(behind), behind);
}

TEST_F(FrontOptions, OneThatNoVerbHasIsRefusedByTheVerb) {
  EXPECT_EQ(meant({"--edz", "x.eds", "decode", "a.log"}),
            (Words{"decode", "a.log", "--edz", "x.eds"}));
  EXPECT_EQ(meant({"--type", "u16", "decode", "a.log"}),
            (Words{"decode", "a.log", "--type", "u16"}));
}

TEST_F(FrontOptions, OtherLinesAreLeftAsTheyAre) {
  for (const Words& words :
       {Words{}, Words{"decode", "a.log", "--eds", "x.eds"}, Words{"--help", "decode"},
        Words{"-h", "decode"}, Words{"--version"}, Words{"--out", "decode", "a.log"},
        Words{"--bus", "can0", "read", "10", "1018"}, Words{"-r", "night.log"},
        Words{"--edz", "x.eds"}, Words{"--edz", "x.eds", "y.eds", "decode", "a.log"}}) {
    EXPECT_EQ(meant(words), words);
  }
}

}  // namespace
}  // namespace canvoy::tools::front_options_test
