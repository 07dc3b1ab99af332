#include "seismic/time_text.h"

#include <gtest/gtest.h>

namespace dougong::seismic {
namespace {

TEST(TimeText, ReadsTheSpellingsOfHeaders) {
  using enum DateOrder;
  EXPECT_EQ(iso_time_in("2018/01/24 19:51:43", year_month_day, "+09:00"), "2018-01-24T19:51:43.000+09:00");
  EXPECT_EQ(iso_time_in("20190728_160919.870", year_month_day, "Z"), "2019-07-28T16:09:19.870Z");
  EXPECT_EQ(iso_time_in("2018/11/30 17:29:39.137 UTC (Q=5)", year_month_day), "2018-11-30T17:29:39.137");
  EXPECT_EQ(iso_time_in("8/24/14, 10:20:33.0 UTC (GPS)", month_day_year), "2014-08-24T10:20:33.000");
  EXPECT_EQ(iso_time_in("01/17/94, 12:31:04.1 UTC", month_day_year), "1994-01-17T12:31:04.100");
  EXPECT_EQ(iso_time_in("20/07/2017 22:30:59.000000 (GMT)", day_month_year), "2017-07-20T22:30:59.000");
  EXPECT_EQ(iso_time_in("2013-04-20 8:2:46 BTM", year_month_day), "2013-04-20T08:02:46.000");
}

TEST(TimeText, CarriesSecondsOverDaysAndYears) {
  EXPECT_EQ(iso_time_in("2018/01/01 00:00:05", DateOrder::year_month_day, "", -15.0),
            "2017-12-31T23:59:50.000");
  EXPECT_EQ(iso_time(2016, 2, 28, 23, 59, 61.5), "2016-02-29T00:00:01.500");
  EXPECT_EQ(iso_time_of_day(2019, 187, 3, 19, 52.25, "Z"), "2019-07-06T03:19:52.250Z");
}

TEST(TimeText, IsEmptyForWhatIsNoTime) {
  for (const char* text : {"", "unknown", "2018/13/01 00:00:00", "2018/02/30 00:00:00",
                           "99999999999999999999/1/1 0:0:0", "2018/01/24"})
    EXPECT_EQ(iso_time_in(text, DateOrder::year_month_day), "") << text;
  EXPECT_EQ(iso_time_of_day(2019, 0, 0, 0, 0.0), "");
  EXPECT_EQ(iso_time(2019, 1, 1, 25, 0, 0.0), "");
  EXPECT_EQ(iso_time(2019, 1, 1, 0, 0, 1e300), "");
}

TEST(TimeText, ShiftsBetweenZones) {
  EXPECT_EQ(shifted_time("2011-03-11T14:47:13.000+09:00", 0.0), "2011-03-11T05:47:13.000");
  EXPECT_EQ(shifted_time("2011-03-11T05:47:13.000Z", 9 * 3600.0), "2011-03-11T14:47:13.000");
  EXPECT_EQ(shifted_time("2011-03-11T05:47:13.000-03:30", 0.0), "2011-03-11T09:17:13.000");
  EXPECT_EQ(shifted_time("", 0.0), "");
}

}  // namespace
}  // namespace dougong::seismic
