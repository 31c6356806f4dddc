#include "canvoy/canopen/manager/sdo_call_search.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::sdo_call_search_test {
namespace {

constexpr NodeId manager = 1;

std::vector<int> all_next(SdoCallSearch& search) {
  std::vector<int> nodes;
  while (const NodeId node = search.next(manager)) nodes.push_back(node);
  return nodes;
}

/// Nodes 5 and 9 were heard, and the manager itself.
SdoCallSearch called_search() {
  SdoCallSearch search;
  for (const NodeId node : {NodeId{9}, NodeId{5}, NodeId{1}}) search.hear(node, true);
  search.call();
  search.begin();
  return search;
}

TEST(SdoCallSearch, AsksNobodyUntilSomebodyCalls) {
  SdoCallSearch sut;
  sut.hear(5, true);
  EXPECT_FALSE(sut.is_called());
  EXPECT_EQ(sut.next(manager), 0);
  sut.call();
  EXPECT_TRUE(sut.is_called());
  sut.begin();
  EXPECT_FALSE(sut.is_called());
  EXPECT_EQ(sut.next(manager), 5);
}

TEST(SdoCallSearch, AsksAllOthersOnceThoseThatWereHeardFirst) {
  SdoCallSearch sut = called_search();
  const std::vector<int> nodes = all_next(sut);
  ASSERT_EQ(nodes.size(), 126U);
  EXPECT_EQ((std::vector<int>{nodes[0], nodes[1], nodes[2]}), (std::vector<int>{5, 9, 2}));
  EXPECT_EQ(nodes.back(), 127);
  EXPECT_EQ(sut.next(manager), 0) << "it is over";
}

TEST(SdoCallSearch, LeavesOutThoseThatWereNotHeardOnceItHasFoundOne) {
  SdoCallSearch sut = called_search();
  EXPECT_EQ(sut.next(manager), 5);
  sut.find(5);
  EXPECT_EQ(all_next(sut), std::vector<int>{9});
}

TEST(SdoCallSearch, IsOverWhenOneIsFoundThatWasNotHeard) {
  SdoCallSearch sut = called_search();
  for (const int node : {5, 9, 2}) EXPECT_EQ(sut.next(manager), node);
  sut.find(2);
  EXPECT_EQ(sut.next(manager), 0);
}

TEST(SdoCallSearch, AsksThoseThatWereHeardOnceMoreWhenSomebodyCallsMeanwhile) {
  SdoCallSearch sut = called_search();
  for (const int node : {5, 9, 2, 3}) EXPECT_EQ(sut.next(manager), node);
  sut.call();
  sut.begin();
  for (const int node : {5, 9, 4}) EXPECT_EQ(sut.next(manager), node);
}

TEST(SdoCallSearch, TakesANodeThatWasLostForOneThatWasNotHeard) {
  SdoCallSearch sut = called_search();
  sut.hear(5, false);
  EXPECT_EQ(sut.next(manager), 9);
}

}  // namespace
}  // namespace canvoy::sdo_call_search_test
