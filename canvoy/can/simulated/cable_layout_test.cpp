#include "canvoy/can/simulated/cable_layout.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::cable_layout_test {
namespace {

using Numbers = std::vector<std::vector<int>>;

CableLayout layout_of(ControllerId controllers) {
  CableLayout layout;
  for (ControllerId id = 0; id < controllers; ++id) layout.append(id);
  return layout;
}

Numbers pieces_of(const CableLayout& layout) {
  CableLayout::Pieces storage;
  Numbers numbers;
  for (const ControllerSet& piece : layout.pieces(storage)) {
    numbers.emplace_back();
    piece.for_each([&numbers](ControllerId id) { numbers.back().push_back(id); });
  }
  return numbers;
}

TEST(CableLayout, IsOnePieceUntilItIsCut) {
  EXPECT_EQ(pieces_of(layout_of(0)), Numbers{});
  EXPECT_EQ(pieces_of(layout_of(3)), (Numbers{{0, 1, 2}}));
}

TEST(CableLayout, FallsApartBehindTheControllersWhereItIsCut) {
  CableLayout sut = layout_of(5);
  sut.cut(0);
  sut.cut(3);
  EXPECT_EQ(pieces_of(sut), (Numbers{{0}, {1, 2, 3}, {4}}));
  sut.cut(4);  // there is no controller after the last one
  EXPECT_EQ(pieces_of(sut), (Numbers{{0}, {1, 2, 3}, {4}}));
}

TEST(CableLayout, GoesOnBesideAControllerThatIsUnplugged) {
  CableLayout sut = layout_of(4);
  sut.unplug(1);
  EXPECT_EQ(pieces_of(sut), (Numbers{{1}, {0, 2, 3}}));
  sut.plug(1);
  EXPECT_EQ(pieces_of(sut), (Numbers{{0, 1, 2, 3}}));
}

TEST(CableLayout, HasNoPieceWithoutControllersBesideAnUnpluggedOne) {
  CableLayout sut = layout_of(3);
  sut.cut(0);
  sut.cut(1);
  sut.unplug(1);
  EXPECT_EQ(pieces_of(sut), (Numbers{{0}, {1}, {2}}));
}

TEST(CableLayout, MendedLeavesUnpluggedWhoIs) {
  CableLayout sut = layout_of(3);
  sut.cut(0);
  sut.unplug(2);
  sut.mend();
  EXPECT_EQ(pieces_of(sut), (Numbers{{2}, {0, 1}}));
}

TEST(CableLayout, FallsIntoAsManyPiecesAsABusMayHaveControllers) {
  CableLayout sut = layout_of(128);
  for (ControllerId id = 0; id < 128; ++id) sut.cut(id);
  EXPECT_EQ(pieces_of(sut).size(), 128U);
}

}  // namespace
}  // namespace canvoy::cable_layout_test
