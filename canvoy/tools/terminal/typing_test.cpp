#include "canvoy/tools/terminal/typing.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::typing_test {
namespace {

TEST(Typing, ArrowsAndPagesMove) {
  constexpr std::size_t shown = 10;
  constexpr std::size_t count = 100;
  const auto row_after = [](std::size_t row, Key key) {
    return moved_row(row, rows_moved(key, shown, count).value(), count);
  };
  EXPECT_EQ(row_after(5, Key::up), 4U);
  EXPECT_EQ(row_after(0, Key::up), 0U);
  EXPECT_EQ(row_after(98, Key::down), 99U);
  EXPECT_EQ(row_after(99, Key::down), 99U);
  EXPECT_EQ(row_after(5, Key::page_down), 14U) << "one row stays to be seen";
  EXPECT_EQ(row_after(14, Key::page_up), 5U);
  EXPECT_EQ(row_after(50, Key::home), 0U);
  EXPECT_EQ(row_after(50, Key::end), 99U);
  EXPECT_EQ(rows_moved(Key{'q'}, shown, count), std::nullopt);
  EXPECT_EQ(rows_moved(Key::enter, shown, count), std::nullopt);
  EXPECT_EQ(moved_row(5, 1, 0), 0U) << "there is none";
  EXPECT_EQ(rows_moved(Key::page_down, 1, count), 1) << "of the smallest screen";
}

TEST(Typing, ACharacterIsPutBehindAndTakenBackWhole) {
  std::string text;
  for (const char byte : std::string("5 \xC2\xB0"))
    type_key(text, Key{static_cast<unsigned char>(byte)});
  EXPECT_EQ(text, "5 \xC2\xB0");
  type_key(text, Key::backspace);
  EXPECT_EQ(text, "5 ");
  for (const Key key : {Key::up, Key::home, Key::escape, Key::enter, Key{'\t'}})
    type_key(text, key);
  EXPECT_EQ(text, "5 ");
  for (int i = 0; i < 3; ++i) type_key(text, Key::backspace);
  EXPECT_EQ(text, "");
}

}  // namespace
}  // namespace canvoy::tools::typing_test
