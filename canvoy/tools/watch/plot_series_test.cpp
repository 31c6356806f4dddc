#include "canvoy/tools/watch/plot_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace canvoy::tools {
namespace plot_series_test {

TEST(PlotSeries, ItKeepsThePeakOfAYearInAsMuchRoomAsASecondTakes) {
  PlotSeries series("level", "%");
  for (int i = 0; i < 1'000'000; ++i) series.add(i * 31.5, i == 123'456 ? 99 : 1);
  const auto spans = series.spans();
  EXPECT_LE(spans.size(), 2048U);
  const auto peak = std::ranges::max_element(spans, {}, &PlotSeries::Span::most);
  EXPECT_EQ(peak->most, 99);
  EXPECT_EQ(peak->least, 1);
  EXPECT_NEAR(peak->time, 123'456 * 31.5, 31.5 * 1'000'000 / 1000);
}

TEST(PlotDots, OneValueIsSeen) {
  std::vector<PlotSeries> series = {PlotSeries("level", "%")};
  series[0].add(0, 5);
  const Picture picture = plot_dots(series, "one.log");
  // A diagram: 48 pixels for the title, 260, and 40 for the time.
  ASSERT_EQ(picture.width(), 960U);
  ASSERT_EQ(picture.height(), 348U);
  // The axes are from 4.5 to 5.5, 260 pixels high, and from -1 s to 1 s, 810 wide after the 110 for
  // numbers: the value is in the middle of both.
  std::size_t inked = 0;
  for (std::size_t y = 48 + 128; y < 48 + 133; ++y) {
    if (picture.at(110 + 405, y).red < 0x80) ++inked;
  }
  EXPECT_GE(inked, 1U);
}

TEST(PlotDots, NamesThatHaveNoRoomBesideEachOtherStandAboveEachOther) {
  const std::string name(60, 'x');
  std::vector<PlotSeries> series(3, PlotSeries(name, "V"));
  for (PlotSeries& each : series) each.add(1, 1);
  // 60 letters of 8 pixels: one in a row of 850, so two more rows of 16.
  EXPECT_EQ(plot_dots(series, "names.log").height(), 348U + 32U);
}

TEST(PlotDots, NamesAndTitlesOfAnyBytesAndLengthDoNoHarm) {
  std::vector<PlotSeries> series = {PlotSeries(std::string(5000, '\xC3'), "\xFF"),
                                    PlotSeries("", "")};
  series[0].add(0, -1e308);
  series[0].add(1, 1e308);
  series[1].add(-1e15, 1e-320);
  const Picture picture = plot_dots(series, std::string(5000, '\xBC'));
  EXPECT_EQ(picture.width(), 960U);
}

TEST(PlotSeries, ATimeThatGoesBackAndNoNumberDoNoHarm) {
  PlotSeries series("level", "%");
  series.add(10, 1);
  series.add(5, 2);
  series.add(11, std::numeric_limits<double>::quiet_NaN());
  ASSERT_EQ(series.spans().size(), 1U);
  EXPECT_EQ(series.spans()[0].most, 2);
}

TEST(PlotSeries, MarksAreRoundNumbers) {
  const PlotAxis axis = plot_axis(20.3, 59.1, 5);
  EXPECT_EQ(axis.low, 20);
  EXPECT_EQ(axis.high, 60);
  EXPECT_EQ(axis.marks, (std::vector<double>{20, 30, 40, 50, 60}));
  const PlotAxis flat = plot_axis(5, 5, 5);
  EXPECT_LT(flat.low, 5);
  EXPECT_GT(flat.high, 5);
}

TEST(PlotSeries, AnAxisIsFiniteWhateverANodeSays) {
  for (const auto& [low, high] :
       {std::pair{-1.7e308, 1.7e308}, {0.0, 5e-324}, {1e-320, 1e-320}, {-5e-324, 0.0}}) {
    const PlotAxis axis = plot_axis(low, high, 5);
    EXPECT_TRUE(std::isfinite(axis.low) && std::isfinite(axis.high)) << low << ' ' << high;
    EXPECT_LT(axis.low, axis.high);
    EXPECT_LE(axis.marks.size(), 20U);
    EXPECT_GE(axis.marks.size(), 2U);
    EXPECT_TRUE(std::isfinite(axis.place(low))) << low;
  }
}

TEST(PlotSeries, ValuesOfOneUnitShareADiagram) {
  const std::vector<PlotSeries> series = {{"a", "V"}, {"b", "A"}, {"c", "V"}};
  const auto panels = plot_panels(series);
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0].size(), 2U);
}

TEST(PlotText, ALineRisesFromTheLowestDotToTheHighest) {
  PlotSeries series("a", "V");
  series.add(0, 0);
  series.add(1, 10);
  const std::string text = plot_text(std::vector{series}, 30, 10);
  EXPECT_TRUE(text.starts_with("a, V\n"));
  EXPECT_NE(text.find("       10 "), std::string::npos);
  // The last two dots are at the top of the right edge: U+2809.
  EXPECT_NE(text.find("\xE2\xA0\x89\n"), std::string::npos) << text;
}

}  // namespace plot_series_test
}  // namespace canvoy::tools
