#include <gtest/gtest.h>

#include "canvoy/formats/signals/dbc_writer.hpp"
#include "canvoy/formats/signals/signal_csv.hpp"
#include "canvoy/formats/signals/signal_html.hpp"

namespace canvoy::formats {
namespace dbc_writer_test {

SignalTable table_with(std::vector<Signal> signals) {
  SignalTable table;
  table.nodes = {{.name = "pump", .id = 5}};
  table.messages = {{.can_id = 0x185,
                     .length = 8,
                     .name = "pump TPDO1",
                     .senders = {"pump"},
                     .signals = std::move(signals)}};
  return table;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(DbcWriter, NamesAreThoseOfC) {
  EXPECT_EQ(identifier_of("Input group 1, Virtual input 3"), "Input_group_1_Virtual_input_3");
  EXPECT_EQ(identifier_of("3rd (left)"), "_3rd_left");
  EXPECT_EQ(identifier_of("\xC3\xB6l"), "l");
  EXPECT_EQ(identifier_of("..."), "_");
}

TEST(DbcWriter, NumbersHaveTheirBitsScaleAndLimits) {
  const std::string dbc = write_dbc(table_with({{.name = "level",
                                                 .first_bit = 8,
                                                 .bits = 16,
                                                 .type = Signal::Type::signed_number,
                                                 .factor = 0.125,
                                                 .offset = -40,
                                                 .unit = "\xC2\xB0"
                                                         "C",
                                                 .limits = std::pair{-40.0, 85.0},
                                                 .states = {{-1, "in\"valid"}}}}));
  EXPECT_TRUE(has(dbc, "BO_ 389 pump_TPDO1: 8 pump\n"));
  EXPECT_TRUE(has(dbc,
                  " SG_ level : 8|16@1- (0.125,-40) [-40|85] \"\xB0"
                  "C\" Vector__XXX\n"))
      << "ISO 8859-1\n"
      << dbc;
  EXPECT_TRUE(has(dbc, "VAL_ 389 level -1 \"in'valid\" ;\n"))
      << "it has no way to write a quotation mark";
}

TEST(DbcWriter, LongNamesAreShortenedAndStayDifferent) {
  const std::string name(40, 'x');
  const std::string dbc =
      write_dbc(table_with({{.name = name + "1"}, {.name = name + "2", .first_bit = 1}}));
  EXPECT_TRUE(has(dbc, " SG_ " + std::string(32, 'x') + " :"));
  EXPECT_TRUE(has(dbc, " SG_ " + std::string(30, 'x') + "_1 :"));
  EXPECT_TRUE(has(dbc, "BA_ \"SystemSignalLongSymbol\" SG_ 389 " + std::string(30, 'x') + "_1 \"" +
                           name + "2\";\n"));
}

TEST(DbcWriter, EqualNamesAreToldApart) {
  const std::string dbc =
      write_dbc(table_with({{.index = 0x6000, .sub = 1, .name = "input"},
                            {.index = 0x6000, .sub = 2, .name = "input", .first_bit = 8}}));
  EXPECT_TRUE(has(dbc, " SG_ input :"));
  EXPECT_TRUE(has(dbc, " SG_ input_6000_02 :"));
}

TEST(DbcWriter, MultiplexedSignalsAndRealNumbersAreMarked) {
  const std::string dbc = write_dbc(table_with(
      {{.name = "which", .bits = 8, .is_selector = true},
       {.name = "a", .first_bit = 8, .bits = 32, .type = Signal::Type::real32, .selected_by = 7}}));
  EXPECT_TRUE(has(dbc, " SG_ which M : 0|8@1+"));
  EXPECT_TRUE(has(dbc, " SG_ a m7 : 8|32@1-"));
  EXPECT_TRUE(has(dbc, "SIG_VALTYPE_ 389 a : 1;\n"));
}

TEST(DbcWriter, SeveralSendersAreAllNamed) {
  SignalTable table = table_with({});
  table.nodes.push_back({.name = "spare", .id = 6});
  table.messages.front().senders.push_back("spare");
  EXPECT_TRUE(has(write_dbc(table), "BO_TX_BU_ 389 : pump,spare;\n"));
}

TEST(SignalCsv, ColumnsAreQuotedWhereTheyHaveTo) {
  SignalTable table;
  table.nodes = {{.name = "pump",
                  .id = 5,
                  .dictionary = {{.index = 0x2000, .name = "a, \"b\"", .type = "UNSIGNED8"}}}};
  EXPECT_TRUE(has(write_signal_csv(table), "5,pump,2000,00,\"a, \"\"b\"\"\",UNSIGNED8,"));
}

TEST(SignalHtml, TextsDoNotCommandThePage) {
  SignalTable table;
  table.nodes = {{.name = "<b>&", .id = 5}};
  const std::string page = write_signal_html(table, "a<b");
  EXPECT_TRUE(has(page, "&lt;b&gt;&amp;"));
  EXPECT_FALSE(has(page, "<b>"));
  EXPECT_TRUE(has(page, "<title>a&lt;b</title>"));
}

}  // namespace dbc_writer_test
}  // namespace canvoy::formats
