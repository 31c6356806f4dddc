// Oddities of the files and times of timetables, each as a small feed: the resulting drive of the
// bus, or the reason of the refusal. Expected results follow from the GTFS Schedule reference
// (gtfs.org) and the CSV of RFC 4180; the kinds are those of the notices of the canonical
// validator, with their names.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/tools/play/feed_oddities_test.hpp"

namespace canvoy::tools::feed_oddities_test {
namespace {

const std::vector<Oddity>& file_oddities() {
  static const std::vector<Oddity> all = {
      {"as it should be", {}, as_ever},
      {"a byte order mark", {with("stops.txt", "\xEF\xBB\xBF" + town()["stops.txt"])}, as_ever},
      {"ends of lines of Windows",
       {with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence\r\n"
             "t1,8:00:00,8:00:00,a,1\r\nt1,8:05:00,8:05:00,b,2\r\nt1,8:10:00,8:10:00,c,3\r\n")},
       as_ever},
      {"a last line without its end",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,c,3")},
       as_ever},
      {"empty_row: rows without anything",
       {times("\nt1,8:00:00,8:00:00,a,1\n\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,c,3\n\n")},
       as_ever},
      {"leading_or_trailing_whitespaces",
       {times("t1 , 8:00:00,8:00:00 ,a, 1\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,\tc,3\n")},
       as_ever},
      {"names of columns in quotation marks",
       {with("stops.txt",
             "\"stop_id\",\"stop_name\",\"stop_lat\",\"stop_lon\"\n\"a\",A,50.1,8.5\n"
             "b,B,50.11,8.51\nc,C,50.12,8.52\n")},
       as_ever},
      {"unknown_column, and another order",
       {with("stops.txt",
             "stop_lon,mayor,stop_lat,stop_id\n8.5,x,50.1,a\n8.51,,50.11,b\n"
             "8.52,,50.12,c\n")},
       as_ever},
      {"commas at the ends of rows",
       {times("t1,8:00:00,8:00:00,a,1,,\nt1,8:05:00,8:05:00,b,2,\nt1,8:10:00,8:10:00,c,3,\n")},
       as_ever},
      {"unknown_file", {with("mayors.txt", "\x01\x02")}, as_ever},
      {"invalid_row_length: a text with a comma without quotation marks",
       {stop("a,Market, old,50.1,8.5\n")},
       "feed/stops.txt line 2: 5 fields, and 4 columns; is a text with commas without quotation "
       "marks?"},
      {"csv_parsing_failed: a quotation mark that nothing closes",
       {with("stops.txt", stops_head + "a,\"Market,50.1,8.5\n")},
       "feed/stops.txt line 2: the file ends within quotation marks"},
      {"duplicated_column",
       {with("stops.txt", "stop_id,stop_id,stop_lat,stop_lon\na,a,50.1,8.5\n")},
       "feed/stops.txt line 1: stop_id: the column is there twice"},
      {"missing_required_column",
       {with("stops.txt", "stop_id,stop_name,stop_lat\na,A,50.1\n")},
       "feed/stops.txt line 2: stop_lon: the column is missing"},
      {"empty_column_name",
       {with("stops.txt",
             "stop_id,,stop_name,stop_lat,stop_lon\na,,A,50.1,8.5\nb,,B,50.11,8.51\n"
             "c,,C,50.12,8.52\n")},
       as_ever},
      {"non_ascii_or_non_printable_char in an id",
       {stop("\xC3\xA4,Market,50.1,8.5\n"),
        times("t1,8:00:00,8:00:00,\xC3\xA4,1\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,c,3\n")},
       "42 \xC3\xA4 8:00 > Pier b 8:05 c 8:10"},
      {"files that are not read, with anything in them: fares, pathways, transfers and others",
       {with("fare_attributes.txt", "\x01,\""), with("fare_rules.txt", "\x01,\""),
        with("fare_media.txt", "\x01,\""), with("fare_products.txt", "\x01,\""),
        with("fare_transfer_rules.txt", "\x01,\""), with("timeframes.txt", "\x01,\""),
        with("areas.txt", "\x01,\""), with("networks.txt", "\x01,\""),
        with("pathways.txt", "\x01,\""), with("levels.txt", "\x01,\""),
        with("transfers.txt", "\x01,\""), with("translations.txt", "\x01,\""),
        with("attributions.txt", "\x01,\""), with("booking_rules.txt", "\x01,\""),
        with("location_groups.txt", "\x01,\""), with("locations.geojson", "{")},
       as_ever},
      {"fields that are not read: colours, addresses, languages, descriptions",
       {with("agency.txt",
             "agency_id,agency_name,agency_url,agency_timezone,agency_lang,agency_phone,"
             "agency_email\nT,Town,none,Europe/Berlin,zz-,x,none\n"),
        with("routes.txt",
             "route_id,agency_id,route_short_name,route_long_name,route_type,route_color,"
             "route_text_color,route_url,route_desc\nr1,T,42,42 Town,3,red,red,none,42\n")},
       as_ever},
      {"start_and_end_range_out_of_order of feed_info.txt, "
       "feed_info_lang_and_agency_lang_mismatch, "
       "more_than_one_entity",
       {with("feed_info.txt",
             "feed_publisher_name,feed_publisher_url,feed_lang,feed_start_date,feed_end_date\n"
             "X,none,xx,20300101,20290101\nY,none,yy,,\n")},
       as_ever},
      {"invalid_date of feed_info.txt",
       {with("feed_info.txt", "feed_start_date,feed_end_date\n2030-01-01,\n")},
       "feed/feed_info.txt line 2: feed_start_date: '2030-01-01' is no date as 20261123"},
      {"missing_calendar_and_calendar_date_files",
       {with("calendar.txt", "")},
       "feed/calendar.txt line 1: empty; the names of its columns are missing"},
      {"empty_file",
       {with("trips.txt", "")},
       "feed/trips.txt line 1: empty; the names of its columns are missing"},
      {"a file in UTF-16",
       {with("stops.txt", std::string("\xFF\xFE"
                                      "s\0",
                                      4))},
       "feed/stops.txt line 1: the text is UTF-16; save it as UTF-8"},
  };
  return all;
}

const std::vector<Oddity>& time_oddities() {
  static const std::vector<Oddity> all = {
      {"a trip over midnight",
       {times("t1,23:58:00,23:58:00,a,1\nt1,24:03:00,24:03:00,b,2\nt1,24:08:00,24:08:00,c,3\n")},
       "42 a 23:58 > Pier b 24:03 c 24:08"},
      {"a day of service that begins at night",
       {times("t1,26:00:00,26:00:00,a,1\nt1,26:10:00,26:10:00,c,2\n")},
       "42 a 26:00 > Pier c 26:10"},
      {"stop_time_with_arrival_before_previous_departure_time: midnight as 0:03",
       {times("t1,23:58:00,23:58:00,a,1\nt1,0:03:00,0:03:00,b,2\n")},
       "feed/stop_times.txt line 3: arrival_time: before the stop before it"},
      {"invalid_time: without seconds",
       {times("t1,08:00,08:00,a,1\n")},
       "feed/stop_times.txt line 2: arrival_time: '08:00' is no time as 08:05:00"},
      {"invalid_time: 60 minutes",
       {times("t1,8:60:00,8:60:00,a,1\n")},
       "feed/stop_times.txt line 2: arrival_time: '8:60:00' is no time as 08:05:00"},
      {"missing_trip_edge: the first without a time",
       {times("t1,,,a,1\nt1,8:05:00,8:05:00,b,2\n")},
       "feed/stop_times.txt line 2: arrival_time: the ends of a trip must have one"},
      {"missing_trip_edge: the last without a time",
       {times("t1,8:00:00,8:00:00,a,1\nt1,,,b,2\n")},
       "feed/stop_times.txt line 3: arrival_time: the ends of a trip must have one"},
      {"a stop without a time, halfway between two",
       {times("t1,8:00:00,8:00:00,a,1\nt1,,,b,2\nt1,8:10:00,8:10:00,c,3\n")},
       as_ever},
      {"stop_time_with_only_arrival_or_departure_time",
       {times("t1,,8:00:00,a,1\nt1,8:05:00,,b,2\nt1,8:10:00,,c,3\n")},
       as_ever},
      {"all at the same minute",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:00:00,8:00:00,b,2\nt1,8:00:00,8:00:00,c,3\n")},
       "42 a 8:00 > Pier b 8:00 c 8:00"},
      {"fast_travel_between_consecutive_stops: it is late then",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:00:01,8:00:01,b,2\nt1,8:00:02,8:00:02,c,3\n")},
       "42 a 8:00 > Pier b 8:00:01 c 8:00:02"},
      {"a stop where it stands",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:07:30,b,2\nt1,8:10:00,8:10:00,c,3\n")},
       "42 a 8:00 > Pier b 8:05-8:07:30 c 8:10"},
      {"departure before arrival",
       {times("t1,8:00:00,7:59:00,a,1\n")},
       "feed/stop_times.txt line 2: departure_time: before the arrival"},
      {"rows in any order, sequences with gaps and from 0 on",
       {times("t1,8:10:00,8:10:00,c,70\nt1,8:00:00,8:00:00,a,0\nt1,8:05:00,8:05:00,b,9\n")},
       as_ever},
      {"duplicate_key: a sequence twice",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:05:00,b,1\n")},
       "feed/stop_times.txt line 3: stop_sequence: the trip has it twice"},
      {"number_out_of_range: a sequence below 0",
       {times("t1,8:00:00,8:00:00,a,-1\n")},
       "feed/stop_times.txt line 2: stop_sequence: '-1' is no whole number from 0 to 4294967295"},
      {"stop_time_with_only_arrival_or_departure_time",
       {times("t1,,8:00:00,a,1\nt1,8:05:00,,b,2\nt1,8:10:00,,c,3\n")},
       as_ever},
      {"stop_time_timepoint_without_times: by distance",
       {with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence,timepoint\n"
             "t1,8:00:00,8:00:00,a,1,1\nt1,,,b,2,1\nt1,8:10:00,8:10:00,c,3,\n")},
       as_ever},
      {"unexpected_enum_value: a timepoint of 7",
       {with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence,timepoint\n"
             "t1,8:00:00,8:00:00,a,1,7\n")},
       "feed/stop_times.txt line 2: timepoint: '7' is no whole number from 0 to 1"},
      {"unexpected_enum_value: a pickup_type of 9",
       {with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence,pickup_type\n"
             "t1,8:00:00,8:00:00,a,1,9\n")},
       "feed/stop_times.txt line 2: pickup_type: '9' is no whole number from 0 to 3"},
      {"invalid_integer: a sequence that is a letter",
       {times("t1,8:00:00,8:00:00,a,x\n")},
       "feed/stop_times.txt line 2: stop_sequence: 'x' is no whole number from 0 to 4294967295"},
      {"forbidden_continuous_pickup_drop_off",
       {with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence,continuous_pickup\n"
             "t1,8:00:00,8:00:00,a,1,9\nt1,8:05:00,8:05:00,b,2,0\nt1,8:10:00,8:10:00,c,3,\n")},
       as_ever},
      {"decreasing_or_equal_stop_time_distance",
       {with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence,shape_dist_traveled\n"
             "t1,8:00:00,8:00:00,a,1,5\nt1,8:05:00,8:05:00,b,2,5\nt1,8:10:00,8:10:00,c,3,1\n")},
       as_ever},
      {"overlapping_frequency: each departure once for each row",
       {with("frequencies.txt",
             "trip_id,start_time,end_time,headway_secs\nt1,9:00:00,9:20:00,1200\n"
             "t1,9:10:00,9:20:00,1200\n")},
       "42 a 9:00 > Pier b 9:05 c 9:10 | 42 a 9:10 > Pier b 9:15 c 9:20"},
      {"frequencies: each 20 minutes, the end not included",
       {with("frequencies.txt",
             "trip_id,start_time,end_time,headway_secs\nt1,9:00:00,9:40:00,1200\n")},
       "42 a 9:00 > Pier b 9:05 c 9:10 | 42 a 9:20 > Pier b 9:25 c 9:30"},
      {"start_and_end_range_equal: frequencies for no time",
       {with("frequencies.txt",
             "trip_id,start_time,end_time,headway_secs\nt1,9:00:00,9:00:00,60\n")},
       no_trip},
      {"start_and_end_range_out_of_order",
       {with("frequencies.txt",
             "trip_id,start_time,end_time,headway_secs\nt1,9:00:00,8:00:00,60\n")},
       "feed/frequencies.txt line 2: end_time: before start_time"},
      {"a headway of 0",
       {with("frequencies.txt",
             "trip_id,start_time,end_time,headway_secs\nt1,9:00:00,9:30:00,0\n")},
       "feed/frequencies.txt line 2: headway_secs: 0 or empty"},
  };
  return all;
}

TEST(FeedOddities, OfFiles) {
  expect_all(file_oddities());
}
TEST(FeedOddities, OfTimes) {
  expect_all(time_oddities());
}

/// A feed that is not refused is driven to its end.
TEST(FeedOddities, OfFilesAndTimesCanBeDriven) {
  EXPECT_GT(expect_driven(file_oddities()) + expect_driven(time_oddities()), 20U);
}

}  // namespace
}  // namespace canvoy::tools::feed_oddities_test
